// OpenFOAM cases made here, cell by cell: what the source returns of them, and what it refuses.
#include "importer/sources/files/formats.hpp"
#include "tests/importer/cavity_case.hpp"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <zlib.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <set>

namespace wakesurf::importer::openfoam_source_test {
namespace {

using namespace tests;
using namespace tests::cavity;
using core::Error;
namespace fs = std::filesystem;

using OpenfoamSource = CavityCase;

/// Binary? Dimensions that name units?
using Written = std::tuple<bool, bool>;

const auto each_way = testing::Combine(testing::Bool(), testing::Bool());

class WholeCase : public OpenfoamSource, public testing::WithParamInterface<Written> {};

TEST_P(WholeCase, GivesEveryValueOfEveryTimeStepInAnyOrder) {
    const auto mesh = foam_block_mesh({{4, 3, 2}, true});
    const auto [binary, units_named] = GetParam();
    units_named_ = units_named;
    put(mesh, binary);
    const auto source = open();
    EXPECT_EQ(source->description().name, "cavity");
    EXPECT_EQ(source->description().times, (std::vector<double>{0.0, 0.5, 10.0}));
    const auto& fields = source->description().fields;
    ASSERT_EQ(fields.size(), 2u);
    EXPECT_EQ(fields[0].name, "U");
    EXPECT_EQ(fields[0].components, 3);
    EXPECT_EQ(fields[0].unit, "m/s");
    EXPECT_EQ(source->description().length_unit, "m");
    EXPECT_EQ(source->description().time_unit, "s");
    EXPECT_EQ(fields[0].source, core::FieldInfo::Source::Cell);
    EXPECT_EQ(fields[1].name, "p");
    EXPECT_EQ(fields[1].components, 1);
    EXPECT_EQ(fields[1].unit, "m2/s2");
    EXPECT_EQ(fields[1].range[0], value_at(0, 7, 0));
    EXPECT_EQ(fields[1].range[1], value_at(static_cast<int>(mesh.cells.size()) - 1, 7, 0));
    std::vector<SourceStep> kept;
    for (const int index : {2, 0, 1, 0}) {
        const auto step = source->read(static_cast<std::size_t>(index), fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        ASSERT_EQ(step->blocks.size(), 1u);
        expect_values(*step, index, mesh.cells.size());
        kept.push_back(*step);
    }
    expect_values(kept[0], 2, mesh.cells.size()); // reading on changes nothing that was read
    EXPECT_EQ(source->shared_files()->size(), 5u);
    EXPECT_EQ(source->files(1)->size(), 2u);
    EXPECT_EQ(source->files(1)->front().name, "0.5/U");
}

INSTANTIATE_TEST_SUITE_P(EachWay, WholeCase, each_way);

/// As numbers or as names of units.
class Dimensions : public OpenfoamSource, public testing::WithParamInterface<bool> {
  protected:
    void SetUp() override { units_named_ = GetParam(); }
};

INSTANTIATE_TEST_SUITE_P(EachWay, Dimensions, testing::Bool());

TEST_P(Dimensions, GivesTheAskedFieldsOnly) {
    put(foam_block_mesh({}));
    const auto source = open();
    const auto& fields = source->description().fields;
    for (const auto& [step, field] : std::vector<std::pair<std::size_t, std::size_t>>{
             {0, 0}, {0, 1}, {0, 0}, {2, 0}, {2, 1}, {1, 1}}) {
        const auto read = source->read(step, {fields[field]});
        ASSERT_TRUE(read.has_value()) << read.error().message;
        vtkDataSet& block = *read->blocks.front();
        ASSERT_EQ(block.GetCellData()->GetNumberOfArrays(), 1);
        vtkDataArray* values = block.GetCellData()->GetArray(field == 0 ? "U" : "p");
        ASSERT_NE(values, nullptr);
        EXPECT_EQ(values->GetComponent(1, 0),
                  value_at(1, field == 0 ? 0 : 7, static_cast<int>(step)));
        EXPECT_EQ(block.GetPointData()->GetNumberOfArrays(), 0);
    }
}

TEST_P(Dimensions, KeepsPolyhedraWithTheirFaces) {
    const auto mesh = foam_block_mesh({{4, 2, 2}, true});
    put(mesh);
    const auto source = open();
    const auto step = source->read(0, source->description().fields);
    ASSERT_TRUE(step.has_value());
    vtkDataSet& block = *step->blocks.front();
    std::vector<int> faces(mesh.cells.size(), 0);
    for (const auto& face : mesh.faces)
        for (const int cell : {face.owner, face.neighbour})
            if (cell >= 0)
                ++faces[static_cast<std::size_t>(cell)];
    int polyhedra = 0;
    for (vtkIdType i = 0; i < block.GetNumberOfCells(); ++i) {
        const bool hanging = block.GetCellType(i) == VTK_POLYHEDRON;
        EXPECT_EQ(block.GetCell(i)->GetNumberOfFaces(), faces[static_cast<std::size_t>(i)]);
        EXPECT_EQ(hanging, block.GetCellType(i) != VTK_HEXAHEDRON);
        polyhedra += hanging ? 1 : 0;
    }
    EXPECT_EQ(polyhedra, 4); // the large boxes at the interface
}

TEST_P(Dimensions, TellsWallsFromOtherPatchesAndStillOnesFromMovingOnes) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    const auto source = open();
    const auto step = source->read(1, source->description().fields);
    ASSERT_TRUE(step.has_value());
    ASSERT_EQ(step->walls.size(), 2u);
    EXPECT_TRUE(step->walls[0].no_slip);
    EXPECT_FALSE(step->walls[1].no_slip);
    std::set<std::array<double, 3>> points;
    for (vtkIdType i = 0; i < step->blocks[0]->GetNumberOfPoints(); ++i) {
        const double* p = step->blocks[0]->GetPoint(i);
        points.insert({p[0], p[1], p[2]});
    }
    for (std::size_t w = 0; w < 2; ++w) {
        vtkPolyData& faces = *step->walls[w].faces;
        EXPECT_EQ(faces.GetNumberOfCells(), 8);
        for (vtkIdType i = 0; i < faces.GetNumberOfPoints(); ++i) {
            const double* p = faces.GetPoint(i);
            EXPECT_EQ(p[1], w == 0 ? 0.0 : static_cast<float>(std::pow(3.0, 0.9)));
            EXPECT_TRUE(points.contains({p[0], p[1], p[2]}));
        }
    }
}

TEST_P(Dimensions, GivesADecomposedCaseAsTheWholeOne) {
    const auto mesh = foam_block_mesh({{4, 3, 2}, true});
    for (const auto& part : decompose(mesh, 0.2))
        put(part, part.part == 1, "processor" + std::to_string(part.part));
    const auto source = open();
    EXPECT_EQ(source->description().times, (std::vector<double>{0.0, 0.5, 10.0}));
    for (int index = 2; index >= 0; --index) {
        const auto step =
            source->read(static_cast<std::size_t>(index), source->description().fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        EXPECT_EQ(step->blocks.size(), 2u);
        expect_values(*step, index, mesh.cells.size());
        vtkIdType faces = 0;
        for (const auto& wall : step->walls)
            faces += wall.faces->GetNumberOfCells();
        EXPECT_EQ(faces, mesh.patches[2].size + mesh.patches[3].size);
    }
}

TEST_P(Dimensions, GivesRegionsWithAVelocityAsFluidAndOthersAsSolids) {
    const auto mesh = foam_block_mesh({});
    write_foam_mesh(at("constant/air"), mesh);
    write_foam_mesh(at("constant/heater"), foam_block_mesh({{1, 1, 1}, false}));
    write_foam_mesh(at("constant"),
                    foam_block_mesh({{6, 3, 2}, false})); // what both were split from
    for (int step = 0; step < 3; ++step) {
        const auto time = at(time_names[static_cast<std::size_t>(step)]);
        for (const auto& field : {velocity(mesh, step), pressure(mesh, step)})
            write_foam_field(time / "air", mesh, field);
        write_foam_field(time / "heater", foam_block_mesh({{1, 1, 1}, false}),
                         {"T", "[0 0 0 1 0 0 0]", {{300.0}}, {}});
    }
    write_file(at("cavity.foam"), "");
    // The whole mesh keeps its fields where a case was split, and is marked.
    const auto whole = foam_block_mesh({{6, 3, 2}, false});
    for (const auto& time : time_names)
        write_foam_field(at(time), whole, velocity(whole, 0));
    write_foam_field(at("0"), whole, [&] {
        auto marks = pressure(whole, 0);
        marks.name = "cellToRegion";
        return marks;
    }());
    const auto source = open();
    for (const int index : {1, 0}) {
        const auto step =
            source->read(static_cast<std::size_t>(index), source->description().fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        expect_values(*step, index, mesh.cells.size());
        EXPECT_EQ(step->walls.size(), 2u);
        vtkIdType faces = 0;
        for (const auto& solid : step->solids)
            faces += solid->GetNumberOfCells();
        EXPECT_EQ(faces, 6);
    }
}

TEST_F(OpenfoamSource, RefusesAMeshThatMovesButNotOneWrittenAgain) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    write_foam_mesh(at("0.5"), mesh);
    const auto still = open();
    const auto step = still->read(2, still->description().fields);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    expect_values(*step, 2, mesh.cells.size());
    auto moved = mesh;
    moved.points.back()[1] += 0.25;
    write_foam_mesh(at("1e1"), moved);
    const auto refused = open_openfoam(at("cavity.foam"));
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(
        refused.error().message,
        "the mesh moves: 1e1/polyMesh/points of cavity.foam differs from 0.5/polyMesh/points");
}

TEST_F(OpenfoamSource, FindsTheAxisInWhichTheSidesOfAWedgeMeet) {
    auto mesh = foam_block_mesh({{4, 3, 1}, false});
    auto& sides = mesh.patches.back();
    sides.type = "wedge";
    put(mesh); // both sides in one patch, and parallel
    const auto refused = open_openfoam(at("cavity.foam"));
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(
        refused.error().message,
        "the patches of the type wedge of cavity.foam are not two planes that meet in an axis");
    const auto first = mesh.faces.begin() + sides.start;
    const auto low = [&](const FoamMesh::Face& face) {
        return mesh.points[static_cast<std::size_t>(face.nodes[0])][2] < 0.5;
    };
    const auto middle = std::stable_partition(first, first + sides.size, low);
    const int count = static_cast<int>(middle - first);
    mesh.patches.push_back({"back", "wedge", sides.start + count, sides.size - count, -1});
    mesh.patches[mesh.patches.size() - 2].size = count;
    for (auto& p : mesh.points) { // 5 degrees round a line along x through y = -0.5
        const double angle = (p[2] < 0.5 ? -2.5 : 2.5) * std::numbers::pi / 180.0;
        const double radius = p[1] + 0.5;
        p = {p[0], radius * std::cos(angle) - 0.5, radius * std::sin(angle)};
    }
    put(mesh);
    const auto source = open();
    EXPECT_EQ(source->description().note,
              "an axisymmetric flow, drawn all the way round: the mesh is a wedge of 5 degrees");
    const auto& axis = source->description().axis;
    ASSERT_TRUE(axis.has_value());
    EXPECT_EQ(std::abs(axis->direction.x), 1.0);
    EXPECT_EQ(axis->radial, core::Vec3(0.0, 1.0, 0.0));
    EXPECT_LT(glm::length(axis->origin - core::Vec3(0.0, -0.5, 0.0)), 1e-5);
}

TEST_F(OpenfoamSource, ReadsASlabOfAPlaneFlow) {
    auto mesh = foam_block_mesh({});
    mesh.patches.back().type = "empty";
    put(mesh);
    const auto plane = open();
    EXPECT_EQ(plane->description().note,
              "a plane flow, one cell thick (the patch sides is of the type empty)");
    const auto step = plane->read(0, plane->description().fields);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    expect_values(*step, 0, mesh.cells.size());
    mesh = foam_block_mesh({});
    mesh.patches.push_back({"defaultFaces", "empty", static_cast<int>(mesh.faces.size()), 0, -1});
    put(mesh);
    EXPECT_EQ(open()->description().note, "");
}

TEST_F(OpenfoamSource, ReadsInitialFieldsWrittenByHandWithGroupsAndDirectives) {
    auto mesh = foam_block_mesh({});
    put(mesh);
    auto boundary = read_file(at("constant/polyMesh/boundary"));
    const auto floor = boundary.find('{', boundary.find("floor"));
    boundary.insert(floor + 1, "\n    inGroups 2(ground wall);");
    write_file(at("constant/polyMesh/boundary"), boundary);
    auto by_hand = read_file(at("0/U"));
    by_hand.replace(
        by_hand.find("internalField"), std::string::npos,
        "internalField uniform (1 0 0);\nboundaryField\n{\n"
        "    #includeEtc \"caseDicts/setConstraintTypes\"\n"
        "    wall\n    {\n        type noSlip;\n    }\n"
        "    \".*\"\n    {\n        type fixedValue;\n        value uniform (1 0 0);\n    }\n}\n");
    write_file(at("0/U"), by_hand);
    const auto source = open();
    EXPECT_EQ(source->description().times, (std::vector<double>{0.0, 0.5, 10.0}));
    const auto step = source->read(0, source->description().fields);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    vtkDataArray* u = step->blocks.front()->GetCellData()->GetArray("U");
    for (vtkIdType i = 0; i < u->GetNumberOfTuples(); ++i)
        EXPECT_EQ(u->GetComponent(i, 0), 1.0);
    ASSERT_EQ(step->walls.size(), 2u);
    EXPECT_TRUE(step->walls[0].no_slip);
    EXPECT_FALSE(step->walls[1].no_slip);
}

TEST_F(OpenfoamSource, LeavesOutInitialFieldsWithValuesBehindAMacro) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    const std::string sound = read_file(at("0/U"));
    auto by_hand = sound;
    by_hand.replace(by_hand.find("internalField"), std::string::npos,
                    "#include \"flow\"\ninternalField uniform $velocity;\nboundaryField\n{\n}\n");
    write_file(at("0/U"), by_hand);
    const auto source = open();
    EXPECT_EQ(source->description().times, (std::vector<double>{0.5, 10}));
    EXPECT_TRUE(source->description().note.starts_with("time 0 is left out"))
        << source->description().note;
    EXPECT_EQ(source->files(0)->front().name, "0.5/U");
    for (const int index : {1, 2}) {
        const auto step =
            source->read(static_cast<std::size_t>(index) - 1, source->description().fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        expect_values(*step, index, mesh.cells.size());
    }
    // Later times are a solver's: one that cannot be read fails when it is its turn.
    write_file(at("0/U"), sound);
    write_file(at("0.5/U"), by_hand);
    EXPECT_EQ(open()->description().times.size(), 3u);
}

TEST_F(OpenfoamSource, GoesByTheNamesOfFilesAsOpenfoamDoes) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    for (const auto& time : time_names) {
        auto renamed = read_file(at(time + "/U"));
        renamed.insert(renamed.find("U;") + 1, ".orig");
        write_file(at(time + "/U.before"), read_file(at("1e1/U"))); // says that it is U
        write_file(at(time + "/U"), renamed);
    }
    const auto source = open();
    for (const int index : {0, 1, 2}) {
        const auto step =
            source->read(static_cast<std::size_t>(index),
                         {source->description().fields[0], source->description().fields.back()});
        ASSERT_TRUE(step.has_value()) << step.error().message;
        expect_values(*step, index, mesh.cells.size());
    }
}

TEST_F(OpenfoamSource, AMissingOrWrongFileFailsItsTimeStepOnly) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    const auto source = open();
    const auto& fields = source->description().fields;
    const auto expect_others = [&] {
        for (const int index : {0, 2}) {
            const auto step = source->read(static_cast<std::size_t>(index), fields);
            ASSERT_TRUE(step.has_value()) << step.error().message;
            expect_values(*step, index, mesh.cells.size());
        }
    };
    const auto expect_failure = [&](Error::Code code, const std::string& words) {
        const auto step = source->read(1, fields);
        ASSERT_FALSE(step.has_value()) << words;
        EXPECT_EQ(step.error().code, code) << step.error().message;
        EXPECT_NE(step.error().message.find(words), std::string::npos) << step.error().message;
        EXPECT_EQ(step.error().message.find(folder_.path().string()), std::string::npos);
        expect_others();
    };
    const std::string sound = read_file(at("0.5/U"));
    fs::remove(at("0.5/U"));
    expect_failure(Error::Code::NotFound, "0.5/U");
    write_file(at("0.5/U"), "");
    expect_failure(Error::Code::Corrupt, "0.5/U");
    auto shorter = velocity(mesh, 1);
    shorter.values.pop_back();
    write_foam_field(at("0.5"), mesh, shorter);
    expect_failure(Error::Code::Corrupt, "0.5/U of cavity.foam");
    write_file(at("0.5/U"), sound);
    write_foam_field(at("0.5"), mesh, [&] {
        auto p = velocity(mesh, 1);
        p.name = "p";
        return p;
    }());
    expect_failure(Error::Code::Corrupt, "0.5/p of cavity.foam");
    fs::remove_all(at("0.5"));
    expect_failure(Error::Code::NotFound, "0.5/U");
    put(mesh);
    const auto again = source->read(1, fields);
    ASSERT_TRUE(again.has_value()) << again.error().message;
    expect_values(*again, 1, mesh.cells.size());
}

void write_packed(const fs::path& file, const std::string& text) {
    fs::remove(file);
    const auto out = ::gzopen((file.string() + ".gz").c_str(), "wb");
    ASSERT_EQ(::gzwrite(out, text.data(), static_cast<unsigned>(text.size())),
              static_cast<int>(text.size()));
    ASSERT_EQ(::gzclose(out), Z_OK);
}

TEST_P(Dimensions, ReadsCompressedFiles) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    for (const char* const file : {"constant/polyMesh/points", "constant/polyMesh/boundary", "0/U",
                                   "0.5/U", "1e1/U", "0.5/p"})
        write_packed(at(file), read_file(at(file)));
    const auto source = open();
    const auto step = source->read(1, source->description().fields);
    ASSERT_TRUE(step.has_value()) << step.error().message;
    expect_values(*step, 1, mesh.cells.size());
    EXPECT_EQ(source->files(1)->front().name, "0.5/U.gz");
}

// Points, and the nodes of every face of every cell.
std::vector<double> shape_of(vtkDataSet& block) {
    std::vector<double> out;
    for (vtkIdType i = 0; i < block.GetNumberOfPoints(); ++i)
        out.insert(out.end(), block.GetPoint(i), block.GetPoint(i) + 3);
    for (int c = 0; c < static_cast<int>(block.GetNumberOfCells()); ++c)
        for (int f = 0; f < block.GetCell(c)->GetNumberOfFaces(); ++f) {
            vtkCell* face = block.GetCell(c)->GetFace(f);
            for (int n = 0; n < static_cast<int>(face->GetNumberOfPoints()); ++n)
                out.push_back(static_cast<double>(face->GetPointId(n)));
        }
    return out;
}

// Files of every kind cut off at every 4 KiB, and close to their end.
class Truncated : public OpenfoamSource, public testing::WithParamInterface<Written> {};

TEST_P(Truncated, FilesFailOrAreReadRightly) {
    const auto mesh = foam_block_mesh({{12, 8, 4}, true});
    const auto [binary, units_named] = GetParam();
    units_named_ = units_named;
    put(mesh, binary);
    const auto sound = open();
    const auto shape = shape_of(*sound->read(1, sound->description().fields)->blocks[0]);
    int failures = 0;
    for (const std::string name :
         {"0.5/U", "0.5/p", "constant/polyMesh/points", "constant/polyMesh/faces",
          "constant/polyMesh/owner", "constant/polyMesh/neighbour", "constant/polyMesh/boundary"})
        for (const bool packed : {false, true}) {
            const std::string text = read_file(at(name));
            if (packed)
                write_packed(at(name), text);
            const auto file = packed ? at(name + ".gz") : at(name);
            const std::string whole = read_file(file);
            std::vector<std::size_t> cuts;
            for (std::size_t cut = 0; cut < whole.size(); cut += 4096)
                cuts.push_back(cut);
            for (const std::size_t from_end : {1u, 2u, 3u, 9u, 30u, 100u})
                cuts.push_back(whole.size() - std::min(from_end, whole.size()));
            for (const auto cut : cuts) {
                write_file(file, whole.substr(0, cut));
                const auto source = open_openfoam(at("cavity.foam"));
                const auto step = source ? (*source)->read(1, (*source)->description().fields)
                                         : core::Result<SourceStep>(tl::unexpected(source.error()));
                failures += step ? 0 : 1;
                if (!step) {
                    EXPECT_NE(step.error().code, Error::Code::NotFound) << step.error().message;
                }
                if (step && (*source)->description().fields.size() == 2) {
                    SCOPED_TRACE(file.filename().string() + " cut at " + std::to_string(cut) +
                                 " of " + std::to_string(whole.size()));
                    expect_values(*step, 1, mesh.cells.size());
                    EXPECT_EQ(shape_of(*step->blocks[0]), shape);
                }
            }
            fs::remove(file);
            write_file(at(name), text);
        }
    EXPECT_GT(failures, 20);
}

INSTANTIATE_TEST_SUITE_P(EachWay, Truncated, each_way);

} // namespace
} // namespace wakesurf::importer::openfoam_source_test
