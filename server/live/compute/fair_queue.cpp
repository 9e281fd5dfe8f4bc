#include "server/live/compute/fair_queue.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

bool FairQueue::ready(const Line& line) const {
    return !line.jobs.empty() && line.running < rules_.at_once;
}

void FairQueue::push(const std::string& session, Job job) {
    Line& line = lines_[session];
    const bool had_turn = ready(line);
    line.jobs.push_back(std::move(job));
    ++waiting_;
    if (!had_turn && ready(line))
        turns_.push_back(session);
}

std::optional<FairQueue::Turn> FairQueue::pop(Takes which, Time now) {
    if (which == Takes::Any)
        return turns_.empty() ? std::nullopt : std::optional(take(turns_.begin()));
    const auto busy = std::max<std::size_t>(2, use_.busier_than(rules_.busy, now));
    const double limit = 2 * rules_.light_share / static_cast<double>(busy);
    double least = limit;
    auto found = turns_.end();
    for (auto each = turns_.begin(); each != turns_.end(); ++each) {
        const double used = lines_.at(*each).running < rules_.light_at_once
                                ? use_.share(*each, now)
                                : std::max(limit, use_.share(*each, now));
        if (which == Takes::NotLight && used >= limit)
            return take(each);
        if (which == Takes::Light && used < least) {
            least = used;
            found = each;
        }
    }
    return found == turns_.end() ? std::nullopt : std::optional(take(found));
}

FairQueue::Turn FairQueue::take(std::deque<std::string>::iterator session) {
    Turn turn{std::move(*session), {}};
    turns_.erase(session);
    Line& line = lines_.at(turn.session);
    turn.job = std::move(line.jobs.front());
    line.jobs.pop_front();
    ++line.running;
    --waiting_;
    if (ready(line))
        turns_.push_back(turn.session);
    return turn;
}

void FairQueue::done(const std::string& session, double seconds, Time now) {
    use_.add(session, seconds, now);
    const auto found = lines_.find(session);
    Line& line = found->second;
    const bool had_turn = ready(line);
    --line.running;
    if (!had_turn && ready(line))
        turns_.push_back(session);
    else if (line.jobs.empty() && line.running == 0)
        lines_.erase(found);
}

} // namespace wakesurf::server
