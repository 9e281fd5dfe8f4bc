// EnSight Gold cases made here: what the source returns of them, and what it refuses.
#include "importer/sources/ensight/ensight_case.hpp"
#include "importer/sources/files/formats.hpp"
#include "tests/support/ensight_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericEnSightReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>

#include <cmath>
#include <sstream>

namespace wakesurf::importer::ensight_source_test {
namespace {

using namespace tests;
using core::Error;
namespace fs = std::filesystem;

using Source_ = core::FieldInfo::Source;
constexpr int cells = 6;
constexpr int nodes = 17;

// The last two are one number in 32 bits.
const std::vector<double> times{0.0, 0.25, 1000.00101, 1000.00102};

float value_at(int index, int component, int step) {
    return 0.125f * static_cast<float>(index) + 10.0f * static_cast<float>(component) -
           100.0f * static_cast<float>(step);
}

std::int32_t node(int i, int j, int k) {
    return i + 4 * j + 8 * k + 1;
}

// A hexahedron, two wedges, a box as a polyhedron, a pyramid and a tetrahedron.
void write_fluid(EnsightText& out, float last_x) {
    out.line("part");
    out.integers({1});
    out.line("fluid");
    out.line("coordinates");
    out.integers({nodes});
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> along;
        for (int n = 0; n < 16; ++n)
            along.push_back(static_cast<float>(axis == 0 ? n % 4 : axis == 1 ? n / 4 % 2 : n / 8));
        along.push_back(axis == 0 ? last_x : axis == 1 ? 0.5f : 2.0f);
        out.numbers(along);
    }
    out.line("hexa8");
    out.integers({1});
    out.integers({node(0, 0, 0), node(1, 0, 0), node(1, 1, 0), node(0, 1, 0), node(0, 0, 1),
                  node(1, 0, 1), node(1, 1, 1), node(0, 1, 1)});
    out.line("tria3"); // of another dimension between them
    out.integers({1});
    out.integers({node(0, 0, 0), node(1, 0, 0), node(1, 1, 0)});
    out.line("penta6");
    out.integers({2});
    out.integers({node(1, 0, 0), node(2, 0, 0), node(1, 1, 0), node(1, 0, 1), node(2, 0, 1),
                  node(1, 1, 1), node(2, 0, 0), node(2, 1, 0), node(1, 1, 0), node(2, 0, 1),
                  node(2, 1, 1), node(1, 1, 1)},
                 6);
    out.line("nfaced");
    out.integers({1});
    out.integers({6});
    out.integers({4, 4, 4, 4, 4, 4}, 1);
    out.integers({node(2, 0, 0), node(2, 1, 0), node(3, 1, 0), node(3, 0, 0), node(2, 0, 1),
                  node(3, 0, 1), node(3, 1, 1), node(2, 1, 1), node(2, 0, 0), node(3, 0, 0),
                  node(3, 0, 1), node(2, 0, 1), node(2, 1, 0), node(2, 1, 1), node(3, 1, 1),
                  node(3, 1, 0), node(2, 0, 0), node(2, 0, 1), node(2, 1, 1), node(2, 1, 0),
                  node(3, 0, 0), node(3, 1, 0), node(3, 1, 1), node(3, 0, 1)},
                 4);
    out.line("pyramid5");
    out.integers({1});
    out.integers({node(0, 0, 1), node(1, 0, 1), node(1, 1, 1), node(0, 1, 1), nodes});
    out.line("tetra4");
    out.integers({1});
    out.integers({node(1, 0, 1), node(2, 0, 1), node(1, 1, 1), nodes});
}

struct Flat {
    const char* name;
    float x; ///< of a square at the bottom of the fluid
    float velocity;
};

const std::vector<Flat> flats{{"Lower_Wall", 0.0f, 1.0f},
                              {"body", 1.0f, 0.0f},
                              {"outlet", 2.0f, 3.0f},
                              {"wall elsewhere", 0.5f, 0.0f}};

std::string geometry(EnsightEncoding encoding, float last_x = 0.5f) {
    EnsightText out(encoding);
    if (encoding == EnsightEncoding::Fortran)
        out.line("Fortran Binary");
    else if (encoding != EnsightEncoding::Text)
        out.line("C Binary");
    for (const char* const line : {"a mesh", "of a test", "node id assign", "element id assign"})
        out.line(line);
    write_fluid(out, last_x);
    for (std::size_t f = 0; f < flats.size(); ++f) {
        out.line("part");
        out.integers({static_cast<std::int32_t>(f) + 2});
        out.line(flats[f].name);
        out.line("coordinates");
        out.integers({4});
        out.numbers({flats[f].x, flats[f].x + 1, flats[f].x + 1, flats[f].x});
        out.numbers({0, 0, 1, 1});
        out.numbers({0, 0, 0, 0});
        out.line("quad4");
        out.integers({1});
        out.integers({1, 2, 3, 4});
    }
    return out.text();
}

std::string variable(EnsightEncoding encoding, int components, Source_ source, int step) {
    EnsightText out(encoding);
    const bool at_nodes = source == Source_::Point;
    out.line("a variable");
    const auto section = [&](const char* type, int first, int count) {
        out.line(type);
        for (int c = 0; c < components; ++c) {
            std::vector<float> values;
            for (int i = first; i < first + count; ++i)
                values.push_back(value_at(i, c, step));
            out.numbers(values);
        }
    };
    out.line("part");
    out.integers({1});
    if (at_nodes) {
        section("coordinates", 0, nodes);
    } else {
        section("hexa8", 0, 1);
        section("tria3", 90, 1);
        section("penta6", 1, 2);
        section("nfaced", 3, 1);
        section("pyramid5", 4, 1);
        section("tetra4", 5, 1);
    }
    for (std::size_t f = 0; f < flats.size(); ++f) {
        out.line("part");
        out.integers({static_cast<std::int32_t>(f) + 2});
        out.line(at_nodes ? "coordinates" : "quad4");
        for (int c = 0; c < components; ++c)
            out.numbers(std::vector<float>(at_nodes ? 4 : 1, flats[f].velocity));
    }
    return out.text();
}

class EnsightSource : public testing::Test {
  protected:
    fs::path put(EnsightEncoding encoding, Source_ source, const std::string& more = "") const {
        const std::string place = source == Source_::Point ? "node" : "element";
        write_file(folder_ / "mesh.geo", geometry(encoding));
        for (int step = 0; step < 4; ++step) {
            const std::string number = "00" + std::to_string(10 + 5 * step);
            write_file(folder_ / ("U." + number), variable(encoding, 3, source, step));
            write_file(folder_ / ("p." + number), variable(encoding, 1, source, step));
        }
        write_file(
            folder_ / "flow.case",
            "# made here\nFORMAT\ntype:  ensight gold\n\nGEOMETRY\nmodel:  mesh.geo\n\nVARIABLE\n"
            "vector per " +
                place + ": 1 U U.****\nscalar per " + place + ": 1 p p.****\n" + more +
                "\nTIME\ntime set: 1\nnumber of steps: 4\nfilename start number: 10\nfilename "
                "increment: 5\n"
                "time values: 0 0.25\n1000.00101 1000.00102\n");
        return folder_ / "flow.case";
    }

    core::Result<SourceStep> read(std::size_t step) const {
        const auto source = open_ensight(folder_ / "flow.case");
        if (!source)
            return tl::unexpected(source.error());
        return (*source)->read(step, (*source)->description().fields);
    }

    TemporaryFolder folder_;
};

void expect_values(const SourceStep& step, int index, Source_ source) {
    ASSERT_EQ(step.blocks.size(), 1u);
    vtkDataSet& block = *step.blocks.front();
    ASSERT_EQ(block.GetNumberOfCells(), cells);
    ASSERT_EQ(block.GetNumberOfPoints(), nodes);
    const bool at_nodes = source == Source_::Point;
    vtkDataSetAttributes* data = block.GetCellData();
    if (at_nodes)
        data = block.GetPointData();
    vtkDataArray* u = data->GetArray("U");
    vtkDataArray* p = data->GetArray("p");
    ASSERT_TRUE(u != nullptr && p != nullptr);
    ASSERT_EQ(u->GetNumberOfTuples(), at_nodes ? nodes : cells);
    for (int i = 0; i < static_cast<int>(u->GetNumberOfTuples()); ++i) {
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(u->GetComponent(i, c), static_cast<double>(value_at(i, c, index)));
        ASSERT_EQ(p->GetTuple1(i), static_cast<double>(value_at(i, 0, index)));
    }
}

class EveryEncoding : public EnsightSource,
                      public testing::WithParamInterface<std::tuple<EnsightEncoding, Source_>> {};

TEST_P(EveryEncoding, GivesEveryValueOfEveryTimeStep) {
    const auto [encoding, where] = GetParam();
    const auto source = open_ensight(put(encoding, where));
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto& description = (*source)->description();
    EXPECT_EQ(description.name, "flow");
    EXPECT_EQ(description.times, times);
    ASSERT_EQ(description.fields.size(), 2u);
    EXPECT_EQ(description.fields[0].name, "U");
    EXPECT_EQ(description.fields[0].components, 3);
    EXPECT_EQ(description.fields[0].source, where);
    EXPECT_EQ(description.fields[1].components, 1);
    for (const int step : {3, 1, 0, 2}) {
        const auto read = (*source)->read(static_cast<std::size_t>(step), description.fields);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        expect_values(*read, step, where);
    }
    EXPECT_EQ((*source)->shared_files()->size(), 2u);
    EXPECT_EQ((*source)->files(1)->front().name, "U.0015");
}

// Also where it would print, so that both read the same.
TEST_P(EveryEncoding, GivesTheMeshVtkReads) {
    const auto [encoding, where] = GetParam();
    put(encoding, where);
    const auto step = read(1);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    auto vtk = vtkSmartPointer<vtkGenericEnSightReader>::New();
    vtk->SetCaseFileName((folder_ / "flow.case").c_str());
    vtk->ReadAllVariablesOn();
    vtk->UpdateTimeStep(0.25);
    auto* twin = vtkDataSet::SafeDownCast(vtk->GetOutput()->GetBlock(0));
    ASSERT_NE(twin, nullptr);
    vtkDataSet& block = *step->blocks.front();
    ASSERT_EQ(twin->GetNumberOfCells(), cells + 1);
    for (vtkIdType i = 0; i < nodes; ++i)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(block.GetPoint(i)[c], twin->GetPoint(i)[c]);
    for (vtkIdType i = 0; i < cells; ++i) {
        const vtkIdType j = i == 0 ? 0 : i + 1; // VTK's has the triangle, too
        EXPECT_EQ(block.GetCellType(i), twin->GetCellType(j));
        std::vector<vtkIdType> own;
        std::vector<vtkIdType> other;
        for (int n = 0; n < static_cast<int>(block.GetCell(i)->GetNumberOfPoints()); ++n)
            own.push_back(block.GetCell(i)->GetPointId(n));
        for (int n = 0; n < static_cast<int>(twin->GetCell(j)->GetNumberOfPoints()); ++n)
            other.push_back(twin->GetCell(j)->GetPointId(n));
        // Its reader of text turns no wedges, the binary one does.
        if (encoding == EnsightEncoding::Text || block.GetCellType(i) == VTK_POLYHEDRON) {
            std::sort(own.begin(), own.end());
            std::sort(other.begin(), other.end());
        }
        EXPECT_EQ(own, other) << "cell " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(NodesAndElements,
                         EveryEncoding,
                         testing::Combine(testing::Values(EnsightEncoding::Text,
                                                          EnsightEncoding::Binary,
                                                          EnsightEncoding::SwappedBinary,
                                                          EnsightEncoding::Fortran),
                                          testing::Values(Source_::Point, Source_::Cell)));

TEST_F(EnsightSource, TakesPartsCalledWallOrAtRestForWalls) {
    for (const auto where : {Source_::Point, Source_::Cell}) {
        put(EnsightEncoding::Text, where);
        const auto step = read(2);
        ASSERT_TRUE(step.has_value());
        ASSERT_EQ(step->walls.size(), 2u); // not the outlet, nor what does not touch the nodes
        EXPECT_EQ(step->walls[0].faces->GetPoint(0)[0], 0.0);
        EXPECT_FALSE(step->walls[0].no_slip);
        EXPECT_EQ(step->walls[1].faces->GetPoint(0)[0], 1.0);
        EXPECT_TRUE(step->walls[1].no_slip);
    }
}

TEST_F(EnsightSource, FilesCutOffAnywhereFailOrAreReadRightly) {
    for (const auto encoding :
         {EnsightEncoding::Text, EnsightEncoding::Binary, EnsightEncoding::Fortran})
        for (const auto where : {Source_::Point, Source_::Cell}) {
            put(encoding, where);
            int failures = 0;
            for (const char* const name : {"mesh.geo", "U.0015", "p.0015"}) {
                const std::string whole = read_file(folder_ / name);
                // Few cuts but at every place of a number, and all near the end.
                for (std::size_t cut = 0; cut < whole.size();
                     cut += cut + 40 < whole.size() ? 37 : 1) {
                    write_file(folder_ / name, whole.substr(0, cut));
                    const auto step = read(1);
                    if (step)
                        expect_values(*step, 1, where);
                    else
                        EXPECT_EQ(step.error().message.find(folder_.path().string()),
                                  std::string::npos);
                    failures += step ? 0 : 1;
                    ASSERT_FALSE(HasFailure()) << name << " cut at " << cut;
                }
                write_file(folder_ / name, whole);
            }
            EXPECT_GT(failures, 100);
        }
}

TEST_F(EnsightSource, AMissingOrWrongFileFailsItsTimeStepOnly) {
    const auto source = open_ensight(put(EnsightEncoding::Binary, Source_::Point)).value();
    const auto& fields = source->description().fields;
    const auto expect_failure = [&](Error::Code code, const std::string& words) {
        const auto step = source->read(2, fields);
        ASSERT_FALSE(step.has_value());
        EXPECT_EQ(step.error().code, code);
        EXPECT_NE(step.error().message.find(words), std::string::npos) << step.error().message;
        for (const int other : {1, 3})
            expect_values(source->read(static_cast<std::size_t>(other), fields).value(), other,
                          Source_::Point);
    };
    const std::string sound = read_file(folder_ / "U.0020");
    fs::remove(folder_ / "U.0020");
    expect_failure(Error::Code::NotFound, "U.0020 is not there");
    EXPECT_FALSE(source->files(2).has_value());
    write_file(folder_ / "U.0020", read_file(folder_ / "p.0020"));
    expect_failure(Error::Code::Corrupt, "U.0020");
    write_file(folder_ / "U.0020", sound.substr(0, 400));
    expect_failure(Error::Code::Corrupt, "U.0020");
    write_file(folder_ / "U.0020", sound);
    expect_values(source->read(2, fields).value(), 2, Source_::Point);
}

TEST_F(EnsightSource, LeavesOutVariablesThatAreWrittenMoreSeldom) {
    put(EnsightEncoding::Text, Source_::Point,
        "scalar per node: 2 T T.*\nscalar per measured node: 1 drops d.*\n");
    const std::string text = read_file(folder_ / "flow.case");
    write_file(folder_ / "flow.case",
               text + "time set: 2\nnumber of steps: 2\ntime values: 0 1000.00101\n");
    const auto source = open_ensight(folder_ / "flow.case");
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->description().fields.size(), 2u);
    EXPECT_EQ((*source)->description().note, "not at every time-step: T");
}

TEST_F(EnsightSource, RefusesAMeshThatChangesButNotOneWrittenAgain) {
    put(EnsightEncoding::Binary, Source_::Cell);
    std::string text = read_file(folder_ / "flow.case");
    text.replace(text.find("mesh.geo"), 8, "1 mesh.*.geo");
    write_file(folder_ / "flow.case", text);
    for (const int number : {10, 15, 20, 25})
        write_file(folder_ / ("mesh." + std::to_string(number) + ".geo"),
                   geometry(EnsightEncoding::Binary, number == 20 ? 0.75f : 0.5f));
    for (const int step : {0, 1, 3})
        expect_values(read(static_cast<std::size_t>(step)).value(), step, Source_::Cell);
    const auto refused = read(2);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, Error::Code::Unsupported);
    EXPECT_EQ(refused.error().message, "the mesh changes: mesh.20.geo differs from mesh.10.geo");
}

TEST_F(EnsightSource, ReadsBlocksWithBlankedPoints) {
    EnsightText out(EnsightEncoding::Text);
    for (const char* const line : {"a", "b", "node id off", "element id off", "part"})
        out.line(line);
    out.integers({1});
    out.line("box");
    out.line("block uniform iblanked");
    out.integers({3, 2, 2});
    out.numbers({1, 2, 3});
    out.numbers({0.5, 1, 1});
    out.integers({1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1});
    write_file(folder_ / "g", out.text());
    EnsightText u(EnsightEncoding::Text);
    u.line("u");
    u.line("part");
    u.integers({1});
    u.line("block");
    u.numbers(std::vector<float>(36, 2.5f));
    write_file(folder_ / "u", u.text());
    write_file(
        folder_ / "flow.case",
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: g\nVARIABLE\nvector per node: velocity u\n");
    const auto step = read(0);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    vtkDataSet& block = *step->blocks.front();
    EXPECT_EQ(block.GetPoint(11)[0], 2.0);
    EXPECT_EQ(block.GetPointData()->GetArray("velocity")->GetComponent(11, 2), 2.5);
    vtkDataArray* ghosts = block.GetPointData()->GetArray("vtkGhostType");
    ASSERT_NE(ghosts, nullptr);
    for (vtkIdType i = 0; i < 12; ++i)
        EXPECT_EQ(ghosts->GetTuple1(i), i == 2 ? 2.0 : 0.0);
}

TEST_F(EnsightSource, RefusesWhatItCannotRead) {
    const auto expect_refusal = [&](const std::string& text, const std::string& words) {
        write_file(folder_ / "flow.case", text);
        const auto refused = open_ensight(folder_ / "flow.case");
        ASSERT_FALSE(refused.has_value());
        EXPECT_NE(refused.error().message.find(words), std::string::npos)
            << refused.error().message;
    };
    expect_refusal("", "not an EnSight case file");
    expect_refusal("FORMAT\ntype: ensight\n", "EnSight 6");
    expect_refusal("FORMAT\ntype: ensight gold\nFILE\nfile set: 1\n",
                   "several time-steps in one file");
    expect_refusal("FORMAT\ntype: ensight gold\n", "no geometry file");
    expect_refusal("FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: g\n", "no vector");
    expect_refusal(
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: g\nVARIABLE\nvector per node: 7 U u.*\n",
        "time set 7");
    expect_refusal(
        "FORMAT\ntype: ensight gold\nTIME\ntime set: 1\nnumber of steps: 2\nfilename numbers: 1\n"
        "time values: 1 2\n",
        "each with a file number");
}

TEST_F(EnsightSource, TakesFileNamesInQuotesWithBlanksInThem) {
    std::istringstream in(
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: 1\t\"a mesh.geo\" change_coords_only\n"
        "VARIABLE\nvector per node: 1\tU\t\"a U.*\"\t\nTIME\ntime set: 1\n"
        "number of steps: 1\ntime values: 0\n");
    const auto found = parse_ensight_case(in, folder_.path(), "flow.case").value();
    EXPECT_EQ(found.file_at(found.geometry, 0)->name, "a mesh.geo");
    EXPECT_EQ(found.file_at(found.variables.front().file, 0)->name, "a U.0");
}

TEST_F(EnsightSource, TakesTheFilesThatARestartListsLast) {
    const auto opened = [&](const std::string& rest) {
        std::istringstream in("FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: g\nVARIABLE\n"
                              "vector per node: 1 U u.*\nTIME\ntime set: 1\n" +
                              rest);
        return parse_ensight_case(in, folder_.path(), "flow.case").value();
    };
    const std::string stated = "time values: 0 1 2 1 2 3\n";
    const auto numbered = opened("number of steps: 6\nfilename start number: 10\n"
                                 "filename increment: 10\n" +
                                 stated);
    EXPECT_EQ(numbered.times, (std::vector<double>{0, 1, 2, 3}));
    EXPECT_EQ(numbered.time_sets.front().numbers, (std::vector<int>{10, 40, 50, 60}));
    EXPECT_EQ(numbered.time_note,
              "times go back at file 40, as after a restart: they are sorted; left out, as another "
              "was written later for the same time: file 20, file 30");
    const auto counted = opened("number of steps: 6\n" + stated);
    EXPECT_EQ(counted.file_at(counted.variables.front().file, 2)->name, "u.4");
}

TEST_F(EnsightSource, RefusesNumbersThatAreNoneAndCountsNoMoreFilesThanTimes) {
    const auto opened = [&](const std::string& rest) {
        std::istringstream in("FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: g\nVARIABLE\n"
                              "vector per node: 1 U u.*\nTIME\ntime set: 1\n" +
                              rest);
        return parse_ensight_case(in, folder_.path(), "flow.case");
    };
    const std::string many = "number of steps: 2000000000\n";
    const auto small = opened(many + "filename start number: 7\nfilename increment: 5 5 5 5\n"
                                     "time values: 1 2\n");
    ASSERT_TRUE(small.has_value()) << small.error().message;
    EXPECT_EQ(small->time_sets.front().numbers, (std::vector<int>{7, 12}));
    for (const char* const rest :
         {"filename start number: 2000000000\nfilename increment: 2000000000\ntime values: 1 2\n",
          "filename increment: 1\ntime values: 1 1e999\n", "filename increment: 9999999999\n"}) {
        const auto refused = opened(many + rest);
        ASSERT_FALSE(refused.has_value()) << rest;
        EXPECT_EQ(refused.error().message, "flow.case has a time set that cannot be read");
    }
}

TEST_F(EnsightSource, RefusesFilesOutsideOfTheCasesFolder) {
    write_file(folder_ / "secret", "root:x:0:0");
    const fs::path inside = folder_ / "case";
    fs::create_directory(inside);
    fs::create_symlink(folder_ / "secret", inside / "link.geo");
    const auto expect_outside = [&](const std::string& model, const std::string& variable) {
        write_file(inside / "flow.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: " + model +
                                             "\nVARIABLE\nvector per node: U " + variable + "\n");
        const auto source = open_ensight(inside / "flow.case");
        ASSERT_FALSE(source.has_value()) << model;
        EXPECT_EQ(source.error().code, Error::Code::Unsupported);
        EXPECT_NE(source.error().message.find("which lies outside of its folder"),
                  std::string::npos)
            << source.error().message;
        EXPECT_EQ(source.error().message.find('/'), std::string::npos) << source.error().message;
    };
    expect_outside("../../../../../../../etc/passwd", "U.vel");
    expect_outside("../secret", "U.vel");
    expect_outside(folder_ / "secret", "U.vel");
    expect_outside("link.geo", "U.vel");
    write_file(inside / "mesh.geo", geometry(EnsightEncoding::Text));
    expect_outside("mesh.geo", "../secret");
    expect_outside("mesh.geo", "/etc/passwd");
}

} // namespace
} // namespace wakesurf::importer::ensight_source_test
