#include "server/live/compute/fair_queue.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr double nothing = 1e-4; ///< s

double seconds_of(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

double RecentUse::at(const Use& use, Time now) const {
    return use.seconds * std::exp(-seconds_of(now - use.since) / seconds_of(memory_));
}

void RecentUse::add(const std::string& session, double seconds, Time now) {
    Use& use = uses_[session];
    use = {at(use, now) + seconds, now};
    if (now - swept_ > 40 * memory_)
        forget_idle(now);
}

double RecentUse::share(const std::string& session, Time now) const {
    const auto found = uses_.find(session);
    return found == uses_.end() ? 0.0 : at(found->second, now) / seconds_of(memory_);
}

std::size_t RecentUse::busier_than(double share, Time now) const {
    return static_cast<std::size_t>(
        std::count_if(uses_.begin(), uses_.end(), [&](const auto& each) {
            return at(each.second, now) > share * seconds_of(memory_);
        }));
}

void RecentUse::forget_idle(Time now) {
    swept_ = now;
    std::erase_if(uses_, [&](const auto& each) { return at(each.second, now) < nothing; });
}

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
