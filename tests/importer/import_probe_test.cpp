// What is sampled from a store is what VTK interpolates in the source: 1,000 random places a kind of grid, through files,
// importer, store and sampler.
#include "core/dataset/time_step_cache.hpp"
#include "core/field/cells/cell_sampler.hpp"
#include "core/field/stored_flow.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/small_blocks.hpp"

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLRectilinearGridWriter.h>
#include <vtkXMLStructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cmath>
#include <random>

namespace wakesurf::importer::import_probe_test {
namespace {

using core::Vec3;

double swirl(const Vec3& p, int c) {
    return c == 0 ? 1.0 + std::sin(2 * p.y) : c == 1 ? std::cos(p.x + p.z) : p.x * p.y - 0.5;
}

class ImportProbe : public Import {
  protected:
    template <class Writer>
    void write(vtkDataSet& data, const std::string& name) const {
        auto writer = vtkSmartPointer<Writer>::New();
        const std::string path = folder_ / name;
        writer->SetFileName(path.c_str());
        writer->SetInputData(&data);
        writer->Write();
    }

    static vtkSmartPointer<vtkDataSet> probed(vtkDataSet& data, const std::vector<Vec3>& places) {
        auto points = vtkSmartPointer<vtkPoints>::New();
        points->SetDataTypeToDouble();
        for (const Vec3& p : places)
            points->InsertNextPoint(p.x, p.y, p.z);
        auto at = vtkSmartPointer<vtkPolyData>::New();
        at->SetPoints(points);
        auto probe = vtkSmartPointer<vtkProbeFilter>::New();
        probe->SetInputData(at);
        probe->SetSourceData(&data);
        probe->Update();
        return probe->GetOutput();
    }

    static std::vector<Vec3> places_in(vtkDataSet& data) {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> part(0.001, 0.999);
        double b[6];
        data.GetBounds(b);
        std::vector<Vec3> places;
        for (int i = 0; i < 1000; ++i)
            places.emplace_back(b[0] + part(random) * (b[1] - b[0]),
                                b[2] + part(random) * (b[3] - b[2]),
                                b[4] + part(random) * (b[5] - b[4]));
        return places;
    }

    // `sample` returns nothing outside of the domain, and so must VTK then.
    template <class Sample>
    static void expect_vtk(vtkDataSet& data, const Sample& sample) {
        const auto places = places_in(data);
        const auto wanted = probed(data, places);
        vtkDataArray* inside = wanted->GetPointData()->GetArray("vtkValidPointMask");
        vtkDataArray* u = wanted->GetPointData()->GetArray("U");
        std::size_t compared = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto id = static_cast<vtkIdType>(i);
            const std::optional<Vec3> got = sample(places[i]);
            ASSERT_EQ(got.has_value(), inside->GetTuple1(id) == 1.0) << i;
            if (!got)
                continue;
            const Vec3 v(u->GetComponent(id, 0), u->GetComponent(id, 1), u->GetComponent(id, 2));
            ASSERT_LE(glm::distance(*got, v), 1e-5 * std::max(glm::length(v), 0.1)) << i;
            ++compared;
        }
        EXPECT_GT(compared, 400u);
    }

    void expect_vtk_on_grid(vtkDataSet& data, const std::string& name) {
        ASSERT_EQ(run(name).status, 0);
        const auto flow = core::make_stored_flow(
            std::make_shared<core::TimeStepCache>(reader(), core::TimeStepCache::Options{}));
        expect_vtk(data, [&](const Vec3& p) -> std::optional<Vec3> {
            const double t = 0.0;
            Vec3 v;
            EXPECT_TRUE(flow->sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
            return flow->status(p) == core::PointStatus::Inside ? std::optional(v) : std::nullopt;
        });
    }

    void expect_vtk_in_cells(vtkDataSet& data, const std::string& name) {
        const auto outcome = run(name);
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        const auto store = reader();
        const core::CellDomain domain(std::get<core::CellMesh>(store->grid()));
        const auto step = store->load(0, {}).value();
        const core::CellSampler field{&domain, step->velocity().data(), nullptr};
        expect_vtk(data, [&](const Vec3& p) -> std::optional<Vec3> {
            return field.status(p) == core::PointStatus::Inside
                       ? std::optional(field.velocity(p, 0.0))
                       : std::nullopt;
        });
    }
};

TEST_F(ImportProbe, OfAnImageEqualsVtk) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(12, 10, 8);
    image->SetSpacing(0.1, 0.2, 0.15);
    image->SetOrigin(-1, 0, 3);
    add_array(*image, true, "U", 3, swirl);
    write<vtkXMLImageDataWriter>(*image, "a.vti");
    expect_vtk_on_grid(*image, "a.vti");
}

TEST_F(ImportProbe, OfARectilinearGridEqualsVtk) {
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    std::array<vtkSmartPointer<vtkDoubleArray>, 3> axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        axes[axis] = vtkSmartPointer<vtkDoubleArray>::New();
        for (int i = 0; i < 12; ++i)
            axes[axis]->InsertNextValue(0.1 * i + 0.01 * i * i * static_cast<double>(axis + 1));
    }
    grid->SetDimensions(12, 12, 12);
    grid->SetXCoordinates(axes[0]);
    grid->SetYCoordinates(axes[1]);
    grid->SetZCoordinates(axes[2]);
    add_array(*grid, true, "U", 3, swirl);
    write<vtkXMLRectilinearGridWriter>(*grid, "a.vtr");
    expect_vtk_on_grid(*grid, "a.vtr");
    EXPECT_EQ(manifest().info.dimensions, (std::array<std::uint32_t, 3>{12, 12, 12}));
}

TEST_F(ImportProbe, OfACurvilinearGridEqualsVtk) {
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    for (int k = 0; k < 6; ++k) // a quarter of a ring
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 10; ++i) {
                const double angle = 1.5707963 * i / 9;
                points->InsertNextPoint((1 + 0.2 * j) * std::cos(angle),
                                        (1 + 0.2 * j) * std::sin(angle), 0.3 * k);
            }
    grid->SetDimensions(10, 8, 6);
    grid->SetPoints(points);
    add_array(*grid, true, "U", 3, swirl);
    write<vtkXMLStructuredGridWriter>(*grid, "a.vts");
    expect_vtk_in_cells(*grid, "a.vts");
    EXPECT_EQ(manifest().info.grid, core::GridKind::Curvilinear);
}

TEST_F(ImportProbe, OfHexahedraEqualsVtk) {
    auto grid = brick({0, 0, 0}, 0.25, {5, 4, 6});
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) { // sheared: still parallelepipeds
        double p[3];
        grid->GetPoint(i, p);
        grid->GetPoints()->SetPoint(i, p[0] + 0.2 * p[2], p[1], p[2]);
    }
    add_array(*grid, true, "U", 3, swirl);
    write<vtkXMLUnstructuredGridWriter>(*grid, "a.vtu");
    expect_vtk_in_cells(*grid, "a.vtu");
}

TEST_F(ImportProbe, OfPolyhedraOfTwoSizesGivesLinearFieldsExactly) {
    auto grid = refined_block();
    const auto linear = [](const Vec3& p, int c) { return 1.0 + p.x - 2.0 * p.y + (c + 1) * p.z; };
    add_array(*grid, true, "U", 3, linear);
    write<vtkXMLUnstructuredGridWriter>(*grid, "a.vtu");
    const auto outcome = run("a.vtu");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto store = reader();
    const core::CellDomain domain(std::get<core::CellMesh>(store->grid()));
    const auto step = store->load(0, {}).value();
    const core::CellSampler field{&domain, step->velocity().data(), nullptr};
    for (const Vec3& p : places_in(*grid)) {
        ASSERT_EQ(field.status(p), core::PointStatus::Inside);
        const Vec3 v = field.velocity(p, 0.0);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(v[c], linear(p, c), 5e-6);
    }
}

} // namespace
} // namespace wakesurf::importer::import_probe_test
