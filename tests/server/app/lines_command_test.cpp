// `wakesurf lines` as its user meets it: a process with an exit status, messages and files.
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace wakesurf::server::lines_command_test {

namespace {

class LinesCommand : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    static ChildOutcome run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "lines");
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

TEST_F(LinesCommand, WritesAPointOfALineInEachRow) {
    const auto outcome = run({"flow:rotation?w=0", "--from", "line:0.5,0,0:1,0,0", "--seeds", "2",
                              "--duration", "1", "--field", "vorticity_z", "-o", file("a.csv")});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    std::ifstream stream(file("a.csv"));
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, R"(line,x,y,z,t,"vorticity_z")");
    int rows = 0;
    for (; std::getline(stream, line); ++rows) {
        double number = 0, x = 0, y = 0, z = 0, t = 0, vorticity = 0;
        char comma = 0;
        std::istringstream(line) >> number >> comma >> x >> comma >> y >> comma >> z >> comma >>
            t >> comma >> vorticity;
        EXPECT_NEAR(std::hypot(x, y), number == 0 ? 0.5 : 1.0, 1e-4);
        EXPECT_NEAR(std::atan2(y, x), t, 1e-4);
        EXPECT_NEAR(vorticity, 2.0, 1e-4);
    }
    EXPECT_GT(rows, 40);
    EXPECT_EQ(run({"flow:sphere", "--from", "sphere:0,0,0:0.8", "-o", file("a.vtp")}).exit_status,
              0);
    EXPECT_EQ(run({"flow:sphere", "--from", "along", "-o", file("along.csv")}).exit_status, 0);
    std::ifstream vtp(file("a.vtp"));
    std::stringstream text;
    text << vtp.rdbuf();
    EXPECT_NE(text.str().find("NumberOfLines=\"50\""), std::string::npos);
}

TEST_F(LinesCommand, RefusesWhatItCannotWriteInWords) {
    const auto refused = [&](std::vector<std::string> more, const std::string& part) {
        std::vector<std::string> words{"flow:sphere"};
        words.insert(words.end(), more.begin(), more.end());
        const auto outcome = run(words);
        EXPECT_NE(outcome.exit_status, 0);
        EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
        EXPECT_FALSE(std::filesystem::exists(file("a.vtp")));
    };
    const std::string line = "line:-2,0,0:-2,1,0";
    refused({"--from", line, "-o", file("a.stl")}, ".vtp or .csv");
    refused({"--from", "ring:0,0,0", "-o", file("a.vtp")}, "neither line:");
    refused({"--from", "sphere:0,0,0:1e30", "-o", file("a.vtp")}, "no radius for a sphere");
    refused({"--from", "line:99,0,0:99,1,0", "-o", file("a.vtp")}, "move them inside");
    refused({"--from", line, "--field", "nothing", "-o", file("a.vtp")}, "nothing");
    refused({"--from", line, "--seeds", "1000000", "-o", file("a.vtp")}, "4096");
    refused({"--from", "walls:0.1", "--patch", "hull", "-o", file("a.vtp")}, "no patch hull");
    refused({"--from", line, "--direction", "up", "-o", file("a.vtp")}, "no direction");
}

} // namespace wakesurf::server::lines_command_test
