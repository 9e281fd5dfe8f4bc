// EnSight Gold cases whose variables exist on some parts only: solids, walls, and what is left out.
#include "importer/sources/files/formats.hpp"
#include "tests/support/ensight_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkGenericEnSightReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>

#include <set>

namespace wakesurf::importer::ensight_parts_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

// As foamToEnsight and others write them: a file of values names only the parts that have the variable.
class EnsightParts : public testing::Test {
  protected:
    void put_box(EnsightText& out, int part, const char* name, float x) const {
        out.line("part");
        out.integers({part});
        out.line(name);
        out.line("block uniform");
        out.integers({3, 3, 3});
        out.numbers({x, 0, 0});
        out.numbers({0.5, 0.5, 0.5});
    }

    void put_values(const std::string& file, const std::vector<int>& parts, int count) const {
        EnsightText out(EnsightEncoding::Text);
        out.line("a variable");
        for (const int part : parts) {
            out.line("part");
            out.integers({part});
            out.line(part == 3 ? "coordinates" : "block");
            for (int c = 0; c < count; ++c)
                out.numbers(std::vector<float>(part == 3 ? 4 : 27, 2.5f));
        }
        write_file(folder_ / file, out.text());
    }

    // A box of fluid, a box of solid beside it and a wall below the fluid.
    void SetUp() override {
        EnsightText out(EnsightEncoding::Text);
        for (const char* const line : {"a", "b", "node id off", "element id off"})
            out.line(line);
        put_box(out, 1, "fluid", 0);
        put_box(out, 2, "heater", 1);
        out.line("part");
        out.integers({3});
        out.line("lower wall");
        out.line("coordinates");
        out.integers({4});
        out.numbers({0, 1, 1, 0});
        out.numbers({0, 0, 1, 1});
        out.numbers({0, 0, 0, 0});
        out.line("quad4");
        out.integers({1});
        out.integers({1, 2, 3, 4});
        write_file(folder_ / "g", out.text());
        put_values("vel", {1}, 3);
        put_values("p", {1}, 1);
        put_values("T", {1, 2}, 1);
        put_values("yplus", {3}, 1);
        put_values("shear", {3}, 3);
        put_values("flux", {2}, 3);
    }

    fs::path put_case(const std::string& variables, const std::string& times = {}) const {
        write_file(folder_ / "flow.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: g\n"
                                          "VARIABLE\n" +
                                              variables + times);
        return folder_ / "flow.case";
    }

    TemporaryFolder folder_;
};

TEST_F(EnsightParts, WithoutTheVelocityAreSolidsAndVariablesOfWallsAreLeftOut) {
    const auto file = put_case("scalar per node: yplus yplus\nvector per node: wall_shear shear\n"
                               "vector per node: heat_flux flux\nscalar per node: T T\n"
                               "vector per node: velocity vel\nscalar per node: p p\n");
    const auto vtk = vtkSmartPointer<vtkGenericEnSightReader>::New();
    vtk->SetCaseFileName(file.c_str());
    vtk->ReadAllVariablesOn();
    vtk->Update();
    ASSERT_EQ(vtk->GetOutput()->GetNumberOfBlocks(), 3u); // VTK takes the same files
    const auto source = open_ensight(file);
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto& description = (*source)->description();
    std::set<std::string> names;
    for (const auto& field : description.fields)
        names.insert(field.name);
    EXPECT_EQ(names, (std::set<std::string>{"velocity", "T", "p"}));
    EXPECT_NE(description.note.find("only some parts have them: yplus, wall_shear"),
              std::string::npos)
        << description.note;
    const auto step = (*source)->read(0, description.fields);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    ASSERT_EQ(step->blocks.size(), 1u);
    EXPECT_EQ(step->blocks[0]->GetBounds()[0], 0.0);
    EXPECT_EQ(step->blocks[0]->GetPointData()->GetArray("velocity")->GetComponent(26, 2), 2.5);
    ASSERT_EQ(step->solids.size(), 1u);
    EXPECT_EQ(step->solids[0]->GetBounds()[1], 2.0);
    EXPECT_EQ(step->walls.size(), 1u);
}

TEST_F(EnsightParts, LeaveOutVariablesWithValuesAtSomeNodesOnly) {
    std::string text = read_file(folder_ / "p");
    text.replace(text.find("block"), 5, "block partial");
    write_file(folder_ / "p", text);
    const auto source =
        open_ensight(put_case("vector per node: velocity vel\nscalar per node: p p\n"));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->description().fields.size(), 1u);
    EXPECT_NE((*source)->description().note.find("p has values at some elements only"),
              std::string::npos)
        << (*source)->description().note;
}

TEST_F(EnsightParts, ReadAVelocityOfThreeScalars) {
    const auto source =
        open_ensight(put_case("scalar per node: x_velocity p\nscalar per node: y_velocity p\n"
                              "scalar per node: z_velocity T\n"));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->description().fields.size(), 3u);
    EXPECT_EQ((*source)->read(0, (*source)->description().fields)->blocks.size(), 1u);
}

TEST_F(EnsightParts, LeaveOutAScalarWhoseFileOneTimeLacks) {
    for (const char* const number : {"0", "1", "2"}) {
        put_values(std::string("v.") + number, {1}, 3);
        if (*number != '1')
            put_values(std::string("p.") + number, {1}, 1);
    }
    const auto source =
        open_ensight(put_case("vector per node: 1 velocity v.*\nscalar per node: 1 p p.*\n",
                              "TIME\ntime set: 1\nnumber of steps: 3\nfilename start number: 0\n"
                              "filename increment: 1\ntime values: 0 1 2\n"));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->description().note, "left out, as files are missing: p");
    EXPECT_EQ((*source)->description().fields.size(), 1u);
    for (std::size_t step = 0; step < 3; ++step)
        EXPECT_TRUE((*source)->read(step, (*source)->description().fields).has_value());
}

TEST_F(EnsightParts, AreNoPlaneWhereThereAreCellsInSpaceAndFlatBlocksBesideThemAreLeftOut) {
    EnsightText out(EnsightEncoding::Text);
    for (const char* const line : {"a", "b", "node id off", "element id off"})
        out.line(line);
    put_box(out, 1, "fluid", 0);
    out.line("part");
    out.integers({2});
    out.line("slice");
    out.line("block uniform");
    out.integers({3, 3, 1});
    out.numbers({0, 0, 0.5});
    out.numbers({0.5, 0.5, 0.5});
    write_file(folder_ / "g", out.text());
    const auto source = open_ensight(put_case("vector per node: velocity vel\n"));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto step = (*source)->read(0, (*source)->description().fields);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    ASSERT_EQ(step->blocks.size(), 1u);
    EXPECT_EQ(step->blocks[0]->GetNumberOfPoints(), 27);
    EXPECT_TRUE(step->solids.empty());
}

} // namespace
} // namespace wakesurf::importer::ensight_parts_test
