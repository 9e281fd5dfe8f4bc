#include "core/surface/playback/played_surface.hpp"

#include "core/surface/builder/emptiness.hpp"
#include "core/surface/moving/moving_builder.hpp"
#include "core/surface/moving/surface_history.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace wakesurf::core {

struct PlayedSurface::State {
    explicit State(SurfaceHistory kept)
        : history(std::move(kept)), from(plan().parameters.from),
          sign(time_sign(plan().parameters)) {}

    const SurfacePlan& plan() const { return history.surface().state().plan->request.plan; }

    Result<KeyedMesh> mesh_at(double age, const std::stop_token& stop, const WorkPart& work);

    SurfaceHistory history;
    double from;
    double sign;                                           ///< which way time runs
    double most = std::numeric_limits<double>::infinity(); ///< readable age
    std::string stopped{};
};

PlayedSurface::PlayedSurface(std::unique_ptr<State> state) : state_(std::move(state)) {}

PlayedSurface::~PlayedSurface() = default;
PlayedSurface::PlayedSurface(PlayedSurface&&) noexcept = default;
PlayedSurface& PlayedSurface::operator=(PlayedSurface&&) noexcept = default;

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
    return PlayedSurface(std::make_unique<State>(SurfaceHistory(std::move(*moving), budget_bytes)));
}

void PlayedSurface::limit(std::size_t budget_bytes) {
    state_->history.limit(budget_bytes);
}

std::size_t PlayedSurface::bytes() const {
    return state_->history.bytes() + state_->history.surface().state().bytes();
}

Result<KeyedMesh>
PlayedSurface::State::mesh_at(double age, const std::stop_token& stop, const WorkPart& work) {
    for (;;) {
        const double reach = std::min(age, most);
        const double end = history.surface().end_time();
        const double time = from + sign * reach;
        auto mesh = history.at(sign * (time - end) > 0.0 ? end : time, stop, work);
        if (mesh || !mesh.error().readable_until)
            return mesh;
        const double readable = sign * (*mesh.error().readable_until - from);
        if (!(readable > 0.0 && readable < reach))
            return mesh;
        most = readable;
        stopped = mesh.error().message;
    }
}

Result<PlayedSurface::Shown>
PlayedSurface::at(double age, const std::stop_token& stop, const WorkPart& work) {
    auto mesh = state_->mesh_at(age, stop, work);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const double time = mesh->time;
    Shown shown{std::move(*mesh), state_->history.statistics(), time};
    if (state_->sign < 0.0)
        mirror_cells(shown.mesh.mesh);
    SurfaceStatistics& s = shown.statistics;
    count(s, shown.mesh.mesh);
    s.seconds.total = s.seconds.load + s.seconds.advect + s.seconds.refine;
    if (age > state_->most)
        s.stopped = state_->stopped;
    auto empty = why_empty(state_->plan(), shown.mesh.mesh, s, stop);
    if (!empty)
        return tl::unexpected(empty.error());
    s.empty = std::move(*empty);
    return shown;
}

} // namespace wakesurf::core
