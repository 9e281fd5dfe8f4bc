// Where a file has no value no one is told one: neither a probe nor a vertex, of the velocity or of a scalar; and at the border of what
// is known both have the fluid's.
#include "core/dataset/time_step_cache.hpp"
#include "core/field/sample_scalar.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "store/store_layout.hpp"
#include "tests/importer/import_fixture.hpp"
#include "tests/importer/netcdf_files.hpp"
#include "tests/importer/vtk_files.hpp"
#include "tests/support/ensight_text.hpp"

#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <sstream>

namespace wakesurf::importer::no_value_test {
namespace {

using core::Vec3;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double border = 1.75; // along z, of 0 to 2 in eight cells

enum class Missing { Numbers, Cells, Points };

/// u = (1, 0.3 z, 0.2) and q = 1 + z at nodes, as far as they are known.
void fill(vtkDataSet& data, Missing missing) {
    auto u = vtkSmartPointer<vtkDoubleArray>::New();
    u->SetName("velocity");
    u->SetNumberOfComponents(3);
    auto q = vtkSmartPointer<vtkDoubleArray>::New();
    q->SetName("q");
    auto hidden = vtkSmartPointer<vtkUnsignedCharArray>::New();
    hidden->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
        const double z = data.GetPoint(i)[2];
        const bool known = missing != Missing::Numbers || z < border + 0.01;
        const double gone = missing == Missing::Numbers ? nan : 77.0;
        u->InsertNextTuple3(z < border + 0.01 ? 1.0 : gone, z < border + 0.01 ? 0.3 * z : gone,
                            z < border + 0.01 ? 0.2 : gone);
        q->InsertNextValue(known && z < border + 0.01 ? 1.0 + z : gone);
        if (missing == Missing::Points)
            hidden->InsertNextValue(z > border + 0.01 ? vtkDataSetAttributes::HIDDENPOINT : 0);
    }
    data.GetPointData()->AddArray(u);
    data.GetPointData()->AddArray(q);
    for (vtkIdType i = 0; missing == Missing::Cells && i < data.GetNumberOfCells(); ++i)
        hidden->InsertNextValue(
            tests::cell_centre(data, i)[2] > border ? vtkDataSetAttributes::HIDDENCELL : 0);
    if (missing == Missing::Points)
        data.GetPointData()->AddArray(hidden);
    if (missing == Missing::Cells)
        data.GetCellData()->AddArray(hidden);
}

Vec3 node(int i, int j, int k) {
    return 0.25 * Vec3(i, j, k);
}

template <class Visit>
void each_node(const Visit& visit) {
    for (int k = 0; k <= 8; ++k)
        for (int j = 0; j <= 8; ++j)
            for (int i = 0; i <= 8; ++i)
                visit(node(i, j, k));
}

vtkSmartPointer<vtkPoints> points() {
    auto out = vtkSmartPointer<vtkPoints>::New();
    each_node([&](const Vec3& p) { out->InsertNextPoint(p.x, p.y, p.z); });
    return out;
}

vtkSmartPointer<vtkDataSet> grid_of(const std::string& ending) {
    if (ending == "vti") {
        auto image = vtkSmartPointer<vtkImageData>::New();
        image->SetDimensions(9, 9, 9);
        image->SetSpacing(0.25, 0.25, 0.25);
        return image;
    }
    if (ending == "vtr") {
        auto axis = vtkSmartPointer<vtkDoubleArray>::New();
        for (int i = 0; i <= 8; ++i)
            axis->InsertNextValue(i == 3 ? 0.76 : 0.25 * i);
        auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
        grid->SetDimensions(9, 9, 9);
        grid->SetXCoordinates(axis);
        grid->SetYCoordinates(axis);
        grid->SetZCoordinates(axis);
        return grid;
    }
    if (ending == "vts") {
        auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
        grid->SetDimensions(9, 9, 9);
        grid->SetPoints(points());
        return grid;
    }
    auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    mesh->SetPoints(points());
    for (vtkIdType k = 0; k < 8; ++k)
        for (vtkIdType j = 0; j < 8; ++j)
            for (vtkIdType i = 0; i < 8; ++i) {
                const vtkIdType a = i + 9 * (j + 9 * k);
                const std::array<vtkIdType, 8> nodes{a,      a + 1,  a + 10, a + 9,
                                                     a + 81, a + 82, a + 91, a + 90};
                mesh->InsertNextCell(VTK_HEXAHEDRON, 8, nodes.data());
            }
    return mesh;
}

class NoValue : public Import {
  protected:
    std::string write(const std::string& ending, Missing missing) {
        const auto data = grid_of(ending);
        fill(*data, missing);
        const std::string name =
            std::string(1, "ncp"[static_cast<std::size_t>(missing)]) + "." + ending;
        auto writer = vtkSmartPointer<vtkXMLDataSetWriter>::New();
        writer->SetFileName((folder_ / name).c_str());
        writer->SetInputData(data);
        EXPECT_EQ(writer->Write(), 1);
        return name;
    }

    // Of a store that was just made: as `fill` says, and nothing above the border. Removes it.
    void expect_known_up_to_the_border(const std::string& scalar = "q") {
        const std::vector<Vec3> places{{1, 1, 1.6}, {1, 1, border}, {1, 1, 1.8}, {1.1, 0.9, 1.95}};
        const std::vector<double> now(places.size(), 0.0);
        const auto store = reader();
        const auto field = store::find_scalar(store->layout(), scalar).value();
        const auto flow = core::make_stored_flow(
            std::make_shared<core::TimeStepCache>(store, core::TimeStepCache::Options{}));
        std::vector<std::uint8_t> gap(places.size());
        ASSERT_TRUE(flow->mark_gaps(places, now, gap, {}));
        const auto q = core::sample_scalar(*flow, *store, field, places, now, {}).value();
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool there = flow->status(places[i]) == core::PointStatus::Inside && !gap[i];
            EXPECT_EQ(there, places[i].z <= border) << i;
            EXPECT_EQ(std::isnan(q[i]), !there) << i;
            if (there) {
                EXPECT_NEAR(q[i], 1.0 + places[i].z, 1e-5) << i;
            }
        }
        const core::Rake rake{core::Rake::Kind::Line, {{0.1, 0.3, 1.6}, {0.1, 0.9, 1.65}}, 9};
        const auto surface = core::build_surface(
            *flow, rake,
            {.kind = core::SurfaceKind::Stream, .from = 0, .to = 1.5, .separation = 0.11});
        ASSERT_TRUE(surface.has_value()) << surface.error().message;
        const auto& mesh = surface->mesh;
        const auto at = core::sample_scalar(*flow, *store, field, mesh.position,
                                            std::vector(mesh.vertices(), 0.0), {})
                            .value();
        ASSERT_GT(mesh.cells.size(), 20u);
        double highest = 0.0;
        for (std::size_t i = 0; i < mesh.vertices(); ++i) {
            const double z = mesh.position[i].z;
            highest = std::max(highest, z);
            ASSERT_LT(glm::length(Vec3(mesh.velocity[i]) - Vec3(1.0, 0.3 * z, 0.2)), 1e-4) << z;
            ASSERT_NEAR(at[i], 1.0 + z, 1e-4) << z;
        }
        EXPECT_NEAR(highest, border, 1e-5);
        std::filesystem::remove_all(this->store());
    }
};

TEST_F(NoValue, IsToldToNoOneAndTheBorderHasTheFluids) {
    for (const std::string ending : {"vti", "vtr", "vts", "vtu"})
        for (const Missing missing : {Missing::Numbers, Missing::Cells, Missing::Points}) {
            SCOPED_TRACE(ending + " " + std::to_string(int(missing)));
            const auto outcome = run(write(ending, missing));
            ASSERT_EQ(outcome.status, 0) << outcome.errors;
            expect_known_up_to_the_border();
        }
}

using Value = std::function<double(const Vec3&)>;

const std::array<Value, 4> velocity_and_q{
    [](const Vec3&) { return 1.0; }, [](const Vec3& p) { return 0.3 * p.z; },
    [](const Vec3&) { return 0.2; }, [](const Vec3& p) { return 1.0 + p.z; }};

// At all nodes, x fastest; `gone` above the border.
std::vector<float> at_nodes(const Value& value, float gone) {
    std::vector<float> out;
    each_node([&](const Vec3& p) {
        out.push_back(p.z > border + 0.01 ? gone : static_cast<float>(value(p)));
    });
    return out;
}

std::vector<std::int32_t> blanks() {
    std::vector<std::int32_t> out;
    each_node([&](const Vec3& p) { out.push_back(p.z > border + 0.01 ? 0 : 1); });
    return out;
}

TEST_F(NoValue, IsWhatEnsightCallsUndefinedOrBlanks) {
    for (const bool undefined : {true, false}) {
        SCOPED_TRACE(undefined ? "undef" : "iblanked");
        constexpr float gone = 77.0F; // an ordinary number: only the word tells
        EnsightText mesh(EnsightEncoding::Text);
        for (const char* const line : {"a", "b", "node id off", "element id off", "part"})
            mesh.line(line);
        mesh.integers({1});
        mesh.line("box");
        mesh.line(undefined ? "block uniform" : "block uniform iblanked");
        mesh.integers({9, 9, 9});
        mesh.numbers({0, 0, 0});
        mesh.numbers({0.25, 0.25, 0.25});
        if (!undefined)
            mesh.integers(blanks());
        put("mesh", mesh.text());
        const auto variable = [&](const std::string& name, std::span<const Value> components) {
            EnsightText out(EnsightEncoding::Text);
            out.line(name);
            out.line("part");
            out.integers({1});
            out.line(undefined ? "block undef" : "block");
            if (undefined)
                out.numbers({gone});
            for (const auto& component : components)
                out.numbers(at_nodes(component, gone));
            put(name, out.text());
        };
        variable("u", std::span(velocity_and_q).first(3));
        variable("q", std::span(velocity_and_q).last(1));
        put("flow.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: mesh\nVARIABLE\n"
                         "vector per node: velocity u\nscalar per node: q q\n");
        const auto outcome = run("flow.case");
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        expect_known_up_to_the_border();
    }
}

TEST_F(NoValue, IsWhatNetcdfCallsFillOrMissingOrOutOfItsValidRange) {
    for (const std::string attribute : {"_FillValue", "missing_value", "valid_max"}) {
        SCOPED_TRACE(attribute);
        {
            NetcdfWriter out(folder_ / "flow.nc");
            const Names order{"z", "y", "x"};
            std::vector<int> axes;
            for (const auto& name : order)
                out.dimension(name, 9);
            for (const auto& name : order) {
                axes.push_back(out.variable(name, NC_DOUBLE, {name}));
                out.text(axes.back(), "axis", std::string(1, static_cast<char>(name[0] - 32)));
            }
            std::vector<int> variables;
            for (const std::string name : {"u", "v", "w", "q"}) {
                variables.push_back(out.variable(name, NC_FLOAT, order));
                out.number(variables.back(), attribute.c_str(), NC_FLOAT,
                           attribute == "valid_max" ? 50.0 : 77.0);
            }
            out.end();
            std::vector<double> along;
            for (int i = 0; i <= 8; ++i)
                along.push_back(0.25 * i);
            for (const int axis : axes)
                out.put(axis, along);
            for (std::size_t v = 0; v < variables.size(); ++v) {
                const auto values = at_nodes(velocity_and_q[v], 77.0F);
                out.put(variables[v], {0, 0, 0}, {9, 9, 9}, {values.begin(), values.end()});
            }
        }
        const auto outcome = run("flow.nc");
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        expect_known_up_to_the_border();
    }
}

TEST_F(NoValue, IsWherePlot3dBlanks) {
    std::ostringstream grid;
    std::ostringstream solution;
    const auto add = [](std::ostream& out, const auto& numbers) {
        for (const auto number : numbers)
            out << number << '\n';
    };
    grid << "9 9 9\n";
    for (int axis = 0; axis < 3; ++axis)
        add(grid, [&] {
            std::vector<double> out;
            each_node([&](const Vec3& p) { out.push_back(p[axis]); });
            return out;
        }());
    add(grid, blanks());
    put("flow.xyz", grid.str());
    solution << "9 9 9\n0.2 0 100 0\n";
    const auto& density = velocity_and_q[3];
    add(solution, at_nodes(density, 77.0F));
    for (std::size_t c = 0; c < 3; ++c)
        add(solution,
            at_nodes([&](const Vec3& p) { return density(p) * velocity_and_q[c](p); }, 77.0F));
    add(solution, at_nodes(density, 77.0F)); // energy
    put("flow.q", solution.str());
    const auto outcome = run("flow.xyz");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    expect_known_up_to_the_border("Density");
}

} // namespace
} // namespace wakesurf::importer::no_value_test
