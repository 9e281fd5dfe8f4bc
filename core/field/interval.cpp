#include "core/field/interval.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace wakesurf::core {

namespace {

// Each is refused only after the cache's own patience is over. Newcomers may spoil a turn.
constexpr int most_turns = 4;

// Two callers of four fill a smaller cache: there, being refused (0.3 s) would be the rule.
constexpr std::size_t tight = 8;

} // namespace

Intervals::Intervals(std::shared_ptr<TimeStepCache> cache,
                     std::vector<std::size_t> steps,
                     Between between)
    : cache_(std::move(cache)), steps_(std::move(steps)), between_(between),
      tight_(!cache_->bricks() &&
             cache_->status().budget < tight * cache_->source().bytes_per_step()) {
    const std::vector<double>& all = cache_->source().times();
    if (steps_.empty()) {
        steps_.resize(all.size());
        std::iota(steps_.begin(), steps_.end(), std::size_t{0});
    }
    for (const std::size_t step : steps_)
        times_.push_back(all[step]);
}

std::size_t Intervals::at(double time) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    const auto index =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - times_.begin() - 1, 0));
    return std::min(index, times_.size() < 2 ? 0 : times_.size() - 2);
}

std::optional<double> Intervals::next(double time, double sign) const {
    if (times_.size() < 2)
        return std::nullopt;
    if (sign > 0.0) {
        const auto next = std::upper_bound(times_.begin(), times_.end(), time);
        return next == times_.end() ? std::nullopt : std::optional(*next);
    }
    const auto here = std::lower_bound(times_.begin(), times_.end(), time);
    return here == times_.begin() ? std::nullopt : std::optional(*std::prev(here));
}

std::vector<std::size_t> Intervals::every(std::size_t stride, std::size_t k) const {
    std::vector<std::size_t> steps;
    for (std::size_t i = 0; i < steps_.size(); ++i)
        if (i % stride == k % stride || i == 0 || i + 1 == steps_.size())
            steps.push_back(steps_[i]);
    return steps;
}

Result<Interval> Intervals::acquire(std::size_t k, Needs needs, const std::stop_token& stop) const {
    Result<Interval> got;
    if (!tight_)
        got = try_acquire(k, needs, stop);
    if (!tight_ && (got || got.error().code != Error::Code::OverLimit))
        return got;
    {
        const std::stop_callback wake(stop, [this] { turn_over_.notify_all(); });
        std::unique_lock lock(mutex_);
        for (auto seen = turn_over_.notifications(); turn_taken_ && !stop.stop_requested();
             seen = turn_over_.notifications())
            turn_over_.wait(lock, seen);
        if (turn_taken_)
            return fail(Error::Code::Cancelled, "waiting for time-steps was cancelled");
        turn_taken_ = true;
    }
    for (int turn = 0; turn < most_turns; ++turn) {
        got = try_acquire(k, needs, stop);
        if (got || got.error().code != Error::Code::OverLimit)
            break;
    }
    {
        const std::scoped_lock lock(mutex_);
        turn_taken_ = false;
    }
    turn_over_.notify_one();
    return got;
}

Result<Interval>
Intervals::try_acquire(std::size_t k, Needs needs, const std::stop_token& stop) const {
    Interval interval;
    const std::size_t count = steps_.size();
    std::size_t held = 0;
    const auto take = [&](std::size_t index,
                          std::shared_ptr<const TimeStep>& place) -> Result<void> {
        auto step = cache_->acquire(steps_[index], stop, held);
        if (!step)
            return tl::unexpected(step.error());
        place = std::move(*step);
        ++held;
        return {};
    };
    const bool four = needs == Needs::Four || (needs == Needs::Both && between_ != Between::Linear);
    Result<void> taken;
    if (four && k > 0)
        taken = take(k - 1, interval.before);
    if (taken)
        taken = take(k, interval.first);
    if (taken && needs != Needs::First && k + 1 < count)
        taken = take(k + 1, interval.second);
    if (taken && four && k + 2 < count)
        taken = take(k + 2, interval.after);
    if (!taken)
        return tl::unexpected(taken.error());
    if (interval.second)
        interval.between = between_;
    if (cache_->bricks()) {
        std::vector<std::size_t> steps;
        for (const auto* step :
             {&interval.before, &interval.first, &interval.second, &interval.after})
            if (*step)
                steps.push_back((*step)->index);
        interval.missing = std::make_shared<MissingBricks>(cache_->bricks(), std::move(steps));
    }
    return interval;
}

} // namespace wakesurf::core
