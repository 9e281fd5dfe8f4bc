#include "core/surface/builder/emptiness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wakesurf::core {

namespace {

/// A quad whose area is below this part of its squared diagonal is a line.
constexpr double least_area = 1e-6;

/// Returns true if some quad has an area. The first quad decides, unless the surface is a line: this runs in
/// every frame that plays.
bool has_area(const QuadComplex& mesh) {
    return std::any_of(mesh.cells.begin(), mesh.cells.end(), [&](const Cell& cell) {
        const auto& [a, b, c, d] = cell.corner;
        const Vec3 p = mesh.position[c] - mesh.position[a];
        const Vec3 q = mesh.position[d] - mesh.position[b];
        return glm::length(glm::cross(p, q)) >
               least_area * std::max(glm::dot(p, p), glm::dot(q, q));
    });
}

/// Returns where the particles come from: along the rake, and all over the patch of a time surface.
std::vector<Vec3> origins(const SurfacePlan& plan) {
    constexpr int along = 33;
    constexpr int across = 9;
    const SeedingCurve& curve = plan.seeding;
    const SurfaceParameters& p = plan.parameters;
    const std::optional<SeedingCurve> second =
        p.rake2 ? std::optional<SeedingCurve>(*p.rake2) : std::nullopt;
    std::vector<Vec3> points;
    for (int i = 0; i < along; ++i) {
        const double s = i / (along - 1.0);
        const Vec3 from = curve.at(s);
        const Vec3 way = second ? second->at(s) - from : p.sweep.value_or(Vec3(0.0));
        const int rows = second || p.sweep ? across : 1;
        for (int k = 0; k < rows; ++k)
            points.push_back(from + way * (k / (across - 1.0)));
    }
    return points;
}

Emptiness because(Emptiness::Reason reason, const char* message, const char* hint) {
    return {reason, message, hint};
}

/// Returns what the places tell at which particles are released; nothing if some are released, and move.
/// @param later  set where they do not move at first
Result<std::optional<Emptiness>>
at_release(const SurfacePlan& plan, bool& later, const std::stop_token& stop) {
    using Reason = Emptiness::Reason;
    const Flow& flow = *plan.flow;
    const SurfaceParameters& p = plan.parameters;
    const std::vector<Vec3> points = origins(plan);
    std::vector<std::uint8_t> gap(points.size());
    if (auto marked = flow.mark_gaps(points, std::vector(points.size(), p.from), gap, stop);
        !marked)
        return tl::unexpected(marked.error());
    std::vector<Vec3> inside;
    std::size_t in_body = 0;
    std::size_t outside = 0;
    std::size_t in_gap = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PointStatus status = flow.status(points[i]);
        in_body += status == PointStatus::InObstacle;
        outside += status == PointStatus::OutsideDomain;
        in_gap += gap[i];
        if (status == PointStatus::Inside && gap[i] == 0)
            inside.push_back(points[i]);
    }
    if (inside.empty() && in_gap > 0)
        return because(Reason::NotFinite, "the data have no velocity at the rake at this time",
                       "move the rake to where the data have values, or choose another time");
    if (inside.empty() && outside == 0)
        return because(Reason::InBody, "the whole rake lies inside the body",
                       "move the rake into the fluid");
    if (inside.empty() && in_body == 0)
        return because(Reason::OutsideCells,
                       "the whole rake lies where the data have no cells, though inside their box",
                       "move the rake to where there are cells");
    if (inside.empty())
        return because(Reason::OutsideCells,
                       "the whole rake lies inside the body or where the data have no cells",
                       "move the rake into the fluid");
    const auto fastest = plan.largest_speed(stop);
    if (!fastest)
        return tl::unexpected(fastest.error());
    const double rest = p.stagnation_speed * *fastest;
    std::vector<Vec3> velocities(inside.size());
    const auto frozen = p.kind == SurfaceKind::Stream;
    for (const double time :
         {p.from, frozen ? p.from : 0.5 * (p.from + p.to), frozen ? p.from : p.to}) {
        const std::vector<double> times(inside.size(), time);
        if (auto sampled = flow.sample(inside, times, velocities, stop); !sampled)
            return tl::unexpected(sampled.error());
        if (!std::all_of(velocities.begin(), velocities.end(), finite))
            return because(Reason::NotFinite, "the velocities at the rake are not finite numbers",
                           "choose another time; the simulation may have failed at this one");
        if (std::any_of(velocities.begin(), velocities.end(),
                        [&](const Vec3& v) { return glm::length(v) > rest; })) {
            later = time != p.from;
            return std::nullopt;
        }
    }
    return because(Reason::AtRest, "the fluid is at rest all along the rake",
                   "move the rake to where the fluid moves, or choose another time");
}

} // namespace

Result<std::optional<Emptiness>> why_empty(const SurfacePlan& plan,
                                           const QuadComplex& mesh,
                                           const SurfaceStatistics& statistics,
                                           std::stop_token stop) {
    using Reason = Emptiness::Reason;
    if (!mesh.cells.empty() && has_area(mesh))
        return std::nullopt;
    bool later = false;
    auto reason = at_release(plan, later, stop);
    if (!reason || *reason)
        return reason;
    const auto& ended = statistics.terminated;
    if (later && ended.domain + ended.obstacle + ended.stagnation == 0)
        return because(Reason::NothingYet, "the fluid along the rake has not moved yet",
                       "choose a later time, or play");
    const SurfaceParameters& p = plan.parameters;
    if (p.kind == SurfaceKind::Time && p.rake2 && p.rake2->points == plan.rake.points)
        return because(Reason::SameRakes,
                       "the two rakes are the same, so the patch between them has no area",
                       "move one of them, or use a sweep");
    if (!mesh.cells.empty())
        return p.kind == SurfaceKind::Time
                   ? because(Reason::NoArea, "the patch has no area",
                             "sweep the rake across its own direction")
                   : because(Reason::NoArea,
                             "the rake lies along the flow, so the surface has no area",
                             "turn the rake across the flow");
    if (statistics.steps == 0)
        return because(Reason::NothingYet, "nothing has been released yet",
                       "choose a later time, or play");
    if (ended.domain > 0)
        return because(Reason::AllLeft, "all particles have left the domain",
                       "choose a shorter time, or a rake further from where the flow leaves");
    if (ended.obstacle > 0)
        return because(Reason::AllLeft, "all particles have reached the body",
                       "choose a shorter time, or move the rake");
    if (ended.stagnation > 0)
        return because(Reason::AtRest, "all particles have come to rest",
                       "choose a shorter time, or move the rake to where the fluid moves");
    if (p.life && ended.time > 0)
        return because(Reason::AllLeft, "all particles have come to the end of their life",
                       "choose a longer `life`, or an earlier time");
    return because(Reason::TooCoarse, "no quad is left at this separation",
                   "choose a smaller separation");
}

} // namespace wakesurf::core
