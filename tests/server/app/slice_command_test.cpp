// `wakesurf slice` as its user meets it: a process with an exit status, messages and files.
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace wakesurf::server::slice_command_test {

namespace {

class SliceCommand : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::remove_all(folder_); }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    ChildOutcome run(std::vector<std::string> arguments) const {
        std::filesystem::create_directories(folder_);
        arguments.insert(arguments.begin(), "slice");
        auto outcome =
            run_child(tests::server_program(), arguments, 0, [](std::string_view) {}, {});
        EXPECT_TRUE(outcome) << outcome.error().message;
        return outcome.value_or(ChildOutcome{.exit_status = -1, .signal = 0, .errors = {}});
    }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }

  private:
    std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                    testing::UnitTest::GetInstance()->current_test_info()->name();
};

} // namespace

TEST_F(SliceCommand, WritesStoredAndDerivedFieldsSideBySide) {
    // Solid rotation with an angular velocity of 1.
    const auto outcome = run({"flow:rotation", "--plane", "0,0,1:0,0,1", "--time", "0", "--fields",
                              "velocity_x,vorticity_z", "--samples", "16", "-o", file("a.csv")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    std::ifstream stream(file("a.csv"));
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, R"(x,y,z,"velocity_x","vorticity_z")");
    int rows = 0;
    for (; std::getline(stream, line); ++rows) {
        double x = 0, y = 0, z = 0, velocity = 0, vorticity = 0;
        char comma = 0;
        std::istringstream(line) >> x >> comma >> y >> comma >> z >> comma >> velocity >> comma >>
            vorticity;
        EXPECT_EQ(z, 1.0);
        EXPECT_NEAR(velocity, -y, 1e-5);
        EXPECT_NEAR(vorticity, 2.0, 1e-4);
    }
    EXPECT_EQ(rows, 256);
}

TEST_F(SliceCommand, HasTheVelocityAcrossAPlaneAtAnyAngle) {
    // A rigid rotation about z: across a plane with the normal (1, 0, 1) the velocity is -y / sqrt(2).
    const auto outcome =
        run({"flow:rotation?w=0", "--plane", "0,0,0:1,0,1", "--time", "0", "--fields",
             "velocity_normal", "--samples", "16", "-o", file("a.csv")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    std::ifstream stream(file("a.csv"));
    std::string line;
    std::getline(stream, line);
    int rows = 0;
    for (; std::getline(stream, line); ++rows) {
        double x = 0, y = 0, z = 0, velocity = 0;
        char comma = 0;
        std::istringstream(line) >> x >> comma >> y >> comma >> z >> comma >> velocity;
        EXPECT_NEAR(velocity, -y / std::sqrt(2.0), 1e-5);
    }
    EXPECT_GT(rows, 100);
}

TEST_F(SliceCommand, SubtractsAnotherDatasetAndSaysSoInTheNameOfTheField) {
    const auto outcome =
        run({"flow:rotation?omega=3", "--plane", "0,0,1:0,0,1", "--time", "0", "--fields",
             "velocity_x", "--minus", "flow:rotation", "--samples", "8", "-o", file("a.csv")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    std::ifstream stream(file("a.csv"));
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, R"~(x,y,z,"velocity_x - velocity_x (flow:rotation)")~");
    while (std::getline(stream, line)) {
        double x = 0, y = 0, z = 0, value = 0;
        char comma = 0;
        std::istringstream(line) >> x >> comma >> y >> comma >> z >> comma >> value;
        EXPECT_NEAR(value, -2.0 * y, 1e-5);
    }
}

TEST_F(SliceCommand, RefusesWhatItCannotWriteInWords) {
    const auto refused = [&](std::vector<std::string> more, const std::string& part) {
        std::vector<std::string> words{"flow:sphere"};
        words.insert(words.end(), more.begin(), more.end());
        const auto outcome = run(words);
        EXPECT_NE(outcome.exit_status, 0);
        EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
        EXPECT_FALSE(std::filesystem::exists(file("a.vts")));
    };
    refused({"--plane", "0,0,0:0,0,1", "-o", file("a.stl")}, ".vts or .csv");
    refused({"--plane", "0,0,0", "-o", file("a.vts")}, "no point and normal");
    refused({"--plane", "0,0,1e9:0,0,1", "-o", file("a.vts")}, "misses the domain");
    refused({"--plane", "0,0,0:0,0,1", "--fields", "nothing", "-o", file("a.vts")}, "nothing");
}

} // namespace wakesurf::server::slice_command_test
