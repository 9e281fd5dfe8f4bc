// `wakesurf bench` starts the program beside it, whatever that is, or says what is missing.
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace wakesurf::tests::bench_command_test {

namespace {

namespace fs = std::filesystem;

/// The real program in a folder where the test decides what lies beside it.
class BenchCommand : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        fs::copy_file(server_program(), folder_ / "wakesurf");
    }

    void TearDown() override { fs::remove_all(folder_); }

    server::ChildOutcome run(const std::vector<std::string>& arguments, std::string& output) const {
        const auto line = [&](std::string_view text) { output.append(text).push_back('\n'); };
        const auto outcome = server::run_child(folder_ / "wakesurf", arguments, 0, line, {});
        EXPECT_TRUE(outcome) << outcome.error().message;
        return outcome.value();
    }

    fs::path folder_ = fs::path(testing::TempDir()) / "bench_command";
};

TEST_F(BenchCommand, SaysWhereItsProgramShouldBeAndHowToGetIt) {
    std::string output;
    const auto outcome = run({"bench"}, output);
    EXPECT_EQ(outcome.exit_status, 1);
    EXPECT_NE(outcome.errors.find((folder_ / "wakesurf-bench").string()), std::string::npos);
    EXPECT_NE(outcome.errors.find("./check builds it"), std::string::npos) << outcome.errors;
}

TEST_F(BenchCommand, PassesItsArgumentsOnAndTheExitStatusBack) {
    const fs::path program = folder_ / "wakesurf-bench";
    std::ofstream(program) << "#!/bin/sh\nprintf '%s\\n' \"$@\"\nexit 7\n";
    fs::permissions(program, fs::perms::owner_all);
    std::string output;
    const auto outcome = run({"bench", "edit", "--json", "a b.json", "drag"}, output);
    EXPECT_EQ(outcome.exit_status, 7);
    EXPECT_EQ(output, "--seconds=60\n--json=a b.json\n--\nedit\ndrag\n");
}

} // namespace

} // namespace wakesurf::tests::bench_command_test
