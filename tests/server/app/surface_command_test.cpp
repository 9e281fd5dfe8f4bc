// `wakesurf surface` as its user meets it: a process with an exit status, messages and files.
#include "server/data/child_process.hpp"
#include "tests/support/mesh_readers.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/server/running_program.hpp"
#include "tests/support/value_of.hpp"
#include "tests/support/vtp_arrays.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace wakesurf::server::surface_command_test {

namespace {

class SurfaceCommand : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("surface_command_" + std::string(test->name()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    /// Runs the command with `more` after a small stream surface's options, which later ones override.
    ChildOutcome run(std::vector<std::string> more) const {
        std::vector<std::string> arguments{command_, dataset_};
        const auto add = [&](const std::string& name, const std::string& value) {
            if (std::find(more.begin(), more.end(), name) == more.end())
                arguments.insert(arguments.end(), {name, value});
        };
        add("--kind", "stream");
        add("--rake", "0.2,0,-1 1,0,-1");
        add("--to", "2");
        add("--separation", "0.1");
        add("-o", file("out.vtp"));
        arguments.insert(arguments.end(), more.begin(), more.end());
        auto outcome =
            run_child(tests::server_program(), arguments, 0, [](std::string_view) {}, {});
        EXPECT_TRUE(outcome) << outcome.error().message;
        return outcome.value_or(ChildOutcome{.exit_status = -1, .signal = 0, .errors = {}});
    }

    std::string bytes(const std::string& name) const {
        std::ifstream stream(folder_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

    /// One line that has `part` in it, the exit status, and nothing written.
    void refuses(const std::vector<std::string>& more, int status, const std::string& part) const {
        const auto outcome = run(more);
        EXPECT_EQ(outcome.exit_status, status) << part;
        EXPECT_TRUE(holds(outcome.errors, part));
        EXPECT_EQ(files(), 0u) << part;
    }

    std::string command_ = "surface";
    std::string dataset_ = "flow:lamb-oseen";

  private:
    std::filesystem::path folder_;
};

/// 4^3 nodes of a shear with a bend in it, as VTK's XML file of that type of grid: ImageData, RectilinearGrid or StructuredGrid.
std::string grid_file(const std::string& type) {
    std::ostringstream points, velocity;
    for (int node = 0; node < 64; ++node) {
        const int x = node % 4, y = node / 4 % 4, z = node / 16;
        points << x << ' ' << y << ' ' << z + 0.1 * x << ' ';
        velocity << "1 " << 0.2 * x * x << ' ' << 0.1 * z << ' ';
    }
    const auto array = [](const std::string& name, int components, const std::string& numbers) {
        return "<DataArray type=\"Float32\" format=\"ascii\" Name=\"" + name +
               "\" NumberOfComponents=\"" + std::to_string(components) + "\">" + numbers +
               "</DataArray>";
    };
    const std::string axis = array("axis", 1, "0 1 2 3.5");
    return "<VTKFile type=\"" + type + "\" version=\"0.1\" byte_order=\"LittleEndian\"><" + type +
           " WholeExtent=\"0 3 0 3 0 3\" Origin=\"0 0 0\" Spacing=\"1 1 1\">" +
           "<Piece Extent=\"0 3 0 3 0 3\"><PointData>" + array("U", 3, velocity.str()) +
           "</PointData>" +
           (type == "RectilinearGrid"  ? "<Coordinates>" + axis + axis + axis + "</Coordinates>"
            : type == "StructuredGrid" ? "<Points>" + array("points", 3, points.str()) + "</Points>"
                                       : "") +
           "</Piece></" + type + "></VTKFile>";
}

} // namespace

TEST_F(SurfaceCommand, HasTheSmoothFieldOfUniformGridsAndRefusesItBeforeItComputesOnOthers) {
    for (const auto& [type, name] :
         {std::pair{"ImageData", "data.vti"}, std::pair{"RectilinearGrid", "data.vtr"},
          std::pair{"StructuredGrid", "data.vts"}}) {
        std::ofstream(file(name)) << grid_file(type);
        dataset_ = file(name);
        const auto made = [&](const char* interpolation) {
            return run({"--interpolation", interpolation, "--rake", "0.2,0.5,0.5 0.2,0.5,2.5",
                        "--store", file("store"), "-o", file(interpolation + std::string(".ply"))});
        };
        EXPECT_EQ(made("linear").exit_status, 0) << name;
        const auto smooth = made("smooth");
        if (name == std::string("data.vti")) {
            EXPECT_EQ(smooth.exit_status, 0) << smooth.errors;
            EXPECT_NE(bytes("smooth.ply"), bytes("linear.ply"));
            std::filesystem::remove(file("smooth.ply"));
        } else {
            EXPECT_EQ(smooth.exit_status, 2) << name;
            EXPECT_TRUE(holds(smooth.errors, "--interpolation cannot be smooth on this grid"));
            EXPECT_FALSE(std::filesystem::exists(file("smooth.ply")));
        }
    }
}

TEST_F(SurfaceCommand, WritesTheMeshAndItsStatistics) {
    const auto outcome = run({"--stats", file("stats.json")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    EXPECT_EQ(files(), 2u);
    const auto stats = nlohmann::json::parse(bytes("stats.json"), nullptr, false);
    ASSERT_TRUE(stats.is_object());
    for (const auto* key :
         {"kind", "quads", "vertices", "steps", "vertexSteps", "approximated", "error99",
          "uncertain", "terminated", "maxEdge", "separation", "seconds", "peakBytes"})
        EXPECT_TRUE(stats.contains(key)) << key;
    EXPECT_GT(stats["quads"], 100);
    EXPECT_LE(stats["maxEdge"].get<double>(), 0.1 + 1e-9);
    EXPECT_NE(bytes("out.vtp").find("NumberOfPolys=\"" + std::to_string(stats["quads"].get<int>())),
              std::string::npos);
}

TEST_F(SurfaceCommand, StatesItsOwnPeakOfMemoryAndNotThatOfWhoStartedIt) {
    constexpr std::size_t large = std::size_t{600} << 20;
    std::vector<char> held(large, 'x');
    const auto outcome = run({"--stats", file("stats.json")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    const auto stats = nlohmann::json::parse(bytes("stats.json"), nullptr, false);
    EXPECT_GT(stats["peakBytes"], 1 << 20);
    EXPECT_LT(stats["peakBytes"], held.size());
}

TEST_F(SurfaceCommand, WritesTheSameBytesForAnyNumberOfThreadsInEveryFormat) {
    for (const std::string name : {"out.vtp", "out.glb", "out.ply", "out.obj", "out.drc"}) {
        std::string first;
        for (const auto* threads : {"1", "3", "8"}) {
            ASSERT_EQ(run({"--threads", threads, "-o", file(name)}).exit_status, 0);
            const auto now = bytes(name);
            ASSERT_GT(now.size(), 1000u) << name;
            if (first.empty())
                first = now;
            EXPECT_TRUE(now == first) << name << ", " << threads << " threads";
        }
    }
}

TEST_F(SurfaceCommand, WritesOneSurfaceInEveryFormat) {
    for (const std::string name : {"out.ply", "out.obj", "out.glb", "out.drc"})
        ASSERT_EQ(run({"--stats", file("stats.json"), "-o", file(name)}).exit_status, 0);
    const auto stats = nlohmann::json::parse(bytes("stats.json"));
    const auto ply = tests::read_ply(bytes("out.ply"));
    const auto obj = tests::read_obj(bytes("out.obj"));
    EXPECT_EQ(ply.points.size(), stats["vertices"].get<std::size_t>());
    EXPECT_EQ(obj.points, ply.points);
    EXPECT_EQ(obj.faces, ply.faces);
    const auto glb = tests::read_glb(bytes("out.glb"));
    const auto drc = tests::read_drc(bytes("out.drc"));
    EXPECT_EQ(glb.points, drc.points);
    EXPECT_EQ(glb.faces, drc.faces);
    EXPECT_EQ(drc.about.at("dataset"), "flow:lamb-oseen");
    std::size_t triangles = 0;
    for (const auto& face : ply.faces)
        triangles += face.size() - 2;
    EXPECT_EQ(drc.faces.size(), triangles);
}

TEST_F(SurfaceCommand, CutsCellsInEveryFormatAndSaysSo) {
    ASSERT_EQ(run({"-o", file("flat.ply")}).exit_status, 0);
    ASSERT_EQ(run({"-o", file("one.ply"), "--tessellate", "1"}).exit_status, 0);
    EXPECT_TRUE(bytes("one.ply") == bytes("flat.ply"));
    const auto flat = tests::read_ply(bytes("flat.ply"));
    for (const std::string name : {"out.ply", "out.obj", "out.glb", "out.drc", "out.vtp"}) {
        const auto outcome =
            run({"--tessellate", "3", "--stats", file("stats.json"), "-o", file(name)});
        EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    }
    const auto stats = nlohmann::json::parse(bytes("stats.json"));
    const auto cut = stats["tessellation"];
    EXPECT_EQ(cut["pieces"], 3);
    EXPECT_EQ(cut["quads"], 9 * stats["quads"].get<int>());
    EXPECT_EQ(cut["flatCells"], 0);
    const auto ply = tests::read_ply(bytes("out.ply"));
    const auto obj = tests::read_obj(bytes("out.obj"));
    EXPECT_EQ(ply.points.size(), cut["vertices"].get<std::size_t>());
    EXPECT_EQ(obj.points, ply.points);
    EXPECT_EQ(obj.faces, ply.faces);
    EXPECT_TRUE(std::equal(flat.points.begin(), flat.points.end(), ply.points.begin()));
    EXPECT_EQ(tests::read_glb(bytes("out.glb")).points, tests::read_drc(bytes("out.drc")).points);
    EXPECT_TRUE(holds(bytes("out.ply"), "comment tessellate 3"));
    EXPECT_TRUE(holds(bytes("out.obj"), "# tessellate 3"));
    EXPECT_TRUE(holds(bytes("out.vtp"), "Name=\"tessellate\""));
    EXPECT_TRUE(holds(bytes("out.glb"), "\"tessellate\":3"));
    EXPECT_EQ(tests::read_drc(bytes("out.drc")).about.at("tessellate"), "3");
}

TEST_F(SurfaceCommand, RefusesToCutCellsTooFinelyOrWhereThereAreNone) {
    EXPECT_EQ(run({"--tessellate", "65"}).exit_status, 2);
    const auto large = run({"--tessellate", "64", "--separation", "0.01"});
    EXPECT_NE(large.exit_status, 0);
    EXPECT_TRUE(holds(large.errors, "--tessellate 64 makes "));
    const auto gone = run({"--tessellate", "4", "--kind", "time", "--sweep", "0,0,1", "--rake",
                           "9.9,0,0 9.9,1,0", "--from", "0", "--to", "60"});
    EXPECT_NE(gone.exit_status, 0);
    EXPECT_TRUE(holds(gone.errors, "an empty surface cannot be tessellated"));
    EXPECT_EQ(files(), 0u);
}

TEST_F(SurfaceCommand, WritesPointsWithNormalAndRadiusAsPlyAlone) {
    ASSERT_EQ(run({"-o", file("mesh.ply")}).exit_status, 0);
    const auto done = run({"-o", file("points.ply"), "--lines", "points"});
    ASSERT_EQ(done.exit_status, 0) << done.errors;
    const auto points = tests::read_ply(bytes("points.ply"));
    EXPECT_EQ(points.points, tests::read_ply(bytes("mesh.ply")).points);
    EXPECT_EQ(points.arrays.at("radius").size(), points.points.size());
    EXPECT_EQ(points.arrays.at("nz").size(), points.points.size());
    EXPECT_TRUE(points.faces.empty());
    const auto refused = run({"-o", file("points.vtp"), "--lines", "points"});
    EXPECT_EQ(refused.exit_status, 2);
    EXPECT_TRUE(holds(refused.errors, "--lines: points cannot be written as .vtp"));
}

TEST_F(SurfaceCommand, WritesAGlbWithoutDracoWhereAsked) {
    ASSERT_EQ(run({"-o", file("plain.glb"), "--no-draco"}).exit_status, 0);
    ASSERT_EQ(run({"-o", file("out.glb")}).exit_status, 0);
    const auto plain = tests::read_glb(bytes("plain.glb"));
    EXPECT_FALSE(holds(plain.json, "draco"));
    EXPECT_EQ(plain.faces.size(), tests::read_glb(bytes("out.glb")).faces.size());
    EXPECT_TRUE(plain.arrays.contains("_SPEED"));
    const auto refused = run({"-o", file("out.drc"), "--no-draco"});
    EXPECT_EQ(refused.exit_status, 2);
    EXPECT_TRUE(holds(refused.errors, "--no-draco"));
}

TEST_F(SurfaceCommand, BuildsPathSurfacesThatDifferFromStreamSurfacesWhereTheFlowIsUnsteady) {
    dataset_ = "flow:oscillating";
    const std::string across = "0,-1,0 0,0,1";
    ASSERT_EQ(run({"--rake", across}).exit_status, 0);
    const auto stream = bytes("out.vtp");
    const auto outcome = run({"--rake", across, "--kind", "path", "--stats", file("stats.json")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    EXPECT_EQ(nlohmann::json::parse(bytes("stats.json"))["kind"], "path");
    EXPECT_GT(bytes("out.vtp").size(), 10'000u);
    EXPECT_FALSE(bytes("out.vtp") == stream);
}

TEST_F(SurfaceCommand, CutsARakeThatIsPartlyOutsideAndSaysSo) {
    const auto outcome = run({"--rake", "9,0,0 14,0,0"});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    EXPECT_TRUE(holds(outcome.errors, "outside"));
}

TEST_F(SurfaceCommand, FailsWithStatusOneWhereTheRequestIsWellFormedButCannotBeDone) {
    refuses({"--rake", "30,0,0 40,0,0"}, 1, "outside");
    refuses({"--kind", "time", "--rake2", "30,0,0 40,0,0"}, 1, "--rake2");
    refuses({"--fields", "p"}, 1, "--fields names a field the dataset does not have: p");
    refuses({"-o", file("missing/out.vtp")}, 1, "no folder");
}

TEST_F(SurfaceCommand, SaysThatASurfaceIsCoarserThanAskedFor) {
    const auto outcome =
        run({"--separation", "0.01", "--max-quads", "2000", "--stats", file("stats.json")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    EXPECT_TRUE(
        holds(outcome.errors, "coarsened: a separation of 0.01 needs more quads than allowed"));
    const auto stats = nlohmann::json::parse(bytes("stats.json"));
    EXPECT_EQ(stats["coarsened"], true);
    EXPECT_EQ(stats["requestedSeparation"], 0.01);
    EXPECT_GT(stats["separation"], 0.01);
    EXPECT_LE(stats["quads"], 2000);
    EXPECT_GE(stats["quads"], 1400);
    EXPECT_GT(stats["seconds"]["processor"], 0.0);
}

TEST_F(SurfaceCommand, WritesNothingWhereThereIsNothingToSeeAndSaysWhy) {
    dataset_ = "flow:uniform";
    refuses({"--rake", "0,0,0 1,0,0"}, 1, "the rake lies along the flow");
    refuses({"--kind", "time", "--rake2", "0.2,0,-1 1,0,-1"}, 1, "the two rakes are the same");
    dataset_ = "flow:uniform?u=0";
    refuses({"--rake", "0,0,0 0,1,0"}, 1, "the fluid is at rest");
    dataset_ = "flow:sphere";
    refuses({"--rake", "-0.1,0,-0.1 0.1,0,0.1"}, 1, "the whole rake lies inside the body");
}

TEST_F(SurfaceCommand, AnswersWrongUsageWithStatusTwo) {
    refuses({"--kind", "iso"}, 2, "--kind");
    refuses({"--rake", "nan,0,0 1,0,0"}, 2, "nan,0,0");
    refuses({"--rake", "0,0 1,0,0"}, 2, "--rake");
    refuses({"--separation", "-1"}, 2, "--separation");
    refuses({"--separation", "nan"}, 2, "--separation");
    refuses({"--threads", "0"}, 2, "--threads");
    refuses({"--accuracy", "good"}, 2, "--accuracy");
    refuses({"--interpolation", "cubic"}, 2, "--interpolation");
    refuses({"--interpolation", "smooth"}, 2, "--interpolation cannot be smooth here");
    refuses({"--between", "smooth"}, 2, "--between");
    refuses({"--between", "flow"}, 2, "--between cannot be other than linear here");
    refuses({"-o", file("out.stl")}, 2, ".vtp, .glb, .ply, .obj or .drc");
    refuses({"-o", file("out")}, 2, "no known extension");
    refuses({"-o", file("out.PLY")}, 2, "no known extension");
    refuses({"--no-such-option", "1"}, 2, "--no-such-option");
    refuses({"--merge", "0.8"}, 2, "--merge");
    refuses({"--merge", "nan"}, 2, "--merge");
    refuses({"--angle", "-1"}, 2, "--angle");
    refuses({"--angle", "0"}, 2, "--angle");
    refuses({"--from", "3", "--direction", "forward"}, 2, "--to 2");
}

TEST_F(SurfaceCommand, AnswersWrongUsageToWhatAnotherKindOfSurfaceHas) {
    refuses({"--release-until", "1"}, 2, "--release-until");
    refuses({"--kind", "time", "--sweep", "0,1,0", "--release-until", "1"}, 2, "--release-until");
    refuses({"--sweep", "0,0,1"}, 2, "--sweep");
    refuses({"--kind", "streak", "--rake2", "0,1,0 1,1,0"}, 2, "--rake2");
    refuses({"--kind", "time"}, 2, "--rake2 and --sweep");
    refuses({"--kind", "time", "--sweep", "0,1,0", "--rake2", "0,1,0 1,1,0"}, 2,
            "--rake2 and --sweep");
    refuses({"--kind", "time", "--sweep", "0,0,0"}, 2, "--sweep");
    refuses({"--kind", "time", "--sweep", "0,1"}, 2, "--sweep");
    refuses({"--kind", "time", "--rake2", "0,1,0"}, 2, "--rake2");
    refuses({"--kind", "streak", "--release-until", "nan"}, 2, "--release-until");
    refuses({"--kind", "streak", "--release-until", "2.5"}, 2, "--release-until");
    refuses({"--kind", "streak", "--release-until", "0"}, 2, "--release-until");
}

TEST_F(SurfaceCommand, ReleasesFromATrueCircle) {
    ASSERT_EQ(run({"--rake", "0.1,0.2,-1 0.9,0.2,-1 0.1,1,-1", "--rake-kind", "circle", "-o",
                   file("out.ply")})
                  .exit_status,
              0);
    const auto mesh = tests::read_ply(bytes("out.ply"));
    EXPECT_EQ(mesh.about.at("rakeKind"), "circle");
    std::size_t on_rim = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        if (mesh.arrays.at("t")[v] == 0.0) {
            EXPECT_NEAR(glm::length(mesh.points[v] - core::Vec3(0.1, 0.2, -1)), 0.8, 4e-16);
            ++on_rim;
        }
    EXPECT_GE(on_rim, 51u); // 2 pi 0.8 / 0.1
}

TEST_F(SurfaceCommand, RefusesARakeKindThatDoesNotFit) {
    refuses({"--rake-kind", "circle"}, 2, "--rake: a circle rake needs a centre");
    refuses({"--rake-kind", "ring"}, 2, "--rake-kind must be line, polyline, circle or points");
    refuses({"--rake2-kind", "line"}, 2, "--rake2-kind needs --rake2");
    refuses({"--seconds", "0"}, 2, "--seconds");
    refuses({"--seconds", "soon"}, 2, "--seconds");
}

TEST_F(SurfaceCommand, WritesTheSameSurfaceWithATimeLimitThatSufficesAsWithoutOne) {
    for (const auto* kind : {"stream", "path", "streak"}) {
        ASSERT_EQ(run({"--kind", kind}).exit_status, 0);
        const auto without = bytes("out.vtp");
        const auto within =
            run({"--kind", kind, "--seconds", "600", "--stats", file("stats.json")});
        ASSERT_EQ(within.exit_status, 0) << within.errors;
        EXPECT_TRUE(bytes("out.vtp") == without) << kind;
        EXPECT_FALSE(nlohmann::json::parse(bytes("stats.json")).contains("reason"));
    }
}

TEST_F(SurfaceCommand, WritesWhatIsThereWhenTheTimeIsOverAndMarksIt) {
    dataset_ = "flow:abc";
    const auto outcome =
        run({"--rake", "-9,0,0 9,0,0", "--to", "5", "--separation", "0.002", "--max-quads",
             "50000000", "--seconds", "2", "--stats", file("stats.json"), "-o", file("out.ply")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    EXPECT_TRUE(holds(outcome.errors, "not finished: the time limit of 2 s was reached"));
    const auto stats = nlohmann::json::parse(bytes("stats.json"));
    EXPECT_EQ(stats["reason"], "timeLimit");
    EXPECT_EQ(stats["requestedSeparation"], 0.002);
    EXPECT_GT(stats["separation"], 0.002);
    EXPECT_TRUE(stats["stopped"].get<std::string>().starts_with("the time limit of 2 s"));
    const auto mesh = tests::read_ply(bytes("out.ply"));
    EXPECT_GT(mesh.faces.size(), 100u);
    EXPECT_TRUE(mesh.about.at("stopped").starts_with("the time limit of 2 s"));
}

TEST_F(SurfaceCommand, NothingThereWhenTheTimeIsOverIsAnError) {
    // Even the first, coarse pass has a hundred thousand rows to release.
    refuses({"--seconds", "1e-6", "--kind", "streak", "--to", "1e5"}, 1,
            "--seconds: nothing was there yet after 1e-06 s");
}

TEST_F(SurfaceCommand, LetsDataOfOneTimeStandStill) {
    std::ofstream(file("one.vti")) << grid_file("ImageData");
    dataset_ = file("one.vti");
    const auto outcome =
        run({"--kind", "streak", "--rake", "0.5,1,1 0.5,2,1", "--store", file("store")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    EXPECT_TRUE(
        holds(outcome.errors, "the data have a single time, 0: the flow is treated as steady"));
}

TEST_F(SurfaceCommand, KeepsTheOldFileWhenTheNewOneCannotBeMade) {
    ASSERT_EQ(run({}).exit_status, 0);
    const auto before = bytes("out.vtp");
    EXPECT_EQ(run({"--rake", "30,0,0 40,0,0"}).exit_status, 1);
    EXPECT_TRUE(bytes("out.vtp") == before);
    EXPECT_EQ(files(), 1u);
}

TEST_F(SurfaceCommand, StopsAtASignalAndLeavesNothingHalfWritten) {
    tests::RunningProgram surface("surface flow:abc --kind stream --rake '-9,0,0 9,0,0' --to 200"
                                  " --separation 0.01 --max-quads 50000000 -o " +
                                  file("out.vtp"));
    const std::string first = surface.line();
    EXPECT_TRUE(holds(first, "building"));
    const auto end = surface.stop(SIGINT);
    EXPECT_EQ(end.status, 1);
    EXPECT_TRUE(holds(end.words, "cancelled"));
    EXPECT_EQ(files(), 0u);
}

TEST_F(SurfaceCommand, WritesComponentsOfTheVelocityAndTheNormalByName) {
    ASSERT_EQ(run({"--fields", "velocity_x,normal_x,normal_y,normal_z"}).exit_status, 0);
    const std::string written = bytes("out.vtp");
    const auto values = [&](const std::string& name) {
        return tests::array_of<float>(written, "Float32", name);
    };
    const auto velocity = values("velocity"), velocity_x = values("velocity_x"),
               speed = values("speed");
    const auto x = values("normal_x"), y = values("normal_y"), z = values("normal_z");
    ASSERT_EQ(velocity.size(), 3 * speed.size());
    for (const auto& component : {velocity_x, x, y, z})
        ASSERT_EQ(component.size(), speed.size());
    // The velocity lies in a stream surface.
    for (std::size_t v = 0; v < speed.size(); ++v) {
        EXPECT_EQ(velocity_x[v], velocity[3 * v]);
        EXPECT_NEAR(std::hypot(x[v], y[v], z[v]), 1.0, 1e-5);
        EXPECT_NEAR(x[v] * velocity[3 * v] + y[v] * velocity[3 * v + 1] +
                        z[v] * velocity[3 * v + 2],
                    0.0, 1e-5 * speed[v]);
    }
}

TEST_F(SurfaceCommand, ComparesTwinsByAgeAndWritesTheirDistances) {
    command_ = "twin";
    const auto one = run({"--with", "offset=0,0,0.25", "-o", file("one.ply"), "--csv",
                          file("ages.csv"), "--stats", file("stats.json")});
    ASSERT_EQ(one.exit_status, 0) << one.errors;
    EXPECT_TRUE(holds(bytes("one.ply"), "property float twin_distance"));
    EXPECT_TRUE(holds(bytes("ages.csv"), "\n\"offset=0,0,0.25\","));
    const auto stats = nlohmann::json::parse(bytes("stats.json"));
    EXPECT_NEAR(stats["twin"]["all"]["p99"], 0.25, 1e-4);
    const auto several =
        run({"--with", "offset=0,0,0.25", "--with", "accuracy=exact", "-o", file("mean.ply")});
    ASSERT_EQ(several.exit_status, 0) << several.errors;
    EXPECT_TRUE(holds(bytes("mean.ply"), "property float twin_spread"));
}

TEST_F(SurfaceCommand, RefusesTwinsOfNothingOfUnknownSettingsAndOfSeveralTimes) {
    command_ = "twin";
    refuses({}, 2, "there is nothing to compare with");
    refuses({"--with", "colour=red"}, 2, "`colour`");
    refuses({"--with", "offset=1,2"}, 2, "is not a point");
    refuses({"--with", "accuracy=exact", "--tessellate", "2"}, 2,
            "--tessellate cannot be combined");
}

} // namespace wakesurf::server::surface_command_test
