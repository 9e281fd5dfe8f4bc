// `wakesurf body` as its user meets it: a process with an exit status, messages and files.
#include "server/data/child_process.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace wakesurf::server::body_command_test {

namespace {

ChildOutcome run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "body");
    auto outcome = run_child(tests::server_program(), arguments, 0, [](std::string_view) {}, {});
    EXPECT_TRUE(outcome) << outcome.error().message;
    return outcome.value_or(ChildOutcome{.exit_status = -1, .signal = 0, .errors = {}});
}

} // namespace

TEST(BodyCommand, WritesTheBodyWithTheValuesBesideIt) {
    const tests::TemporaryFolder folder;
    const std::string file = (folder / "a.vtp").string();
    const auto outcome =
        run({"flow:sphere", "--fields", "velocity_x,velocity,vorticity", "-o", file});
    EXPECT_EQ(outcome.exit_status, 0) << outcome.errors;
    std::ifstream stream(file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    EXPECT_NE(text.find("Name=\"velocity\" NumberOfComponents=\"3\""), std::string::npos);
    EXPECT_NE(text.find("Name=\"velocity_x\""), std::string::npos);
    EXPECT_NE(text.find("Name=\"vorticity\""), std::string::npos);
    EXPECT_EQ(text.find("PatchNames"), std::string::npos) << "there are no names";
}

TEST(BodyCommand, RefusesInWordsWhatThereIsNot) {
    const tests::TemporaryFolder folder;
    const std::string file = (folder / "a.vtp").string();
    const auto said = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"-o", file});
        const auto outcome = run(arguments);
        EXPECT_NE(outcome.exit_status, 0);
        return outcome.errors;
    };
    EXPECT_NE(said({"flow:tornado"}).find("the dataset has no obstacle"), std::string::npos);
    EXPECT_NE(said({"flow:sphere", "--patch", "hull"}).find("there is no patch hull"),
              std::string::npos);
    EXPECT_NE(said({"flow:sphere", "--fields", "nothing"}).find("nothing"), std::string::npos);
    EXPECT_EQ(run({"flow:sphere", "-o", (folder / "a.stl").string()}).exit_status, 2);
}

} // namespace wakesurf::server::body_command_test
