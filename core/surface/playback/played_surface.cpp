#include "core/surface/playback/played_surface.hpp"

#include "core/surface/emptiness.hpp"
#include "core/surface/moving/shown_surface.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::core {

PlayedSurface::PlayedSurface(SurfaceHistory history)
    : history_(std::move(history)), from_(plan().parameters.from),
      sign_(time_sign(plan().parameters)) {}

Result<PlayedSurface> PlayedSurface::start(const SurfacePlan& plan,
                                           std::size_t budget_bytes,
                                           const Clock& clock,
                                           const std::stop_token& stop,
                                           const WorkPart& work) {
    auto moving = MovingSurface::start(plan, stop, clock, work);
    if (!moving)
        return tl::unexpected(moving.error());
    if (auto room = work.holds(2 * moving->state().bytes()); !room) // its start is kept
        return tl::unexpected(room.error());
    return PlayedSurface(SurfaceHistory(std::move(*moving), budget_bytes));
}

void PlayedSurface::limit(std::size_t budget_bytes) {
    history_.limit(budget_bytes);
}

std::size_t PlayedSurface::bytes() const {
    return history_.bytes() + history_.surface().state().bytes();
}

Result<KeyedMesh>
PlayedSurface::mesh_at(double age, const std::stop_token& stop, const WorkPart& work) {
    for (;;) {
        const double reach = std::min(age, most_);
        const double end = history_.surface().end_time();
        const double time = from_ + sign_ * reach;
        auto mesh = history_.at(sign_ * (time - end) > 0.0 ? end : time, stop, work);
        if (mesh || !mesh.error().readable_until)
            return mesh;
        const double readable = sign_ * (*mesh.error().readable_until - from_);
        if (!(readable > 0.0 && readable < reach))
            return mesh;
        most_ = readable;
        stopped_ = mesh.error().message;
    }
}

Result<PlayedSurface::Shown>
PlayedSurface::at(double age, const std::stop_token& stop, const WorkPart& work) {
    auto mesh = mesh_at(age, stop, work);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const double time = mesh->time;
    Shown shown{std::move(*mesh), history_.statistics(), time};
    if (sign_ < 0.0)
        mirror_cells(shown.mesh.mesh);
    SurfaceStatistics& s = shown.statistics;
    count(s, shown.mesh.mesh);
    s.seconds.total = s.seconds.load + s.seconds.advect + s.seconds.refine;
    if (age > most_)
        s.stopped = stopped_;
    auto empty = why_empty(plan(), shown.mesh.mesh, s, stop);
    if (!empty)
        return tl::unexpected(empty.error());
    s.empty = std::move(*empty);
    return shown;
}

} // namespace wakesurf::core
