// A cell mesh with a velocity on its nodes, ready to be sampled.
#pragma once

#include "core/field/cells/cell_sampler.hpp"
#include "tests/support/cell_meshes.hpp"

#include <memory>
#include <random>

namespace wakesurf::tests {

struct MeshedField {
    using Flow = std::function<Vec3(const Vec3&)>;

    MeshedField(CellMesh mesh_, const Flow& first, const Flow& second = {})
        : mesh(std::make_unique<CellMesh>(std::move(mesh_))), velocity0(at_nodes(*mesh, first)),
          velocity1(second ? at_nodes(*mesh, second) : std::vector<float>()), domain(*mesh) {}

    core::CellSampler sampler() const {
        return {&domain, velocity0.data(), velocity1.empty() ? nullptr : velocity1.data()};
    }

    Vec3 random_point(std::mt19937& random) const {
        std::uniform_real_distribution<double> part(0.0, 1.0);
        const core::Box& box = domain.locator.bounds();
        const double x = part(random), y = part(random), z = part(random);
        return box.lo + box.extent() * Vec3(x, y, z);
    }

    std::unique_ptr<CellMesh> mesh;
    std::vector<float> velocity0;
    std::vector<float> velocity1;
    core::CellDomain domain;
};

/// Marks as walls the faces whose centre and cell are chosen.
inline void mark_walls(CellMesh& mesh, const std::function<bool(const Vec3& centre)>& wall) {
    for (MeshCell& cell : mesh.cells)
        for (std::size_t f = 0; f < core::face_count(cell.shape); ++f) {
            const core::CellFace corners = core::face(cell.shape, f);
            Vec3 centre(0.0);
            for (std::size_t i = 0; i < corners.count; ++i)
                centre += mesh.points[cell.node[corners.node[i]]] / double(corners.count);
            if (wall(centre))
                cell.beyond[f] = core::beyond_wall;
        }
}

/// Returns one cell of each shape, bent, its nodes on multiples of 1/64.
inline std::vector<CellMesh> single_cells() {
    const std::vector<std::pair<CellShape, std::vector<Vec3>>> shapes = {
        {CellShape::Tetrahedron, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {CellShape::Pyramid, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}},
        {CellShape::Wedge, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
        {CellShape::Wedge, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}}},
        {CellShape::Hexahedron,
         {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}};
    std::vector<CellMesh> cells;
    std::mt19937 random(7);
    std::uniform_int_distribution<int> by(-9, 9);
    for (const double bend : {0.0, 1.0})
        for (const auto& [shape, points] : shapes) {
            CellMesh mesh;
            std::vector<std::uint32_t> nodes;
            for (const Vec3& p : points) {
                const int x = by(random), y = by(random), z = by(random);
                nodes.push_back(static_cast<std::uint32_t>(mesh.points.size()));
                mesh.points.push_back(p + bend * Vec3(x, y, z) / 64.0);
            }
            add_cell(mesh, shape, nodes);
            cells.push_back(mesh);
        }
    return cells;
}

} // namespace wakesurf::tests
