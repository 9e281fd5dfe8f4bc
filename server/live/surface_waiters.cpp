#include "server/live/surface_waiters.hpp"

#include "server/base/limits.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

std::uint64_t SurfaceWaiters::add(std::uint32_t epoch,
                                  std::chrono::milliseconds patience,
                                  std::function<SurfaceOutcome()> give_up,
                                  Waiter waiter,
                                  bool checked) {
    if (waiting_.size() >= limits::waiters) {
        waiter(core::over_limit(limits::waiters,
                                "too many calls of `surface.wait` are open for this surface",
                                "let some of them finish first"));
        return 0;
    }
    const std::uint64_t id = next_++;
    auto timer = loop_.after(patience, [weak = weak_from_this(), id] {
        if (const auto self = weak.lock())
            self->give_up(id);
    });
    waiting_.push_back(
        {id, epoch, std::move(waiter), std::move(give_up), std::move(timer), checked});
    return id;
}

void SurfaceWaiters::forget(std::uint64_t ticket) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [&](const Waiting& each) { return each.id == ticket; });
    if (found == waiting_.end())
        return;
    const Waiting ended = std::move(*found); // destroyed last: it may use the surface
    waiting_.erase(found);
}

void SurfaceWaiters::answer(std::uint32_t epoch, const core::Result<SurfaceOutcome>& outcome) {
    const auto later =
        std::stable_partition(waiting_.begin(), waiting_.end(), [&](const Waiting& each) {
            return each.epoch > epoch || (each.checked && outcome && outcome->checks_pending);
        });
    std::vector<Waiting> ready(std::make_move_iterator(later),
                               std::make_move_iterator(waiting_.end()));
    waiting_.erase(later, waiting_.end());
    for (const Waiting& each : ready)
        each.waiter(outcome);
}

void SurfaceWaiters::give_up(std::uint64_t id) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [&](const Waiting& each) { return each.id == id; });
    if (found == waiting_.end())
        return;
    const Waiting waiting = std::move(*found);
    waiting_.erase(found);
    SurfaceOutcome so_far = waiting.give_up();
    if (!waiting.checked || !so_far.checks_pending)
        so_far.complete = false; // the epoch asked for is not complete
    waiting.waiter(std::move(so_far));
}

} // namespace wakesurf::server
