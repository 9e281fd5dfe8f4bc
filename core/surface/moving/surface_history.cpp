#include "core/surface/moving/surface_history.hpp"

#include <sstream>

namespace wakesurf::core {

SurfaceHistory::SurfaceHistory(MovingSurface surface, std::size_t budget_bytes)
    : surface_(std::move(surface)), start_(surface_.time()),
      direction_(surface_.end_time() < start_ ? -1.0 : 1.0), budget_(budget_bytes) {
    keep();
}

void SurfaceHistory::keep() {
    if (surface_.state().steps % every_ != 0)
        return;
    // The first checkpoint is always kept. This one would not fit beside it, so it is not even copied.
    if (!checkpoints_.empty() && surface_.state().bytes() > budget_)
        return;
    const auto [place, fresh] =
        checkpoints_.try_emplace(since_start(surface_.time()), surface_.state());
    if (!fresh)
        return;
    bytes_ += place->second.bytes();
    thin();
}

void SurfaceHistory::limit(std::size_t budget_bytes) {
    budget_ = budget_bytes;
    thin();
}

void SurfaceHistory::thin() {
    while (bytes_ > budget_ && checkpoints_.size() > 1) {
        every_ *= 2;
        for (auto it = checkpoints_.begin(); it != checkpoints_.end();) {
            if (it->second.steps % every_ == 0) {
                ++it;
                continue;
            }
            bytes_ -= it->second.bytes();
            it = checkpoints_.erase(it);
        }
    }
}

/// Goes to the last state of the uninterrupted run that is not after `time`.
Result<void> SurfaceHistory::go_to(double time, const std::stop_token& stop, const WorkPart& work) {
    const auto after = checkpoints_.upper_bound(since_start(time));
    const MovingState& nearest = std::prev(after)->second;
    if (torn_ || since_start(surface_.time()) > since_start(time) ||
        since_start(nearest.mesh.time) > since_start(surface_.time()))
        surface_.restore(nearest);
    torn_ = false;
    while (since_start(surface_.next_time(surface_.end_time(), stop)) <= since_start(time) &&
           surface_.time() != surface_.end_time()) {
        if (auto stepped = surface_.step(surface_.end_time(), stop, work, time); !stepped) {
            torn_ = true; // nothing is copied now: there may be no memory for it
            return stepped;
        }
        keep();
    }
    return {};
}

Result<KeyedMesh> SurfaceHistory::at(double time, std::stop_token stop, const WorkPart& work) {
    if (!(since_start(time) >= 0.0 && since_start(time) <= since_start(surface_.end_time()))) {
        std::ostringstream text;
        text << "time " << time << " is outside the surface's " << start_ << " to "
             << surface_.end_time();
        return fail(Error::Code::OutOfTime, text.str(), "choose a time between them");
    }
    // The first checkpoint stays whatever the budget for them.
    const WorkPart here = work.above(bytes_ - std::min(bytes_, budget_));
    if (auto there = go_to(time, stop, here); !there)
        return tl::unexpected(there.error());
    work.came_to(time, start_);
    const MovingMesh& mesh = surface_.state().mesh;
    const std::size_t on_the_way = memory_while_moving(mesh);
    if (auto room = here.holds(memory_of(mesh) + on_the_way + shown_bytes * mesh.vertices.slots());
        !room)
        return tl::unexpected(room.error());
    statistics_ = surface_.statistics();
    const auto shown = [&]() -> Result<KeyedMesh> {
        if (surface_.time() == time)
            return surface_.mesh();
        MovingSurface further = surface_; // the last part of the way becomes no checkpoint
        return further.advance_to(time, stop, here.quietly().above(memory_of(mesh))).map([&] {
            statistics_ = further.statistics();
            statistics_.seconds = surface_.statistics().seconds;
            return further.mesh();
        });
    }();
    here.gives_back(on_the_way);
    return shown;
}

} // namespace wakesurf::core
