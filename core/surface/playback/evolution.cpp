#include "core/surface/playback/evolution.hpp"

#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/level/level_surface.hpp"
#include "core/surface/playback/growing_mesh.hpp"
#include "core/surface/playback/played_surface.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace wakesurf::core {

bool moves(const SurfaceParameters& p) {
    return p.kind != SurfaceKind::Stream && p.from != p.to;
}

double age_at(const SurfaceParameters& p, std::optional<double> time) {
    const double most = time_span(p);
    return time ? std::clamp(time_sign(p) * (*time - p.from), 0.0, most) : most;
}

namespace {

/// Returns a mesh whose ids are its indices.
KeyedMesh numbered(QuadComplex mesh, double time) {
    KeyedMesh keyed{std::move(mesh), {}, {}, time};
    keyed.vertex_id.resize(keyed.mesh.vertices());
    std::iota(keyed.vertex_id.begin(), keyed.vertex_id.end(), 0U);
    keyed.cell_id.resize(keyed.mesh.cells.size());
    std::iota(keyed.cell_id.begin(), keyed.cell_id.end(), 0U);
    return keyed;
}

} // namespace

struct Evolution::Held {
    SurfacePlan plan;
    const Clock* clock;
    std::optional<GrowingMesh> growing{};
    SurfaceStatistics grown{}; ///< of all of it
    std::optional<PlayedSurface> played{};

    Result<State> grow(double age, double time) const;
    Result<State> play(double age, const std::stop_token& stop, const WorkPart& work);
    Result<State> level(double time, const std::stop_token& stop, const WorkPart& work) const;
};

Evolution::Evolution(std::unique_ptr<Held> held) : held_(std::move(held)) {}

Evolution::~Evolution() = default;
Evolution::Evolution(Evolution&&) noexcept = default;
Evolution& Evolution::operator=(Evolution&&) noexcept = default;

Result<Evolution> Evolution::start(const SurfacePlan& plan,
                                   const Clock& clock,
                                   const std::stop_token& stop,
                                   const WorkPart& work) {
    auto held = std::make_unique<Held>(Held{plan, &clock});
    switch (plan.parameters.kind) {
    case SurfaceKind::Stream:
    case SurfaceKind::Path: {
        auto whole = build_surface(plan, stop, clock, work);
        if (!whole)
            return tl::unexpected(whole.error());
        if (auto room = work.takes(2 * memory_of(whole->mesh)); !room)
            return tl::unexpected(room.error());
        held->growing.emplace(whole->mesh, time_span(plan.parameters));
        held->grown = std::move(whole->statistics);
        break;
    }
    case SurfaceKind::Streak:
    case SurfaceKind::Time: {
        auto begun = PlayedSurface::start(plan, 0, clock, stop, work); // nothing to step back to
        if (!begun)
            return tl::unexpected(begun.error());
        held->played = std::move(*begun);
        break;
    }
    case SurfaceKind::Level:
        break;
    }
    return Evolution(std::move(held));
}

Result<Evolution::State>
Evolution::at(double time, const std::stop_token& stop, const WorkPart& work) {
    const SurfaceParameters& p = held_->plan.parameters;
    const double age = age_at(p, time);
    const double shown = p.from + time_sign(p) * age;
    if (held_->growing)
        return held_->grow(age, shown);
    if (held_->played)
        return held_->play(age, stop, work);
    return held_->level(shown, stop, work);
}

Result<Evolution::State> Evolution::Held::grow(double age, double time) const {
    Surface shown{growing->at(age).mesh, grown, {}};
    shown.statistics.quads = shown.mesh.cells.size();
    shown.statistics.vertices = shown.mesh.vertices();
    shown.statistics.error = stated_error(shown.mesh, shown.statistics.separation);
    auto times = vertex_times(shown, plan.parameters);
    return State{numbered(std::move(shown.mesh), time), std::move(shown.statistics),
                 std::move(times)};
}

Result<Evolution::State>
Evolution::Held::play(double age, const std::stop_token& stop, const WorkPart& work) {
    auto shown = played->at(age, stop, work);
    if (!shown)
        return tl::unexpected(shown.error());
    std::vector<double> times(shown->mesh.mesh.vertices(), shown->time);
    return State{std::move(shown->mesh), std::move(shown->statistics), std::move(times)};
}

Result<Evolution::State>
Evolution::Held::level(double time, const std::stop_token& stop, const WorkPart& work) const {
    return build_level_surface(plan, time, stop, *clock, work).map([&](Surface&& level) {
        std::vector<double> times(level.mesh.vertices(), time);
        return State{numbered(std::move(level.mesh), time), std::move(level.statistics),
                     std::move(times)};
    });
}

} // namespace wakesurf::core
