#include "tests/bench/vtk/stream_surface.hpp"

#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/vtk/image_of.hpp"

#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkStreamSurface.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::bench {

using core::Vec3;

double Triangles::area() const {
    double sum = 0.0;
    for (const auto& [a, b, c] : corner)
        sum += 0.5 * glm::length(glm::cross(position[b] - position[a], position[c] - position[a]));
    return sum;
}

double Triangles::longest_side() const {
    double longest = 0.0;
    for (const auto& [a, b, c] : corner) {
        std::array sides{glm::distance(position[a], position[b]),
                         glm::distance(position[b], position[c]),
                         glm::distance(position[c], position[a])};
        std::sort(sides.begin(), sides.end());
        longest = std::max(longest, sides[1]);
    }
    return longest;
}

double VtkStreamSurface::build(Triangles* result) const {
    vtkNew<vtkImageData> image;
    show_as_image(flow->grid, flow->step(0), image);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(static_cast<int>(rake.seeds));
    const core::SeedingCurve seeding(rake);
    for (std::uint32_t i = 0; i < rake.seeds; ++i) {
        const Vec3 p = seeding.at(static_cast<double>(i) / (rake.seeds - 1));
        lines->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    }
    vtkNew<vtkPolyData> seeds;
    seeds->SetPoints(points);
    seeds->SetLines(lines);
    const double step = step_in_cells * flow->spacing();
    vtkNew<vtkStreamSurface> filter;
    filter->SetInputData(0, image);
    filter->SetInputData(1, seeds);
    filter->SetUseIterativeSeeding(true);
    filter->SetIntegratorTypeToRungeKutta4();
    filter->SetIntegrationDirectionToForward();
    filter->SetComputeVorticity(false);
    filter->SetIntegrationStepUnit(vtkStreamTracer::LENGTH_UNIT);
    filter->SetInitialIntegrationStep(step);
    filter->SetMaximumPropagation(arc_in_cells * flow->spacing());
    filter->SetMaximumNumberOfSteps(std::lround(arc_in_cells / step_in_cells));
    const double seconds = seconds_of([&] { filter->Update(); });
    if (!result)
        return seconds;
    vtkPolyData* output = filter->GetOutput();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i) {
        double p[3];
        output->GetPoint(i, p);
        result->position.emplace_back(p[0], p[1], p[2]);
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    vtkCellArray* polygons = output->GetPolys();
    for (polygons->InitTraversal(); polygons->GetNextCell(count, ids);)
        result->corner.push_back({static_cast<std::uint32_t>(ids[0]),
                                  static_cast<std::uint32_t>(ids[1]),
                                  static_cast<std::uint32_t>(ids[2])});
    return seconds;
}

} // namespace wakesurf::bench
