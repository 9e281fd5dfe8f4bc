#include "core/surface/obstacle_surface.hpp"

#include "core/field/advance_particles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <variant>
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

/// Returns the first place in the fluid, on either side. The edge of a body at the domain's border faces
/// out of the domain.
std::optional<Vec3> place_off_wall(const Flow& flow,
                                   const Vec3& at,
                                   const Vec3& normal,
                                   std::span<const double> distances) {
    const double length = glm::length(normal);
    if (!(length > 0.0))
        return std::nullopt;
    for (const double distance : distances) {
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

Result<std::vector<Vec3>> places_off_wall(const QuadComplex& wall,
                                          const Flow& flow,
                                          std::span<const double> distances,
                                          const std::stop_token& stop) {
    std::vector<Vec3> places = wall_normals(wall);
    const Vec3 nowhere(std::numeric_limits<double>::quiet_NaN());
    const bool whole = in_ranges(
        places.size(), stop,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i != end; ++i)
                places[i] =
                    place_off_wall(flow, wall.position[i], places[i], distances).value_or(nowhere);
        },
        256);
    if (!whole)
        return fail(Error::Code::Cancelled, "looking at the wall was cancelled");
    return places;
}

Result<void>
add_wall_velocity(QuadComplex& wall, const Flow& flow, double time, std::stop_token stop) {
    const std::size_t count = wall.vertices();
    auto places = places_off_wall(wall, flow, wall_distances, stop);
    if (!places)
        return tl::unexpected(places.error());
    std::vector<std::uint8_t> nothing(count, 0);
    for (std::size_t i = 0; i < count; ++i)
        if (std::isnan((*places)[i].x)) {
            nothing[i] = 1;
            (*places)[i] = wall.position[i];
        }
    const std::vector<double> times(count, time);
    std::vector<Vec3> velocity(count);
    if (auto sampled = flow.sample(*places, times, velocity, stop); !sampled)
        return sampled;
    if (auto marked = flow.mark_gaps(*places, times, nothing, stop); !marked)
        return marked;
    wall.velocity.assign(count, Vec3f(0.0F));
    for (std::size_t i = 0; i < count; ++i)
        if (nothing[i] == 0)
            wall.velocity[i] = Vec3f(velocity[i]);
    wall.s.assign(count, 0.0);
    wall.t.assign(count, 0.0);
    return {};
}

namespace {

using Index = std::array<std::uint32_t, 3>;

/// Node coordinates on each axis, for any grid.
using Axes = std::array<std::vector<double>, 3>;

/// Numbers the corners of the nodes' boxes: corner c of an axis lies midway between nodes c - 1 and c,
/// clamped to the domain.
class Wall {
  public:
    explicit Wall(const Axes& axes) : axes_(axes) {}

    /// Adds the face of `node` towards the next node along `axis`, or towards the one before it.
    void add_face(const Index& node, int axis, bool towards_next, bool fluid_above) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        Index corner = node;
        corner[static_cast<std::size_t>(axis)] += towards_next ? 1 : 0;
        const auto at = [&](std::uint32_t du, std::uint32_t dv) {
            Index c = corner;
            c[static_cast<std::size_t>(u)] += du;
            c[static_cast<std::size_t>(v)] += dv;
            return vertex(c);
        };
        Cell cell;
        cell.corner = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}; // counter-clockwise seen from above
        if (!fluid_above)
            std::swap(cell.corner[1], cell.corner[3]);
        mesh.cells.push_back(cell);
    }

    QuadComplex mesh;

  private:
    VertexId vertex(const Index& corner) {
        const std::uint64_t key =
            (std::uint64_t{corner[2]} * (axes_[1].size() + 1) + corner[1]) * (axes_[0].size() + 1) +
            corner[0];
        const auto [found, fresh] =
            ids_.try_emplace(key, static_cast<VertexId>(mesh.position.size()));
        if (fresh)
            mesh.position.push_back({between(corner, 0), between(corner, 1), between(corner, 2)});
        return found->second;
    }

    double between(const Index& corner, std::size_t axis) const {
        const auto& along = axes_[axis];
        const std::size_t c = corner[axis];
        return c == 0             ? along.front()
               : c < along.size() ? 0.5 * (along[c - 1] + along[c])
                                  : along.back();
    }

    const Axes& axes_;
    std::unordered_map<std::uint64_t, VertexId> ids_;
};

Axes axes_of(const UniformGrid& grid) {
    Axes axes;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::uint32_t i = 0; i < grid.dimensions[axis]; ++i)
            axes[axis].push_back(grid.origin[static_cast<int>(axis)] +
                                 i * grid.spacing[static_cast<int>(axis)]);
    return axes;
}

/// Nodes of a row, from the first to before the last.
struct Part {
    std::uint32_t from, to;
};

/// Parts of the rows through bricks in which a wall may be, in x; all of them for a mask in one piece. `j`
/// and `k` are the rows' places.
std::vector<Part> parts_with_walls(const SolidMask& mask,
                                   const std::array<std::size_t, 3>& n,
                                   std::size_t j,
                                   std::size_t k) {
    if (mask.bricks == nullptr)
        return {{0, static_cast<std::uint32_t>(n[0])}};
    const BrickLayout& layout = mask.bricks->layout();
    const auto& bricks = layout.bricks();
    const auto within = [&](std::size_t axis, std::size_t node) {
        return std::min<std::size_t>(node >> layout.shift(), bricks[axis] - 1);
    };
    const std::size_t y = within(1, j);
    const std::size_t z = within(2, k);
    std::vector<Part> parts;
    for (std::size_t x = 0; x < bricks[0]; ++x) {
        // All neighbours of a brick's nodes but those at the grid's border are in the brick.
        const auto value = mask.bricks->only_value(x + bricks[0] * (y + bricks[1] * z));
        const bool border =
            x == 0 || x + 1 == bricks[0] || j == 0 || j + 1 == n[1] || k == 0 || k + 1 == n[2];
        if (value == 1 || (value == 0 && !border))
            continue;
        parts.push_back({static_cast<std::uint32_t>(x << layout.shift()),
                         x + 1 == bricks[0]
                             ? static_cast<std::uint32_t>(n[0])
                             : static_cast<std::uint32_t>((x + 1) << layout.shift())});
    }
    return parts;
}

QuadComplex surface_over(const Axes& axes, const SolidMask& mask) {
    Wall wall(axes);
    if (mask.empty())
        return std::move(wall.mesh);
    const std::array<std::size_t, 3> n{axes[0].size(), axes[1].size(), axes[2].size()};
    const std::array<std::size_t, 3> stride{1, n[0], n[0] * n[1]};
    const auto add_faces_at = [&](const Index& index) {
        const std::array<std::size_t, 3> at{index[0], index[1], index[2]};
        const std::size_t node = at[0] + stride[1] * at[1] + stride[2] * at[2];
        const bool here = mask.is_fluid(at, node);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            auto next = at;
            ++next[axis];
            const bool above = next[axis] == n[axis] || mask.is_fluid(next, node + stride[axis]);
            if (at[axis] == 0 && !here)
                wall.add_face(index, static_cast<int>(axis), false, false);
            if (here != above)
                wall.add_face(index, static_cast<int>(axis), true, above);
        }
    };
    for (std::uint32_t k = 0; k < n[2]; ++k)
        for (std::uint32_t j = 0; j < n[1]; ++j)
            for (const Part& part : parts_with_walls(mask, n, j, k))
                for (std::uint32_t i = part.from; i < part.to; ++i)
                    add_faces_at({i, j, k});
    return std::move(wall.mesh);
}

} // namespace

QuadComplex obstacle_surface(const UniformGrid& grid, const SolidMask& mask) {
    return surface_over(axes_of(grid), mask);
}

QuadComplex obstacle_surface(const RectilinearGrid& grid, const SolidMask& mask) {
    return surface_over(grid.coordinates, mask);
}

QuadComplex obstacle_surface(const Grid& grid, const SolidMask& mask) {
    if (const auto* uniform = std::get_if<UniformGrid>(&grid))
        return obstacle_surface(*uniform, mask);
    if (const auto* rectilinear = std::get_if<RectilinearGrid>(&grid))
        return obstacle_surface(*rectilinear, mask);
    return {};
}

QuadComplex wall_surface(const WallGeometry& walls) {
    QuadComplex surface;
    for (const Vec3f& point : walls.points)
        surface.position.emplace_back(point);
    for (const auto& [a, b, c] : walls.triangles)
        surface.cells.push_back({{a, b, c, c}, Cell{}.mid});
    return surface;
}

} // namespace wakesurf::core
