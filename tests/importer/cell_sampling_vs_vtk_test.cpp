// Velocity in cells of every shape beside VTK's own interpolation.
#include "core/field/cells/cell_sampler.hpp"
#include "tests/support/meshed_field.hpp"

#include <gtest/gtest.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace wakesurf::core::cell_sampling_vs_vtk_test {

using namespace tests;

namespace {

Vec3 swirl(const Vec3& p) {
    return {std::sin(3.0 * p.y + p.z), 2.0 + std::cos(2.0 * p.x * p.z), p.x * p.y - 0.3};
}

vtkSmartPointer<vtkUnstructuredGrid> as_vtk(const CellMesh& mesh) {
    const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    const auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    for (const Vec3& p : mesh.points)
        points->InsertNextPoint(p.x, p.y, p.z);
    grid->SetPoints(points);
    constexpr int type[] = {VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON};
    for (const MeshCell& cell : mesh.cells) {
        const auto nodes = vtkSmartPointer<vtkIdList>::New();
        for (std::size_t i = 0; i < node_count(cell.shape); ++i)
            nodes->InsertNextId(cell.node[i]);
        grid->InsertNextCell(type[static_cast<std::size_t>(cell.shape)], nodes);
    }
    return grid;
}

Vec3 blend(const MeshedField& field, const MeshCell& cell, const double* weight) {
    Vec3 v(0.0);
    for (std::size_t i = 0; i < node_count(cell.shape); ++i) {
        const float* at = field.velocity0.data() + 3 * std::size_t{cell.node[i]};
        v += weight[i] * Vec3(at[0], at[1], at[2]);
    }
    return v;
}

/// Where these weights are.
Vec3 place(const MeshedField& field, const MeshCell& cell, const double* weight) {
    Vec3 p(0.0);
    for (std::size_t i = 0; i < node_count(cell.shape); ++i)
        p += weight[i] * field.mesh->points[cell.node[i]];
    return p;
}

/// VTK's parametric coordinates of our local ones.
Vec3 parametric(CellShape shape, const Vec3& u) {
    return shape == CellShape::Pyramid ? Vec3(u.x / (1.0 - u.z), u.y / (1.0 - u.z), u.z) : u;
}

} // namespace

TEST(CellSamplingVsVtk, ShapeFunctionsAreVtksToRoundingAtAThousandPointsAShape) {
    for (CellMesh& mesh : single_cells()) {
        const MeshedField field(std::move(mesh), swirl);
        const MeshCell& cell = field.mesh->cells[0];
        const auto grid = as_vtk(*field.mesh);
        CellGeometry geometry;
        geometry.enter(*field.mesh, 0);
        std::mt19937 random(41);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        for (int points = 0; points < 1000;) {
            const double x = part(random), y = part(random), z = part(random);
            const Vec3 u(x, y, z);
            if (!inside_cell(cell.shape, u))
                continue;
            ++points;
            const Vec3 r = parametric(cell.shape, u);
            const double pcoords[3] = {r.x, r.y, r.z};
            double weight[8], at[3];
            int sub_id = 0;
            grid->GetCell(0)->EvaluateLocation(sub_id, pcoords, at, weight);
            const Vec3 p(at[0], at[1], at[2]);
            EXPECT_LT(glm::length(geometry.position(u) - p), 1e-14);
            const Vec3 expected = blend(field, cell, weight);
            EXPECT_LT(glm::length(field.sampler().velocity(p, 0.0) - expected),
                      1e-11 *
                          glm::length(expected)); // our Newton's iteration ends at 1e-13 of a cell
        }
    }
}

TEST(CellSamplingVsVtk, MeshesOfAllShapesGiveWhatTheStaticCellLocatorGives) {
    std::vector<CellMesh> meshes;
    meshes.push_back(block({12, 20, 9}, round_cylinder, true));
    meshes.push_back(TwoToOne(
                         7,
                         [](const Vec3& c) {
                             return glm::length(c - 0.5) < 0.32 ? TwoToOne::Kind::Fine
                                                                : TwoToOne::Kind::Coarse;
                         },
                         wavy)
                         .take());
    for (CellMesh& mesh : meshes) {
        const MeshedField field(std::move(mesh), swirl);
        const CellSampler sampler = field.sampler();
        const auto grid = as_vtk(*field.mesh);
        const auto locator = vtkSmartPointer<vtkStaticCellLocator>::New();
        locator->SetDataSet(grid);
        locator->BuildLocator();
        const auto cell = vtkSmartPointer<vtkGenericCell>::New();
        std::mt19937 random(43);
        int inside = 0, elsewhere = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec3 p = field.random_point(random);
            double x[3] = {p.x, p.y, p.z};
            double pcoords[3], weight[8];
            const vtkIdType found = locator->FindCell(x, 0.0, cell, pcoords, weight);
            ASSERT_EQ(found >= 0, sampler.status(p) == PointStatus::Inside);
            if (found < 0)
                continue;
            ++inside;
            // VTK's own iteration stops at 1e-3 of a cell, short of its last, quadratic, correction:
            // its weights are those of a point beside this one.
            const MeshCell& its = field.mesh->cells[static_cast<std::size_t>(found)];
            const Vec3 beside = place(field, its, weight);
            EXPECT_LT(glm::length(beside - p), 1e-5);
            // VTK 9.3 takes a cell that ends up to 1e-3 of itself before the point, and extrapolates.
            if (*std::min_element(weight, weight + node_count(its.shape)) < 0 ||
                sampler.status(beside) != PointStatus::Inside) {
                ++elsewhere;
                continue;
            }
            const Vec3 expected = blend(field, its, weight);
            EXPECT_LT(glm::length(sampler.velocity(beside, 0.0) - expected),
                      1e-9 * glm::length(expected));
        }
        EXPECT_GT(inside, 2000);
        EXPECT_LT(elsewhere, inside / 100);
    }
}

TEST(CellSamplingVsVtk, FacesAreVtksInItsOrder) {
    for (CellMesh& mesh : single_cells()) {
        const MeshCell cell = mesh.cells[0];
        const auto grid = as_vtk(mesh);
        vtkCell* peer = grid->GetCell(0);
        ASSERT_EQ(static_cast<std::size_t>(peer->GetNumberOfFaces()), face_count(cell.shape));
        for (std::size_t f = 0; f < face_count(cell.shape); ++f) {
            const CellFace ours = face(cell.shape, f);
            vtkIdList* theirs = peer->GetFace(static_cast<int>(f))->GetPointIds();
            std::vector<std::uint32_t> a, b;
            for (std::size_t i = 0; i < ours.count; ++i)
                a.push_back(cell.node[ours.node[i]]);
            for (vtkIdType i = 0; i < theirs->GetNumberOfIds(); ++i)
                b.push_back(static_cast<std::uint32_t>(theirs->GetId(i)));
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            EXPECT_EQ(a, b) << int(cell.shape) << " " << f;
        }
    }
}

} // namespace wakesurf::core::cell_sampling_vs_vtk_test
