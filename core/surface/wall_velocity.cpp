#include "core/surface/wall_velocity.hpp"

#include "core/field/advance_particles.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::core {

namespace {

/// Returns a normal for each vertex, of any length: the sum of those of the cells round it, by their areas.
/// Walls of stores are turned as their source has them, so a cell that is turned against those before it
/// counts the other way round.
std::vector<Vec3> wall_normals(const QuadComplex& wall) {
    std::vector<Vec3> sums(wall.vertices(), Vec3(0.0));
    for (const Cell& cell : wall.cells) {
        const auto at = [&](std::size_t i) { return wall.position[cell.corner[i]]; };
        // The diagonals of a quad; of a triangle whose third corner comes twice, two of its sides.
        const Vec3 twice_the_area = glm::cross(at(2) - at(0), at(3) - at(1));
        for (std::size_t i = 0; i < 4; ++i) {
            if (i == 3 && cell.corner[3] == cell.corner[2])
                continue;
            Vec3& sum = sums[cell.corner[i]];
            sum += glm::dot(sum, twice_the_area) < 0.0 ? -twice_the_area : twice_the_area;
        }
    }
    return sums;
}

/// Keeps a place in the domain, in which `from` is: a path that leaves through its border goes along that.
Vec3 kept_in(const Box& box, const Vec3& from, const Vec3& place) {
    Vec3 kept = place;
    for (int axis = 0; axis < 3; ++axis)
        if (from[axis] >= box.lo[axis] && from[axis] <= box.hi[axis])
            kept[axis] = std::clamp(place[axis], box.lo[axis], box.hi[axis]);
    return kept;
}

/// Returns the nearest place in the fluid, on either side. The edge of a body at the domain's border faces
/// out of the domain.
std::optional<Vec3> place_off_wall(const Flow& flow, const Vec3& at, const Vec3& normal) {
    const double length = glm::length(normal);
    if (!(length > 0.0))
        return std::nullopt;
    for (const double distance : wall_distances) {
        const Vec3 off = normal * (distance * flow.finest_spacing() / length);
        for (const Vec3& way : {off, -off}) {
            const Vec3 place = kept_in(flow.domain(), at, at + way);
            const bool is_off = glm::dot(place - at, way) > 0.2 * glm::dot(way, way);
            if (is_off && flow.status(place) == PointStatus::Inside)
                return place;
        }
    }
    return std::nullopt;
}

} // namespace

Result<void>
add_wall_velocity(QuadComplex& wall, const Flow& flow, double time, std::stop_token stop) {
    const std::size_t count = wall.vertices();
    std::vector<Vec3> places = wall_normals(wall);
    std::vector<std::uint8_t> nothing(count, 0);
    const bool whole = in_ranges(
        count, stop,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i != end; ++i) {
                const auto found = place_off_wall(flow, wall.position[i], places[i]);
                nothing[i] = found ? 0 : 1;
                places[i] = found.value_or(wall.position[i]);
            }
        },
        256);
    if (!whole)
        return fail(Error::Code::Cancelled, "looking at the wall was cancelled");
    const std::vector<double> times(count, time);
    std::vector<Vec3> velocity(count);
    if (auto sampled = flow.sample(places, times, velocity, stop); !sampled)
        return sampled;
    if (auto marked = flow.mark_gaps(places, times, nothing, stop); !marked)
        return marked;
    wall.velocity.assign(count, Vec3f(0.0F));
    for (std::size_t i = 0; i < count; ++i)
        if (nothing[i] == 0)
            wall.velocity[i] = Vec3f(velocity[i]);
    wall.s.assign(count, 0.0);
    wall.t.assign(count, 0.0);
    return {};
}

} // namespace wakesurf::core
