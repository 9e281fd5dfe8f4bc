// Which regions, phases and times of an OpenFOAM case count, by its dictionaries and by what its times have.
#include "importer/sources/files/formats.hpp"
#include "tests/importer/cavity_case.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace wakesurf::importer::openfoam_settings_test {
namespace {

using namespace tests;
using namespace tests::cavity;
namespace fs = std::filesystem;

using OpenfoamSettings = CavityCase;

TEST_F(OpenfoamSettings, TakesNoSolidForFluidBecauseAVelocityWasLeftInItsFirstTime) {
    const auto mesh = foam_block_mesh({});
    const auto small = foam_block_mesh({{1, 1, 1}, false});
    write_foam_mesh(at("constant/air"), mesh);
    write_foam_mesh(at("constant/heater"), small);
    for (int step = 0; step < 3; ++step)
        write_foam_field(at(time_names[static_cast<std::size_t>(step)]) / "air", mesh,
                         velocity(mesh, step));
    write_foam_field(at("0/heater"), small, velocity(small, 0));
    write_file(at("cavity.foam"), "");
    const auto expect_one_fluid = [&](std::size_t times) {
        const auto source = open();
        EXPECT_EQ(source->description().times.size(), times);
        const auto step = source->read(0, source->description().fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        EXPECT_EQ(step->blocks.size(), 1u);
        EXPECT_FALSE(step->solids.empty());
    };
    expect_one_fluid(3);
    for (const char* const time : {"0.5", "1e1"})
        fs::remove_all(at(time)); // nothing was computed yet: only the dictionary tells
    write_file(at("constant/regionProperties"), "regions ( fluid ( air ) solid ( heater ) );");
    expect_one_fluid(1);
}

TEST_F(OpenfoamSettings, SaysWhichTimesLackTheVelocityAndWhatTheyHave) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    for (const std::string time : {"0.5", "1e1"}) {
        auto mean = velocity(mesh, 1);
        mean.name = "UMean";
        write_foam_field(at(time), mesh, mean);
        fs::remove(at(time + "/U"));
    }
    const auto source = open();
    EXPECT_EQ(source->description().times, (std::vector<double>{0.0}));
    EXPECT_EQ(source->description().note,
              "2 times, 0.5 to 1e1, are left out: they have no U, but UMean, which --velocity "
              "UMean takes");
    const auto mean = open_openfoam(at("cavity.foam"), {.velocity = "UMean"});
    ASSERT_TRUE(mean.has_value()) << mean.error().message;
    EXPECT_EQ((*mean)->description().times, (std::vector<double>{0.5, 10.0}));
}

TEST_F(OpenfoamSettings, TakesTheFirstOfSeveralPhasesAndSaysSo) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    for (const auto& time : time_names) {
        fs::remove(at(time + "/U"));
        for (const char* const phase : {"U.water", "U.air"}) {
            auto moves = velocity(mesh, 0);
            moves.name = phase;
            write_foam_field(at(time), mesh, moves);
        }
    }
    const auto source = open();
    EXPECT_EQ(source->description().velocity, "U.air");
    EXPECT_EQ(source->description().note,
              "U.air is taken, of the phases U.air, U.water: choose with --velocity");
}

TEST_F(OpenfoamSettings, CallsTheTimesOfASteadySolverIterations) {
    put(foam_block_mesh({}));
    fs::create_directories(at("system"));
    const auto unit = [&](const std::string& scheme) {
        write_file(at("system/fvSchemes"), "ddtSchemes\n{\n    default " + scheme +
                                               ";\n}\ngradSchemes { default steadyState; }\n");
        return open()->description().time_unit;
    };
    EXPECT_EQ(unit("Euler"), "s");
    EXPECT_EQ(unit("steadyState"), "iterations");
    EXPECT_EQ(unit("localEuler"), "iterations");
    EXPECT_EQ(unit("Euler; // steadyState"), "s");
    EXPECT_EQ(unit("Euler; ddt(k) steadyState"), "s");
    EXPECT_EQ(unit("none; ddt(U) bounded steadyState"), "iterations");
}

TEST_F(OpenfoamSettings, MakesDegreesOfTheCrankSeconds) {
    put(foam_block_mesh({}));
    fs::create_directories(at("system"));
    const auto times = [&](const std::string& file, const std::string& text) {
        write_file(at(file), text);
        const auto source = open();
        return std::pair{source->description().time_unit, source->description().times.back()};
    };
    using Times = std::pair<std::string, double>;
    EXPECT_EQ(times("system/controlDict", "userTime\n{\n type engine;\n omega 1500 [rpm];\n}"),
              Times("s", 10.0 * (1.0 / 9000.0)));
    for (const char* const omega : {"100 [rad/s]", "[rad/s] 100", "constant [rad/s] 100"}) {
        const auto [unit, last] = times(
            "system/controlDict", std::string("userTime { type engine; omega ") + omega + "; }");
        EXPECT_EQ(unit, "s");
        EXPECT_NEAR(last, 10.0 * std::numbers::pi / 180.0 / 100.0, 1e-12) << omega;
    }
    EXPECT_EQ(times("system/controlDict", "userTime { type engine; }"), Times("degrees", 10.0));
    EXPECT_EQ(times("system/controlDict", "application icoFoam;"), Times("s", 10.0));
    EXPECT_EQ(times("constant/engineGeometry", "rpm rpm [0 0 -1 0 0 0 0] 3000;"),
              Times("s", 10.0 * (1.0 / 18000.0)));
}

} // namespace
} // namespace wakesurf::importer::openfoam_settings_test
