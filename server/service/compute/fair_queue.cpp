#include "server/service/compute/fair_queue.hpp"

#include <utility>

namespace wakesurf::server {

void FairQueue::push(const std::string& session, Job job) {
    Line& line = lines_[session];
    line.jobs.push_back(std::move(job));
    ++waiting_;
    const bool blocked = one_a_session_ && line.running > 0;
    if (line.jobs.size() == 1 && !blocked)
        turns_.push_back(session);
}

std::optional<FairQueue::Turn> FairQueue::pop() {
    if (turns_.empty())
        return std::nullopt;
    return take(turns_.begin());
}

std::optional<FairQueue::Turn> FairQueue::pop_least(const Used& used, double most) {
    auto least = turns_.end();
    for (auto each = turns_.begin(); each != turns_.end(); ++each)
        if (const double here = used(*each); here < most) {
            most = here;
            least = each;
        }
    if (least == turns_.end())
        return std::nullopt;
    return take(least);
}

std::optional<FairQueue::Turn> FairQueue::take(std::deque<std::string>::iterator session) {
    Turn turn{std::move(*session), {}};
    turns_.erase(session);
    Line& line = lines_.at(turn.session);
    turn.job = std::move(line.jobs.front());
    line.jobs.pop_front();
    ++line.running;
    --waiting_;
    if (!line.jobs.empty() && !one_a_session_)
        turns_.push_back(turn.session);
    return turn;
}

void FairQueue::done(const std::string& session) {
    const auto found = lines_.find(session);
    Line& line = found->second;
    --line.running;
    if (!line.jobs.empty()) {
        if (one_a_session_)
            turns_.push_back(session);
    } else if (line.running == 0) {
        lines_.erase(found);
    }
}

} // namespace wakesurf::server
