#include "server/data/levels/placed_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace wakesurf::server {

namespace {

/// Holds a uniform or rectilinear grid along its axes.
struct GridAxes {
    std::array<std::size_t, 3> nodes{};
    const core::UniformGrid* uniform = nullptr;
    const core::RectilinearGrid* rectilinear = nullptr;

    explicit GridAxes(const core::Grid& grid)
        : uniform(std::get_if<core::UniformGrid>(&grid)),
          rectilinear(std::get_if<core::RectilinearGrid>(&grid)) {
        for (std::size_t k = 0; k < 3; ++k)
            nodes[k] = uniform != nullptr       ? uniform->dimensions[k]
                       : rectilinear != nullptr ? rectilinear->coordinates[k].size()
                                                : 0;
    }

    /// Returns the cell's first node along an axis. @param at  in units of node indices
    std::size_t cell(std::size_t axis, double at) const {
        return std::min(static_cast<std::size_t>(std::max(at, 0.0)), nodes[axis] - 2);
    }

    double coordinate(std::size_t axis, double at) const {
        if (uniform != nullptr)
            return uniform->origin[static_cast<int>(axis)] +
                   uniform->spacing[static_cast<int>(axis)] * at;
        const auto& along = rectilinear->coordinates[axis];
        const std::size_t i = cell(axis, at);
        return along[i] + (along[i + 1] - along[i]) * (at - static_cast<double>(i));
    }

    /// Says whether the cell round a point has a value at each of its nodes.
    bool whole(std::span<const float> values, const core::Vec3& at) const {
        const std::size_t i = cell(0, at.x), j = cell(1, at.y), k = cell(2, at.z);
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::size_t node =
                i + (corner & 1) +
                nodes[0] * (j + (corner >> 1 & 1) + nodes[1] * (k + (corner >> 2)));
            if (!std::isfinite(values[node]))
                return false;
        }
        return true;
    }
};

core::Result<LevelMesh> not_of_the_grid() {
    return core::fail(core::Error::Code::Io,
                      "the level set was not extracted: its points do not lie in the grid",
                      "this is a fault of wakesurf or of a library");
}

/// Allows for rounding: a point on a border comes a little beyond it.
bool in_box(const core::Vec3& point, const core::Box& box) {
    const core::Vec3 slack = 1e-5 * box.extent();
    for (int k = 0; k < 3; ++k)
        if (!(point[k] >= box.lo[k] - slack[k] && point[k] <= box.hi[k] + slack[k]))
            return false;
    return true;
}

/// Says whether a triangle repeats a point; such triangles have no area.
bool repeats_point(const std::array<std::uint32_t, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

void leave_out_unused(LevelMesh& mesh) {
    constexpr std::uint32_t unused = 0xffffffffu;
    std::vector<std::uint32_t> now(mesh.points.size(), unused);
    std::uint32_t next = 0;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t each : triangle)
            now[each] = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (now[i] != unused) {
            mesh.points[next] = mesh.points[i];
            now[i] = next++;
        }
    mesh.points.resize(next);
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& each : triangle)
            each = now[each];
}

} // namespace

core::Result<LevelMesh>
placed_triangles(const core::Grid& grid, std::span<const float> values, bool gaps, LevelMesh mesh) {
    const GridAxes axes(grid);
    const bool in_places = axes.nodes[0] != 0;
    const auto gone = [&](const std::array<std::uint32_t, 3>& triangle) {
        if (repeats_point(triangle))
            return true;
        if (!gaps || !in_places) // in a mesh such cells were left out beforehand
            return false;
        const core::Vec3 middle =
            (mesh.points[triangle[0]] + mesh.points[triangle[1]] + mesh.points[triangle[2]]) / 3.0;
        return !(std::isfinite(middle.x + middle.y + middle.z) && axes.whole(values, middle));
    };
    std::erase_if(mesh.triangles, gone);
    leave_out_unused(mesh);
    const core::Box box = core::bounds(grid);
    for (core::Vec3& point : mesh.points) {
        if (in_places) {
            for (int k = 0; k < 3; ++k)
                if (!(std::abs(point[k]) <= 1e9))
                    return not_of_the_grid();
            point = {axes.coordinate(0, point.x), axes.coordinate(1, point.y),
                     axes.coordinate(2, point.z)};
        }
        if (!in_box(point, box))
            return not_of_the_grid();
        point = glm::clamp(point, box.lo, box.hi);
    }
    return mesh;
}

} // namespace wakesurf::server
