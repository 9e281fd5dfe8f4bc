#include "server/live/compute/fair_queue.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace wakesurf::server {

bool FairQueue::ready(const Line& line) const {
    return !line.jobs.empty() && line.running < at_once_;
}

/// A session that did not compete for a while is not owed what others were served meanwhile.
void FairQueue::compete(Line& line) {
    line.served = std::max(line.served, now_);
}

void FairQueue::push(const std::string& session, Job job) {
    Line& line = lines_[session];
    const bool competed = ready(line);
    line.jobs.push_back(std::move(job));
    ++waiting_;
    if (competed || !ready(line))
        return;
    compete(line);
    line.turn = ++turns_;
}

std::optional<FairQueue::Turn> FairQueue::pop() {
    auto next = lines_.end();
    const auto rank = [](const Line& line) { return std::tie(line.served, line.turn); };
    for (auto each = lines_.begin(); each != lines_.end(); ++each)
        if (ready(each->second) &&
            (next == lines_.end() || rank(each->second) < rank(next->second)))
            next = each;
    if (next == lines_.end())
        return std::nullopt;
    Line& line = next->second;
    Turn turn{next->first, std::move(line.jobs.front())};
    line.jobs.pop_front();
    ++line.running;
    --waiting_;
    line.turn = ++turns_;
    now_ = line.served;
    return turn;
}

void FairQueue::done(const std::string& session, double seconds) {
    Line& line = lines_.at(session);
    --line.running;
    line.served += seconds;
    compete(line);
    forget_idle();
}

/// Where nothing runs or waits no debt is left: nobody is there to whom it is owed.
void FairQueue::forget_idle() {
    const auto idle = [](const auto& each) {
        return each.second.jobs.empty() && each.second.running == 0;
    };
    const bool all = std::ranges::all_of(lines_, idle);
    std::erase_if(lines_, [&](const auto& each) {
        return idle(each) && (all || each.second.served <= now_);
    });
}

} // namespace wakesurf::server
