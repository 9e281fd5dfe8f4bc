// Sampling on rectilinear grids is VTK's own interpolation.
#include "core/field/grid_sampling.hpp"
#include "core/field/rectilinear_axes.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/swarm.hpp"

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <random>

namespace wakesurf::core::rectilinear_sampling_test {
namespace {

RectilinearGrid uneven() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> step(0.02, 0.4);
    RectilinearGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double at = -1.0;
        for (std::size_t i = 0; i < 14 + 3 * axis; ++i)
            grid.coordinates[axis].push_back(at += step(random));
    }
    return grid;
}

vtkSmartPointer<vtkRectilinearGrid> in_vtk(const RectilinearGrid& grid) {
    auto out = vtkSmartPointer<vtkRectilinearGrid>::New();
    const auto array = [&](std::size_t axis) {
        auto values = vtkSmartPointer<vtkDoubleArray>::New();
        for (const double x : grid.coordinates[axis])
            values->InsertNextValue(x);
        return values;
    };
    out->SetDimensions(static_cast<int>(grid.coordinates[0].size()),
                       static_cast<int>(grid.coordinates[1].size()),
                       static_cast<int>(grid.coordinates[2].size()));
    out->SetXCoordinates(array(0));
    out->SetYCoordinates(array(1));
    out->SetZCoordinates(array(2));
    return out;
}

TEST(RectilinearSampling, EqualsVtksInterpolationAtAThousandPoints) {
    const RectilinearGrid grid = uneven();
    const auto vtk = in_vtk(grid);
    const tests::SampledSource source(grid, {0.0}, [](const Vec3& p, double) {
        return Vec3(std::sin(5.0 * p.x) + p.y, std::cos(3.0 * p.y * p.z), p.z * p.z - p.x);
    });
    const auto step = source.load(0, {}).value();
    const RectilinearAxes axes(grid);
    const SolidMask none;
    const CellMask cells(axes.dimensions(), none);
    const auto field = linear_sampler(axes, cells, none, {nullptr, step, nullptr, nullptr});
    const auto points = tests::random_points(grid.bounds(), 1000, 31);
    for (const Vec3& p : points) {
        double position[3] = {p.x, p.y, p.z};
        double parametric[3];
        double weights[8];
        int part = 0;
        const vtkIdType cell =
            vtk->FindCell(position, nullptr, 0, 1e-12, part, parametric, weights);
        ASSERT_GE(cell, 0);
        vtkNew<vtkIdList> nodes;
        vtk->GetCellPoints(cell, nodes);
        Vec3 expected(0.0);
        for (vtkIdType i = 0; i < 8; ++i) {
            const float* v = step->velocity().data() + 3 * nodes->GetId(i);
            expected += weights[i] * Vec3(v[0], v[1], v[2]);
        }
        EXPECT_LT(glm::length(field.velocity(p, 0.0) - expected), 1e-9);
    }
}

} // namespace
} // namespace wakesurf::core::rectilinear_sampling_test
