// Sources whose flow repeats: --periodic, in the importer and in the commands that start it.
#include "core/field/stored_flow.hpp"
#include "tests/importer/import_fixture.hpp"

#include <cmath>
#include <numbers>

namespace wakesurf::importer::periodic_import_test {
namespace {

constexpr core::PeriodicAxes along_x{true, false, false};
constexpr double turn = 2.0 * std::numbers::pi;

/// A wave along x of the period 8, on nodes 1 apart. The first is at 0.
double wave(double x) {
    return 2.0 + std::sin(turn / 8.0 * x);
}

VtiText wave_of(int nodes, const std::function<double(double)>& speed = wave) {
    VtiText file;
    file.nodes = {nodes, 3, 3};
    const auto x = [&](std::size_t i) {
        return static_cast<double>(i / 3 % static_cast<std::size_t>(nodes));
    };
    file.points = vti_array("U", 3, file.point_count(),
                            [&](std::size_t i) { return i % 3 == 0 ? speed(x(i)) : 0.0; }) +
                  vti_array("p", 1, file.point_count(), [&](std::size_t i) {
                      return speed(static_cast<double>(i % static_cast<std::size_t>(nodes)));
                  });
    return file;
}

std::string rectilinear(const std::string& coordinates, const VtiText& file) {
    const auto axis = [](const std::string& name, const std::string& values) {
        return "<DataArray type=\"Float64\" Name=\"" + name + "\" format=\"ascii\">" + values +
               "</DataArray>";
    };
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"RectilinearGrid\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<RectilinearGrid WholeExtent=\"" +
           file.extent() + "\">\n<Piece Extent=\"" + file.extent() + "\">\n<PointData>\n" +
           file.points + "</PointData>\n<Coordinates>" + axis("x", coordinates) +
           axis("y", "0 1 2") + axis("z", "0 1 2") +
           "</Coordinates>\n</Piece>\n</RectilinearGrid>\n</VTKFile>\n";
}

/// Two hexahedra along x; `off` moves a node of the last side.
std::string hexahedra(double off) {
    std::string points;
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 3; ++i)
                points += std::to_string(i) + " " +
                          std::to_string(j + (i == 2 && j == 0 && k == 0 ? off : 0.0)) + " " +
                          std::to_string(k) + " ";
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"12\" "
           "NumberOfCells=\"2\">\n<PointData>" +
           vti_array("U", 3, 12, [](std::size_t i) { return i % 3 == 0 ? 1.0 : 0.0; }) +
           "</PointData>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
           "format=\"ascii\">" +
           points +
           "</DataArray></Points>\n<Cells><DataArray type=\"Int64\" Name=\"connectivity\" "
           "format=\"ascii\">0 1 4 3 6 7 10 9 1 2 5 4 7 8 11 10</DataArray><DataArray "
           "type=\"Int64\" Name=\"offsets\" format=\"ascii\">8 16</DataArray><DataArray "
           "type=\"UInt8\" Name=\"types\" format=\"ascii\">12 12</DataArray></Cells>\n"
           "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

class PeriodicImport : public Import {
  protected:
    void expect_note(const std::string& words) const {
        EXPECT_NE(manifest().info.note.find(words), std::string::npos) << manifest().info.note;
    }

    /// Goes from x = 1 in the store's flow, which is steady, for so long.
    core::Vec3 carried(double time) const {
        const auto flow = core::make_stored_flow(
            std::make_shared<core::TimeStepCache>(reader(), core::TimeStepCache::Options{}));
        std::vector<core::Curve> curves(1);
        curves[0].seed = {1.0, 1.0, 1.0};
        curves[0].duration = time;
        core::TraceOptions options;
        options.frozen = true;
        options.longest_step = 1.0;
        EXPECT_TRUE(flow->trace(curves, options, {}));
        EXPECT_EQ(curves[0].end, core::CurveEnd::Time);
        return curves[0].last.position;
    }

    Outcome command(std::vector<std::string> words) const {
        Outcome out;
        const auto done =
            run_child(server_program(), words, 0,
                      [&](std::string_view line) { out.lines.emplace_back(line); }, {});
        out.status = done->exit_status;
        out.errors = done->errors;
        return out;
    }
};

TEST_F(PeriodicImport, TakesAnImageThatEndsWithItsFirstPlaneAsItIs) {
    put("w.vti", wave_of(9).text());
    ASSERT_EQ(run("w.vti", {"--periodic", "x"}).status, 0);
    EXPECT_EQ(manifest().info.dimensions, (std::array<std::uint32_t, 3>{9, 3, 3}));
    EXPECT_EQ(manifest().info.periodic, along_x);
    EXPECT_EQ(manifest().layout.grid.periodic, along_x);
    expect_note("the flow repeats along x: the last plane of nodes is the first again");
    EXPECT_GT(carried(10.0).x, 2 * 8.0);
}

TEST_F(PeriodicImport, AddsThePlaneThatAnImageOfOnePeriodLacks) {
    put("w.vti", wave_of(8).text());
    ASSERT_EQ(run("w.vti", {"--periodic", "x"}).status, 0);
    EXPECT_EQ(manifest().info.dimensions, (std::array<std::uint32_t, 3>{9, 3, 3}));
    EXPECT_EQ(manifest().info.bounds.hi.x, 8.0);
    expect_note("one is added behind it");
    const auto values = velocity(0);
    for (std::size_t row = 0; row < 9; ++row)
        for (std::size_t i = 0; i < 9; ++i)
            EXPECT_NEAR(values[3 * (9 * row + i)], wave(static_cast<double>(i)), 1e-6);
    const auto added = carried(10.0);
    put("w.vti", wave_of(9).text());
    ASSERT_EQ(run("w.vti", {"--periodic", "x"}).status, 0);
    EXPECT_NEAR(carried(10.0).x, added.x, 1e-5);
}

TEST_F(PeriodicImport, AddsThePlaneToARectilinearGridWhoseSpacingIsEvenAtBothEnds) {
    put("even.vtr", rectilinear("0 1 2 3 4 5 6 7", wave_of(8)));
    ASSERT_EQ(run("even.vtr", {"--periodic", "x"}).status, 0);
    EXPECT_EQ(manifest().info.bounds.hi.x, 8.0);
    EXPECT_EQ(manifest().info.points, 81u);
    fs::remove_all(store());
    put("uneven.vtr", rectilinear("0 1 2 3 4 5 6 8", wave_of(8)));
    expect_refusal("uneven.vtr", "its spacing at both ends differs", {"--periodic", "x"});
}

TEST_F(PeriodicImport, RefusesAnImageWhoseFlowDoesNotRepeat) {
    put("w.vti", wave_of(9, [](double x) { return x * x; }).text());
    const auto outcome = run("w.vti", {"--periodic", "x"});
    EXPECT_EQ(outcome.status, 2) << outcome.errors;
    EXPECT_NE(outcome.errors.find("does not repeat along x"), std::string::npos) << outcome.errors;
}

TEST_F(PeriodicImport, SaysWhereTheFlowDoesNotTellWhetherAPlaneIsMissing) {
    put("w.vti", wave_of(9, [](double) { return 1.0; }).text());
    ASSERT_EQ(run("w.vti", {"--periodic", "x"}).status, 0);
    EXPECT_EQ(manifest().info.dimensions, (std::array<std::uint32_t, 3>{9, 3, 3}));
    expect_note("the last plane of nodes is taken for the first again");
}

TEST_F(PeriodicImport, AveragesValuesInCellsOverBothSides) {
    VtiText file;
    file.nodes = {5, 3, 3};
    file.cells = vti_array("U", 3, file.cell_count(), [](std::size_t i) {
        return i % 3 == 0 ? 1.0 + static_cast<double>(i / 3 % 4) : 0.0;
    });
    put("c.vti", file.text());
    ASSERT_EQ(run("c.vti", {"--periodic", "x"}).status, 0);
    EXPECT_EQ(manifest().info.dimensions, (std::array<std::uint32_t, 3>{5, 3, 3}));
    const auto values = velocity(0);
    EXPECT_NEAR(values[0], 2.5, 1e-6); // of the first and the last cell
    EXPECT_NEAR(values[3], 1.5, 1e-6);
    EXPECT_NEAR(values[12], 2.5, 1e-6);
}

TEST_F(PeriodicImport, NeedsMeshesWhoseNodesMatchOnBothSides) {
    put("m.vtu", hexahedra(0.0));
    ASSERT_EQ(run("m.vtu", {"--periodic", "x"}).status, 0);
    EXPECT_EQ(manifest().info.periodic, along_x);
    fs::remove_all(store());
    put("m.vtu", hexahedra(0.1));
    expect_refusal("m.vtu",
                   "cannot repeat along x: 1 of 4 nodes on one side of its box have none on the "
                   "other",
                   {"--periodic", "x"});
}

TEST_F(PeriodicImport, IsAskedForByAxesAndIsAnotherStoreThanWithoutThem) {
    put("w.vti", wave_of(9).text());
    for (const char* const wrong : {"", "w", "x,", "x,x", "xy", "x;y"})
        EXPECT_EQ(run("w.vti", {std::string("--periodic=") + wrong}).status, 2) << wrong;
    ASSERT_EQ(run("w.vti").status, 0);
    EXPECT_EQ(manifest().info.periodic, core::PeriodicAxes{});
    ASSERT_EQ(run("w.vti", {"--periodic=x,z"}).status, 0);
    EXPECT_EQ(manifest().info.periodic, (core::PeriodicAxes{true, false, true}));
}

TEST_F(PeriodicImport, IsTakenByTheCommandsThatTakeADataset) {
    const std::string file = put("w.vti", wave_of(8).text());
    const auto info = command({"info", file, "--periodic", "x"});
    EXPECT_EQ(info.status, 0) << info.errors;
    EXPECT_NE(std::find(info.lines.begin(), info.lines.end(), "  periodic  x"), info.lines.end());
    const auto surface = command({"surface", file, "--store", folder_ / "cache", "--kind", "stream",
                                  "--rake", "1,0.5,1 1,1.5,1", "--from", "0", "--to", "10",
                                  "--periodic", "x", "-o", folder_ / "s.vtp"});
    EXPECT_EQ(surface.status, 0) << surface.errors;
    ASSERT_EQ(run("w.vti", {"--periodic", "x"}).status, 0);
    const auto refused = command({"info", store(), "--periodic", "x"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.errors.find("store is a store"), std::string::npos) << refused.errors;
    const auto flow = command({"info", "flow:abc", "--periodic", "x"});
    EXPECT_NE(flow.errors.find("is a built-in flow"), std::string::npos) << flow.errors;
}

} // namespace
} // namespace wakesurf::importer::periodic_import_test
