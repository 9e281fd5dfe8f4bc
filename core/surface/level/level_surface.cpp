#include "core/surface/level/level_surface.hpp"

#include "core/surface/level/paired_triangles.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace wakesurf::core {

namespace {

/// A triangle while neighbours are paired, and what of the mesh comes from it.
constexpr std::size_t triangle_bytes = 160;

std::string listed_times(const std::vector<double>& times) {
    constexpr std::size_t most = 8;
    std::string out;
    for (std::size_t i = 0; i < std::min(most, times.size()); ++i)
        out += (i == 0 ? "" : ", ") + time_text(times[i]);
    return times.size() <= most ? out : out + ", ... " + time_text(times.back());
}

std::optional<Emptiness>
why_no_level(const SurfaceParameters& p, const LevelTriangles& found, double time) {
    if (!found.triangles.empty())
        return std::nullopt;
    const std::string at = p.from == p.to ? "" : " at t = " + time_text(time);
    if (!found.values)
        return Emptiness{Emptiness::Reason::NotFinite, *p.field + " has no values" + at,
                         found.times.empty()
                             ? "choose another field, or another time"
                             : *p.field + " has values at t = " + listed_times(found.times) +
                                   ": choose such a time, or another field"};
    const auto [lo, hi] = found.range;
    const std::string range = time_text(lo) + " to " + time_text(hi);
    if (*p.level < lo || *p.level > hi)
        return Emptiness{Emptiness::Reason::OutsideRange,
                         "level " + time_text(*p.level) + " is outside the range of " + *p.field +
                             at + ", " + range,
                         "choose a level from " + range};
    return Emptiness{Emptiness::Reason::OutsideRange,
                     *p.field + " has the value " + time_text(*p.level) + " nowhere between nodes" +
                         at,
                     "choose a level within " + range};
}

Error too_many(const SurfaceParameters& p, std::size_t quads) {
    return {Error::Code::OverLimit,
            "the level set of " + *p.field + " needs " + std::to_string(quads) +
                " quads, more than `maxQuads` " + std::to_string(p.max_quads) + " allows",
            "raise `maxQuads`, or choose another level",
            {},
            p.max_quads};
}

QuadComplex mesh_of(LevelTriangles&& found) {
    QuadComplex mesh;
    mesh.position = std::move(found.points);
    mesh.cells = paired_triangles(mesh.position, found.triangles);
    const std::size_t n = mesh.vertices();
    mesh.s.assign(n, 0.0);
    mesh.t.assign(n, 0.0);
    mesh.approximated.assign(n, 0);
    return mesh;
}

Result<void>
add_velocity(QuadComplex& mesh, const SurfacePlan& plan, double time, const std::stop_token& stop) {
    const std::vector<double> times(mesh.vertices(), time);
    std::vector<Vec3> velocity(mesh.vertices());
    return plan.flow
        ->sample(mesh.position, times, velocity, stop,
                 plan.parameters.interpolation == Interpolation::Smooth)
        .map([&] { mesh.velocity.assign(velocity.begin(), velocity.end()); });
}

Error no_nodes(const Flow& flow) {
    if (flow.time_range())
        return {
            Error::Code::Unsupported,
            "level sets of an axisymmetric flow cannot be drawn yet: its values are known in one "
            "half plane",
            "choose another `kind` of surface"};
    return {Error::Code::Unsupported,
            "a built-in flow stores no values at nodes, so it has no level sets",
            "write it into a store with `wakesurf generate`, and open that"};
}

} // namespace

Result<void> take_levels(SurfacePlan& plan, std::shared_ptr<const LevelSource> levels) {
    if (plan.parameters.kind != SurfaceKind::Level)
        return {};
    if (levels == nullptr)
        return tl::unexpected(no_nodes(*plan.flow));
    plan.levels = std::move(levels);
    return plan.levels->check_field(*plan.parameters.field);
}

Result<Surface> build_level_surface(const SurfacePlan& plan,
                                    double time,
                                    const std::stop_token& stop,
                                    const Clock& clock,
                                    const WorkPart& work) {
    const SurfaceParameters& p = plan.parameters;
    if (plan.levels == nullptr)
        return tl::unexpected(no_nodes(*plan.flow));
    const auto start = clock.now();
    const auto since = [&](auto begin) {
        return std::chrono::duration<double>(clock.now() - begin).count();
    };
    auto found = plan.levels->extract({*p.field, *p.level, time, 2 * p.max_quads}, stop);
    if (!found)
        return tl::unexpected(std::move(found.error()));
    Surface out;
    SurfaceStatistics& s = out.statistics;
    s.seconds.load = since(start);
    s.kind = p.kind;
    s.empty = why_no_level(p, *found, time);
    if (found->values)
        s.field_range = found->range;
    if (auto room = work.takes(found->triangles.size() * triangle_bytes); !room)
        return tl::unexpected(std::move(room.error()));
    const auto paired = clock.now();
    out.mesh = mesh_of(*std::move(found));
    if (out.mesh.cells.size() > p.max_quads)
        return tl::unexpected(too_many(p, out.mesh.cells.size()));
    s.seconds.refine = since(paired);
    work.reached(0.5);
    if (auto sampled = add_velocity(out.mesh, plan, time, stop); !sampled)
        return tl::unexpected(std::move(sampled.error()));
    label_components(out.mesh);
    s.quads = out.mesh.cells.size();
    s.vertices = out.mesh.vertices();
    s.max_edge = longest_edge(out.mesh);
    s.separation = s.requested_separation = p.separation;
    s.seconds.total = since(start);
    s.seconds.other = s.seconds.total - s.seconds.load - s.seconds.refine;
    work.reached(1.0);
    return out;
}

} // namespace wakesurf::core
