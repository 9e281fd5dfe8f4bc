// Streak and time surfaces of `wakesurf surface` against closed forms: what a file's positions, `s` and `t` must be to
// each other, whatever the engine does to get there.
#include "core/base/vec3.hpp"
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/vtp_arrays.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace wakesurf::server::moving_surfaces_test {

namespace {

using core::Vec3;

struct Written {
    std::vector<Vec3> position;
    std::vector<double> s;
    std::vector<double> t;
    nlohmann::json statistics;
};

class MovingSurfaces : public testing::Test {
  protected:
    Written surface(const std::string& dataset, std::vector<std::string> more) const {
        const std::string out = folder_ / "out.vtp";
        const std::string stats = folder_ / "stats.json";
        std::vector<std::string> arguments{"surface", dataset, "-o",         out,
                                           "--stats", stats,   "--accuracy", "exact"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto run =
            run_child(tests::server_program(), arguments, 0, [](std::string_view) {}, {});
        EXPECT_TRUE(run) << run.error().message;
        EXPECT_EQ(run->exit_status, 0) << run->errors;
        const auto file = tests::read_file(out);
        return {tests::array_of<Vec3>(file, "Float64", "Points"),
                tests::array_of<double>(file, "Float64", "s"),
                tests::array_of<double>(file, "Float64", "t"),
                nlohmann::json::parse(tests::read_file(stats), nullptr, false)};
    }

    /// Nothing for a surface that is none, so that comparing its vertices proves something.
    static void expect_surface(const Written& written, const char* kind, double t0, double t1) {
        ASSERT_GT(written.position.size(), 200U);
        ASSERT_EQ(written.s.size(), written.position.size());
        ASSERT_EQ(written.t.size(), written.position.size());
        EXPECT_EQ(written.statistics["kind"], kind);
        EXPECT_GT(written.statistics["quads"], 100);
        const auto [first, last] = std::minmax_element(written.t.begin(), written.t.end());
        EXPECT_NEAR(*first, t0, 1e-12);
        EXPECT_NEAR(*last, t1, 1e-12);
        const auto [left, right] = std::minmax_element(written.s.begin(), written.s.end());
        EXPECT_EQ(*left, 0.0);
        EXPECT_EQ(*right, 1.0);
    }

    tests::TemporaryFolder folder_;
};

/// Where dye of flow:oscillating (u = 1, a = 1, omega = 2), released at time r from (-5, 0, z), is at time T.
Vec3 dye(double z, double r, double T) {
    return {-5.0 + (T - r), 0.5 * (std::cos(2.0 * r) - std::cos(2.0 * T)), z};
}

} // namespace

TEST_F(MovingSurfaces, AStreakSurfaceIsDyeThatKnowsItsReleaseTime) {
    const auto streak =
        surface("flow:oscillating", {"--kind", "streak", "--rake", "-5,0,-1 -5,0,1", "--from", "0",
                                     "--to", "3", "--separation", "0.1"});
    ASSERT_NO_FATAL_FAILURE(expect_surface(streak, "streak", 0.0, 3.0));
    for (std::size_t v = 0; v < streak.position.size(); ++v) {
        const Vec3 expected = dye(-1.0 + 2.0 * streak.s[v], streak.t[v], 3.0);
        ASSERT_NEAR(glm::length(streak.position[v] - expected), 0.0, 1e-6)
            << "s = " << streak.s[v] << ", released at " << streak.t[v];
    }
}

TEST_F(MovingSurfaces, AStreakSheetLeavesTheRakeWhenTheReleaseEnds) {
    const auto sheet =
        surface("flow:oscillating", {"--kind", "streak", "--rake", "-5,0,-1 -5,0,1", "--from", "0",
                                     "--to", "3", "--release-until", "1", "--separation", "0.1"});
    ASSERT_NO_FATAL_FAILURE(expect_surface(sheet, "streak", 0.0, 1.0));
    double nearest = 1e300;
    for (std::size_t v = 0; v < sheet.position.size(); ++v) {
        const Vec3 expected = dye(-1.0 + 2.0 * sheet.s[v], sheet.t[v], 3.0);
        ASSERT_NEAR(glm::length(sheet.position[v] - expected), 0.0, 1e-6);
        nearest = std::min(nearest, sheet.position[v].x + 5.0);
    }
    EXPECT_NEAR(nearest, 2.0, 1e-6) << "its youngest dye is two time units old";
}

TEST_F(MovingSurfaces, ATimeSurfaceIsThePatchCarriedByTheFlow) {
    // Strain (0.5 x, -0.5 y, 0) carries the patch (1 + t, 1 + t/2, -1 + 2 s) of time 0 for one time unit.
    const std::vector<std::string> common{"--kind", "time", "--rake", "1,1,-1 1,1,1", "--from",
                                          "0",      "--to", "1",      "--separation", "0.1"};
    for (const auto& second : std::vector<std::vector<std::string>>{
             {"--sweep", "1,0.5,0"}, {"--rake2", "2,1.5,-1 2,1.5,1"}}) {
        auto arguments = common;
        arguments.insert(arguments.end(), second.begin(), second.end());
        const auto patch = surface("flow:strain", arguments);
        ASSERT_NO_FATAL_FAILURE(expect_surface(patch, "time", 0.0, 1.0)) << second.front();
        for (std::size_t v = 0; v < patch.position.size(); ++v) {
            const double t = patch.t[v];
            const Vec3 expected(std::exp(0.5) * (1.0 + t), std::exp(-0.5) * (1.0 + 0.5 * t),
                                -1.0 + 2.0 * patch.s[v]);
            ASSERT_NEAR(glm::length(patch.position[v] - expected), 0.0, 1e-6)
                << second.front() << " s = " << patch.s[v] << ", t = " << t;
        }
    }
}

TEST_F(MovingSurfaces, WriteTheSameBytesForAnyNumberOfThreads) {
    for (const auto& kind : std::vector<std::vector<std::string>>{
             {"--kind", "streak"}, {"--kind", "time", "--sweep", "0,1,0"}}) {
        std::string first;
        for (const auto* threads : {"1", "3"}) {
            auto arguments = kind;
            arguments.insert(arguments.end(), {"--rake", "0.2,0,-1 1,0,-1", "--from", "0", "--to",
                                               "2", "--separation", "0.1", "--threads", threads});
            surface("flow:lamb-oseen", arguments);
            const auto now = tests::read_file(folder_ / "out.vtp");
            ASSERT_FALSE(now.empty());
            if (first.empty())
                first = now;
            EXPECT_TRUE(now == first) << kind[1] << ", " << threads << " threads";
        }
    }
}

} // namespace wakesurf::server::moving_surfaces_test
