#include "core/dataset/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

bool is_even(std::span<const double> nodes, bool single_precision) {
    const double spacing = (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1);
    if (!std::isfinite(spacing))
        return false;
    const double furthest = std::max(std::abs(nodes.front()), std::abs(nodes.back()));
    const double slack = std::max(1e-6 * spacing, single_precision ? furthest * 0x1p-23 : 0.0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (std::abs(nodes[i] - (nodes.front() + static_cast<double>(i) * spacing)) > slack)
            return false;
    return true;
}

namespace {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>; // clang 14 finds no guide of an aggregate by itself

Box box_of(const CellMesh& mesh) {
    if (mesh.points.empty())
        return {};
    Box box{Vec3(std::numeric_limits<double>::infinity()),
            Vec3(-std::numeric_limits<double>::infinity())};
    for (const Vec3& p : mesh.points) {
        Vec3 middle = p;
        Vec3 reach(0.0); // of the circle that a node makes round the axis
        if (mesh.axis) {
            const Vec3& a = mesh.axis->direction;
            middle = mesh.axis->origin + glm::dot(p - mesh.axis->origin, a) * a;
            reach = glm::length(p - middle) * glm::sqrt(glm::max(Vec3(1.0) - a * a, Vec3(0.0)));
        }
        box.lo = glm::min(box.lo, middle - reach);
        box.hi = glm::max(box.hi, middle + reach);
    }
    return box;
}

double closest_nodes(const RectilinearGrid& grid) {
    double closest = std::numeric_limits<double>::infinity();
    for (const auto& along : grid.coordinates)
        for (std::size_t i = 0; i + 1 < along.size(); ++i)
            closest = std::min(closest, along[i + 1] - along[i]);
    return closest;
}

// Returns the root of the area that a cell of an axisymmetric flow has in its half plane, as a box.
double size_in_half_plane(const CellMesh& mesh, const MeshCell& cell) {
    double lo[2] = {HUGE_VAL, HUGE_VAL};
    double hi[2] = {-HUGE_VAL, -HUGE_VAL};
    for (std::size_t i = 0; i < node_count(cell.shape); ++i) {
        const Vec3 from = mesh.points[cell.node[i]] - mesh.axis->origin;
        const double along = glm::dot(from, mesh.axis->direction);
        const double at[2] = {along, glm::length(from - along * mesh.axis->direction)};
        for (int k = 0; k < 2; ++k) {
            lo[k] = std::min(lo[k], at[k]);
            hi[k] = std::max(hi[k], at[k]);
        }
    }
    return std::sqrt((hi[0] - lo[0]) * (hi[1] - lo[1]));
}

// Returns the cube root of the volume of the box round a cell.
double cell_size(const CellMesh& mesh, const MeshCell& cell) {
    if (mesh.axis)
        return size_in_half_plane(mesh, cell);
    Vec3 lo = mesh.points[cell.node[0]];
    Vec3 hi = lo;
    for (std::size_t i = 1; i < node_count(cell.shape); ++i) {
        lo = glm::min(lo, mesh.points[cell.node[i]]);
        hi = glm::max(hi, mesh.points[cell.node[i]]);
    }
    const Vec3 side = hi - lo;
    return std::cbrt(side.x * side.y * side.z);
}

double small_cell(const CellMesh& mesh) {
    constexpr std::size_t looked_at = 100'000;
    const std::size_t stride = std::max<std::size_t>(1, mesh.cells.size() / looked_at);
    std::vector<double> sizes;
    for (std::size_t i = 0; i < mesh.cells.size(); i += stride)
        if (const double size = cell_size(mesh, mesh.cells[i]); size > 0.0)
            sizes.push_back(size);
    if (sizes.empty())
        return glm::length(box_of(mesh).extent()) / 100.0;
    const auto tenth = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 10);
    std::nth_element(sizes.begin(), tenth, sizes.end());
    return *tenth;
}

} // namespace

std::size_t node_count(const Grid& grid) {
    return std::visit(Overloaded{[](const UniformGrid& g) { return g.nodes(); },
                                 [](const RectilinearGrid& g) { return g.nodes(); },
                                 [](const CellMesh& g) { return g.points.size(); }},
                      grid);
}

std::size_t cell_count(const Grid& grid) {
    const auto product = [](std::size_t x, std::size_t y, std::size_t z) {
        return (x - 1) * (y - 1) * (z - 1);
    };
    return std::visit(
        Overloaded{[&](const UniformGrid& g) {
                       return product(g.dimensions[0], g.dimensions[1], g.dimensions[2]);
                   },
                   [&](const RectilinearGrid& g) {
                       return product(g.coordinates[0].size(), g.coordinates[1].size(),
                                      g.coordinates[2].size());
                   },
                   [](const CellMesh& g) { return g.cells.size(); }},
        grid);
}

Vec3 node_position(const Grid& grid, std::size_t node) {
    const Overloaded where{
        [node](const UniformGrid& uniform) { return node_position(uniform, node); },
        [node](const RectilinearGrid& rectilinear) {
            const auto& [x, y, z] = rectilinear.coordinates;
            const std::size_t row = node / x.size();
            return Vec3(x[node % x.size()], y[row % y.size()], z[row / y.size()]);
        },
        [node](const CellMesh& mesh) { return mesh.points[node]; },
    };
    return std::visit(where, grid);
}

std::size_t memory_of(const Grid& grid) {
    return std::visit(Overloaded{[](const UniformGrid&) { return std::size_t{0}; },
                                 [](const RectilinearGrid& g) {
                                     std::size_t nodes = 0;
                                     for (const auto& along : g.coordinates)
                                         nodes += along.size();
                                     return nodes * sizeof(double);
                                 },
                                 [](const CellMesh& g) {
                                     return g.points.size() * sizeof(Vec3) +
                                            g.cells.size() * sizeof(MeshCell);
                                 }},
                      grid);
}

Box bounds(const Grid& grid) {
    return std::visit(Overloaded{[](const UniformGrid& g) { return g.bounds(); },
                                 [](const RectilinearGrid& g) { return g.bounds(); },
                                 [](const CellMesh& g) { return box_of(g); }},
                      grid);
}

double finest_spacing(const Grid& grid) {
    return std::visit(Overloaded{[](const UniformGrid& g) {
                                     return std::min({g.spacing.x, g.spacing.y, g.spacing.z});
                                 },
                                 [](const RectilinearGrid& g) { return closest_nodes(g); },
                                 [](const CellMesh& g) { return small_cell(g); }},
                      grid);
}

} // namespace wakesurf::core
