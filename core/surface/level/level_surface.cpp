#include "core/surface/level/level_surface.hpp"

#include "core/surface/level/level_source.hpp"
#include "core/surface/level/level_triangles.hpp"
#include "core/surface/level/paired_triangles.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace wakesurf::core {

namespace {

/// A triangle while neighbours are paired, and what of the mesh comes from it, beside the triangle itself.
constexpr std::size_t triangle_bytes = 136;

std::string listed_times(const std::vector<double>& times) {
    constexpr std::size_t most = 8;
    std::string out;
    for (std::size_t i = 0; i < std::min(most, times.size()); ++i)
        out += (i == 0 ? "" : ", ") + time_text(times[i]);
    return times.size() <= most ? out : out + ", ... " + time_text(times.back());
}

std::optional<Emptiness>
why_no_level(const SurfaceParameters& p, const NodeValues& found, double time) {
    const std::string at = p.from == p.to ? "" : " at t = " + time_text(time);
    if (!found.any)
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

/// A level outside the range has none.
Result<LevelTriangles> extracted_triangles(const LevelSource& source,
                                           const NodeValues& found,
                                           const SurfaceParameters& p,
                                           const std::stop_token& stop,
                                           const WorkPart& work) {
    if (!found.any || *p.level < found.range[0] || *p.level > found.range[1])
        return LevelTriangles{};
    auto triangles =
        level_triangles(source.grid(), found.values, *p.level, 2 * p.max_quads, stop, work);
    if (triangles && triangles->needed > 2 * p.max_quads)
        return over_limit(p.max_quads,
                          "the level set of " + *p.field + " has " +
                              std::to_string(triangles->needed) +
                              " triangles, more than `maxQuads` " + std::to_string(p.max_quads) +
                              " quads are made of",
                          "raise `maxQuads`, or choose another level");
    return triangles;
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
    const auto found = plan.levels->values(*p.field, time, stop);
    if (!found)
        return tl::unexpected(found.error());
    const NodeValues& values = **found;
    Surface out;
    SurfaceStatistics& s = out.statistics;
    s.seconds.load = since(start);
    s.kind = p.kind;
    if (values.any)
        s.field_range = values.range;
    const auto extracted = clock.now();
    auto triangles = extracted_triangles(*plan.levels, values, p, stop, work);
    if (!triangles)
        return tl::unexpected(std::move(triangles.error()));
    if (triangles->triangles.empty())
        s.empty = why_no_level(p, values, time);
    if (auto room = work.takes(triangles->triangles.size() * triangle_bytes); !room)
        return tl::unexpected(std::move(room.error()));
    out.mesh = mesh_of(*std::move(triangles));
    if (out.mesh.cells.size() > p.max_quads)
        return tl::unexpected(too_many(p, out.mesh.cells.size()));
    s.seconds.refine = since(extracted);
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
