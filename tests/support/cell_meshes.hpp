// Cell meshes that tests and benchmarks make: blocks of hexahedra bent to any shape, and hexahedra refined
// 2:1 in a part, with the polyhedra in between cut into pyramids and tetrahedra as the importer does.
#pragma once

#include "core/dataset/cell_mesh.hpp"
#include "core/dataset/cell_neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace wakesurf::tests {

using core::CellMesh;
using core::CellShape;
using core::MeshCell;
using core::Vec3;

inline void add_cell(CellMesh& mesh, CellShape shape, const std::vector<std::uint32_t>& nodes) {
    MeshCell cell{};
    cell.node.fill(0xffffffffu);
    std::copy(nodes.begin(), nodes.end(), cell.node.begin());
    cell.beyond.fill(core::beyond_domain);
    cell.shape = shape;
    mesh.cells.push_back(cell);
}

/// Maps lattice coordinates, each from 0 to 1, to space.
using Bend = std::function<Vec3(const Vec3&)>;

/// Adds a block of nx x ny x nz hexahedra. @param round  the last nodes along y are the first again
inline void
add_block(CellMesh& mesh, std::array<std::uint32_t, 3> n, const Bend& bend, bool round = false) {
    const auto base = static_cast<std::uint32_t>(mesh.points.size());
    const std::uint32_t rows = round ? n[1] : n[1] + 1;
    for (std::uint32_t z = 0; z <= n[2]; ++z)
        for (std::uint32_t y = 0; y < rows; ++y)
            for (std::uint32_t x = 0; x <= n[0]; ++x)
                mesh.points.push_back(bend(Vec3(x, y, z) / Vec3(n[0], n[1], n[2])));
    const auto node = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        return base + (z * rows + y % rows) * (n[0] + 1) + x;
    };
    for (std::uint32_t z = 0; z < n[2]; ++z)
        for (std::uint32_t y = 0; y < n[1]; ++y)
            for (std::uint32_t x = 0; x < n[0]; ++x)
                add_cell(mesh, CellShape::Hexahedron,
                         {node(x, y, z), node(x + 1, y, z), node(x + 1, y + 1, z),
                          node(x, y + 1, z), node(x, y, z + 1), node(x + 1, y, z + 1),
                          node(x + 1, y + 1, z + 1), node(x, y + 1, z + 1)});
}

inline CellMesh block(std::array<std::uint32_t, 3> n, const Bend& bend, bool round = false) {
    CellMesh mesh;
    add_block(mesh, n, bend, round);
    core::connect_cells(mesh);
    return mesh;
}

/// Maps to the space round a cylinder of radius 1/2: rings that grow outward to radius 12, turned along z so
/// that no face is along an axis.
inline Vec3 round_cylinder(const Vec3& u) {
    const double radius = 0.5 * std::pow(24.0, u.x);
    const double angle = 2.0 * 3.14159265358979323846 * (u.y + 0.05 * u.z);
    return {radius * std::cos(angle), radius * std::sin(angle), 6.0 * u.z + 0.1 * std::sin(angle)};
}

/// Maps to a cube from 0 to 1 with wavy lattice planes; its sides stay plane.
inline Vec3 wavy(const Vec3& u) {
    constexpr double pi = 3.14159265358979323846;
    const Vec3 s(std::sin(pi * u.x), std::sin(pi * u.y), std::sin(pi * u.z));
    const double all = 0.08 * s.x * s.y * s.z;
    return u +
           all * Vec3(std::cos(3.0 * u.y + u.z), std::sin(2.0 * u.x - u.z), std::cos(4.0 * u.x));
}

/// Refines n^3 cubes 2:1 where asked, the polyhedra at the interface cut as at import. Cells that are left
/// out leave holes.
class TwoToOne {
  public:
    enum class Kind { Coarse, Fine, Hole };

    /// @param kind  of the cube with its centre there, in lattice coordinates from 0 to 1
    TwoToOne(std::uint32_t n, const std::function<Kind(const Vec3&)>& kind, const Bend& bend)
        : n_(static_cast<int>(n)), bend_(bend) {
        for (int z = 0; z < n_; ++z)
            for (int y = 0; y < n_; ++y)
                for (int x = 0; x < n_; ++x)
                    kind_.push_back(kind((Vec3(x, y, z) + 0.5) / double(n_)));
        // Nodes of hexahedra come first, so that polyhedra know which edges carry a hanging node.
        each([&](const Place& at, Kind what) {
            if (what == Kind::Fine)
                for (int k = 0; k < 8; ++k)
                    add_cube(4 * at + 2 * Place{k & 1, k >> 1 & 1, k >> 2}, 2);
        });
        each([&](const Place& at, Kind what) {
            if (what == Kind::Coarse && !hanging(at))
                add_cube(4 * at, 4);
        });
        each([&](const Place& at, Kind what) {
            if (what == Kind::Coarse && hanging(at))
                add_polyhedron(at);
        });
        core::connect_cells(mesh_);
    }

    CellMesh take() { return std::move(mesh_); }

  private:
    /// A place in quarters of a coarse cube's side: those of odd numbers are centres of fine ones.
    using Place = glm::ivec3;

    struct Order {
        bool operator()(const Place& a, const Place& b) const {
            return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
        }
    };

    template <class Visit>
    void each(const Visit& visit) const {
        for (int z = 0; z < n_; ++z)
            for (int y = 0; y < n_; ++y)
                for (int x = 0; x < n_; ++x)
                    visit(Place{x, y, z}, kind_at({x, y, z}));
    }

    Kind kind_at(const Place& at) const {
        for (int axis = 0; axis < 3; ++axis)
            if (at[axis] < 0 || at[axis] >= n_)
                return Kind::Hole;
        return kind_[static_cast<std::size_t>((at.z * n_ + at.y) * n_ + at.x)];
    }

    /// Returns true if a fine cube shares at least an edge.
    bool hanging(const Place& at) const {
        for (int k = 0; k < 27; ++k) {
            const Place step{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
            const int axes = std::abs(step.x) + std::abs(step.y) + std::abs(step.z);
            if (axes < 3 && kind_at(at + step) == Kind::Fine)
                return true;
        }
        return false;
    }

    std::uint32_t node(const Place& at) {
        const auto [found, added] =
            node_.try_emplace(at, static_cast<std::uint32_t>(mesh_.points.size()));
        if (added)
            mesh_.points.push_back(bend_(Vec3(at[0], at[1], at[2]) / (4.0 * n_)));
        return found->second;
    }

    void add_cube(const Place& lo, int side) {
        constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                      {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
        std::vector<std::uint32_t> nodes;
        for (const auto& c : corner)
            nodes.push_back(node(lo + side * Place{c[0], c[1], c[2]}));
        add_cell(mesh_, CellShape::Hexahedron, nodes);
    }

    std::uint32_t mean(const std::vector<std::uint32_t>& nodes) {
        Vec3 sum(0.0);
        for (const std::uint32_t each : nodes)
            sum += mesh_.points[each];
        mesh_.points.push_back(sum / static_cast<double>(nodes.size()));
        return static_cast<std::uint32_t>(mesh_.points.size() - 1);
    }

    /// Returns the sides of a coarse cube as polygons: four quads towards fine cubes, else one with its
    /// edges' hanging nodes.
    std::vector<std::vector<std::uint32_t>> polygons(const Place& at) {
        std::vector<std::vector<std::uint32_t>> all;
        for (int side = 0; side < 6; ++side) {
            const int axis = side / 2;
            Place step{0, 0, 0};
            step[axis] = side % 2 == 0 ? -1 : 1;
            Place a{0, 0, 0}, b{0, 0, 0};
            a[(axis + 1) % 3] = b[(axis + 2) % 3] = 1;
            if (side % 2 == 0)
                std::swap(a, b); // outward
            Place lo = 4 * at;
            lo[axis] += side % 2 == 0 ? 0 : 4;
            if (kind_at(at + step) == Kind::Fine) {
                for (int k = 0; k < 4; ++k) {
                    const Place from = lo + (2 * (k & 1)) * a + (2 * (k >> 1)) * b;
                    all.push_back({node(from), node(from + 2 * a), node(from + 2 * a + 2 * b),
                                   node(from + 2 * b)});
                }
                continue;
            }
            std::vector<std::uint32_t> polygon;
            const Place corner[5] = {lo, lo + 4 * a, lo + 4 * a + 4 * b, lo + 4 * b, lo};
            for (int k = 0; k < 4; ++k) {
                polygon.push_back(node(corner[k]));
                if (const auto hangs = node_.find((corner[k] + corner[k + 1]) / 2);
                    hangs != node_.end())
                    polygon.push_back(hangs->second);
            }
            all.push_back(polygon);
        }
        return all;
    }

    void add_polyhedron(const Place& at) {
        const auto faces = polygons(at);
        std::vector<std::uint32_t> all;
        for (const auto& face : faces)
            all.insert(all.end(), face.begin(), face.end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        const std::uint32_t apex = mean(all);
        for (const auto& face : faces) {
            if (face.size() == 4) {
                add_cell(mesh_, CellShape::Pyramid, {face[0], face[3], face[2], face[1], apex});
                continue;
            }
            auto key = face;
            std::sort(key.begin(), key.end());
            const auto known = centre_.find(key);
            const std::uint32_t centre = known == centre_.end() ? mean(face) : known->second;
            centre_[key] = centre;
            for (std::size_t i = 0; i < face.size(); ++i)
                add_cell(mesh_, CellShape::Tetrahedron,
                         {face[i], centre, face[(i + 1) % face.size()], apex});
        }
    }

    int n_;
    Bend bend_;
    std::vector<Kind> kind_;
    CellMesh mesh_;
    std::map<Place, std::uint32_t, Order> node_;
    std::map<std::vector<std::uint32_t>, std::uint32_t> centre_;
};

/// Returns the velocity at the nodes, float3 each.
inline std::vector<float> at_nodes(const CellMesh& mesh,
                                   const std::function<Vec3(const Vec3&)>& flow) {
    std::vector<float> values;
    for (const Vec3& p : mesh.points)
        for (int axis = 0; axis < 3; ++axis)
            values.push_back(static_cast<float>(flow(p)[axis]));
    return values;
}

} // namespace wakesurf::tests
