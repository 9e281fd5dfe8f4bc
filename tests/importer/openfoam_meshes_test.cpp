// OpenFOAM cases as people leave them: more than one mesh in a case, and which times then are read.
#include "importer/first_step.hpp"
#include "tests/importer/cavity_case.hpp"

namespace wakesurf::importer::openfoam_meshes_test {
namespace {

using namespace tests;
using namespace tests::cavity;
using core::Error;

class OpenfoamMeshes : public CavityCase {
  protected:
    void put_mesh(const std::string& instance, const FoamMesh& mesh) const {
        write_foam_mesh(at(instance), mesh);
    }

    void put_fields(const std::string& folder, const FoamMesh& mesh, int step) const {
        for (const auto& field : {velocity(mesh, step), pressure(mesh, step)})
            write_foam_field(at(folder), mesh, field);
    }

    void put_case(const std::string& part = "") const {
        std::filesystem::create_directories(at(part + "constant"));
        write_file(at("cavity.foam"), "");
    }
};

TEST_F(OpenfoamMeshes, OpenAtTheTimesOfTheLastOneAndNameTheOthers) {
    const auto background = foam_block_mesh({{2, 2, 2}, false});
    const auto snapped = foam_block_mesh({{4, 3, 2}, true});
    for (const std::string part : {"", "processor0/"}) {
        std::filesystem::remove_all(at(""));
        put_case(part);
        put_mesh(part + "constant", background);
        put_fields(part + "0", background, 5);
        put_mesh(part + "1", background); // refined in no cell
        put_mesh(part + "2", snapped);
        put_fields(part + "2", snapped, 0);
        put_fields(part + "2.5", snapped, 1);
        const auto source = open();
        EXPECT_EQ(source->description().times, (std::vector<double>{2.0, 2.5}));
        EXPECT_NE(
            source->description().note.find(
                "time 0 is left out: its fields are not of the last mesh, which begins with " +
                part + "2/polyMesh/"),
            std::string::npos)
            << source->description().note;
        for (const int step : {1, 0}) {
            const auto read =
                source->read(static_cast<std::size_t>(step), source->description().fields);
            ASSERT_TRUE(read.has_value()) << read.error().message;
            expect_values(*read, step, snapped.cells.size());
            EXPECT_FALSE(read->walls.empty()) << "walls are those of the last mesh";
        }
        const auto shared = source->shared_files();
        ASSERT_EQ(shared->size(), 5u);
        EXPECT_EQ(shared->front().name, part + "2/polyMesh/points");
    }
}

TEST_F(OpenfoamMeshes, MayHaveMovedBeforeTheRunBegan) {
    const auto mesh = foam_block_mesh({});
    auto moved = mesh;
    moved.points.back()[1] += 0.25;
    put(mesh);
    put_mesh("0.5", moved);
    std::filesystem::remove(at("0.5/polyMesh/faces"));
    std::filesystem::remove(at("0.5/polyMesh/owner"));
    std::filesystem::remove(at("0.5/polyMesh/neighbour"));
    std::filesystem::remove(at("0.5/polyMesh/boundary"));
    const auto source = open();
    EXPECT_EQ(source->description().times, (std::vector<double>{0.5, 10.0}));
    const auto read = source->read(1, source->description().fields);
    ASSERT_TRUE(read.has_value()) << read.error().message;
    expect_values(*read, 2, mesh.cells.size());
}

TEST_F(OpenfoamMeshes, ThatChangeAsTheRunGoesAreRefused) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    auto moved = mesh;
    for (const std::string time : {"0.5", "1e1"}) {
        moved.points.back()[1] += 0.25;
        put_mesh(time, moved);
    }
    const std::string words = "the mesh moves: 0.5/polyMesh/points of cavity.foam differs from "
                              "constant/polyMesh/points";
    EXPECT_EQ(importer::open_openfoam(at("cavity.foam")).error().message, words);
    for (const std::string time : {"0.5", "1e1"}) { // refined as it goes
        const auto finer = foam_block_mesh({{time == "0.5" ? 3 : 5, 3, 2}, false});
        put_mesh(time, finer);
        put_fields(time, finer, 1);
    }
    EXPECT_EQ(importer::open_openfoam(at("cavity.foam")).error().message, words);
}

TEST_F(OpenfoamMeshes, WithCyclicPatchesSayHowFarApartTheyAreAndThatParticlesEndThere) {
    for (const bool units_named : {false, true}) {
        units_named_ = units_named;
        auto mesh = foam_block_mesh({});
        std::array<double, 2> ends{1e9, -1e9};
        for (const auto& point : mesh.points)
            ends = {std::min(ends[0], point[0]), std::max(ends[1], point[0])};
        for (auto& patch : mesh.patches) {
            if (patch.name != "inlet" && patch.name != "outlet")
                continue;
            patch.type = patch.name == "inlet" ? "cyclic" : "cyclicAMI";
            patch.other_patch = patch.name == "inlet" ? "outlet" : "inlet";
        }
        put(mesh);
        const auto source = open();
        std::array<char, 32> apart{};
        std::snprintf(apart.data(), apart.size(), "%.3g", ends[1] - ends[0]);
        EXPECT_EQ(source->description().note,
                  "the flow goes on from one cyclic patch to another (inlet to outlet, " +
                      std::string(apart.data()) + " apart), particles do not: they end there");
        const auto step = source->read(1, source->description().fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        EXPECT_EQ(step->walls.size(), 2u) << "of the walls alone";
        expect_values(*step, 1, mesh.cells.size());
    }
}

TEST_F(OpenfoamMeshes, RepeatBetweenCyclicPatchesOnOppositeSides) {
    auto mesh = foam_block_mesh({});
    for (auto& patch : mesh.patches)
        if (patch.name == "inlet" || patch.name == "outlet") {
            patch.type = "cyclic";
            patch.other_patch = patch.name == "inlet" ? "outlet" : "inlet";
        }
    put(mesh);
    const auto source = open();
    EXPECT_EQ(source->description().periodic, (core::PeriodicAxes{true, false, false}));
    EXPECT_NE(source->description().note.find(
                  "the flow repeats along x: it goes on from one cyclic patch to another (inlet "
                  "to outlet, "),
              std::string::npos)
        << source->description().note;
    EXPECT_NE(source->description().note.find("and so do particles"), std::string::npos);
    ImportRequest request;
    request.source = at("cavity.foam");
    const auto plan = make_plan(request);
    ASSERT_TRUE(plan.has_value()) << plan.error().message;
    const auto reading = read_first_step(*plan, false);
    ASSERT_TRUE(reading.has_value()) << reading.error().message;
    EXPECT_EQ(reading->first.periodic, (core::PeriodicAxes{true, false, false}));
    const auto values = velocity_of(*plan, reading->first, 0, reading->step);
    const auto& opposite = reading->first.assembly.opposite;
    EXPECT_EQ(opposite.size(), 4u * 3u) << "nodes of a side";
    for (const auto& [low, high] : opposite)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ((*values)[3 * low + k], (*values)[3 * high + k]);
}

TEST_F(OpenfoamMeshes, DecomposedAcrossCyclicPatchesNameThemAsWell) {
    for (auto part : decompose(foam_block_mesh({}))) {
        const std::string name = part.part == 0 ? "inlet" : "outlet";
        for (auto& patch : part.patches)
            if (patch.name == name)
                patch.type = "processorCyclic;\n    referPatch " + name;
        put(part, false, "processor" + std::to_string(part.part));
    }
    EXPECT_EQ(open()->description().note,
              "the flow goes on from one cyclic patch to another (inlet, outlet), particles do "
              "not: they end there");
}

} // namespace
} // namespace wakesurf::importer::openfoam_meshes_test
