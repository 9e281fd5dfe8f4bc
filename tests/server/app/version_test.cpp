// `wakesurf --version`: the program's version and those of all that it reads, writes and speaks.
#include "protocol/api/openrpc.hpp"
#include "protocol/api/session_file.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "server/app/version.hpp"
#include "server/sessions/journal/state_layout.hpp"
#include "store/store_manifest.hpp"
#include "tests/support/places.hpp"
#include "tests/support/programs.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace wakesurf::tests::version_test {

namespace {

/// What a command prints, standard error too.
std::string printed_by(const std::string& command) {
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 1024> part{};
    while (std::fgets(part.data(), part.size(), pipe) != nullptr)
        text += part.data();
    EXPECT_EQ(WEXITSTATUS(::pclose(pipe)), 0);
    return text;
}

std::string text_of(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(source_folder() / file).rdbuf();
    return text.str();
}

std::string first_match(const std::string& text, const std::string& pattern) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : std::string();
}

} // namespace

TEST(Version, NamesTheProgramTheApiAndEveryFormat) {
    const std::string text = server::version_text("0123456789ab");
    const auto has = [&](const std::string& line) {
        EXPECT_NE(("\n" + text + "\n").find("\n" + line + "\n"), std::string::npos) << text;
    };
    has("wakesurf " + std::string(server::version_number()));
    has("commit 0123456789ab");
    has("API level " + std::to_string(protocol::api_level));
    has("store format " + std::to_string(store::store_format_version) + ", " +
        std::to_string(store::brick_format_version));
    has("journal schema " + std::to_string(server::state_layout));
    has("session file " + std::to_string(protocol::session_file_version));
    has("mesh frame " + std::to_string(protocol::frame_version));
}

TEST(Version, IsPrintedByTheProgramWithItsCommit) {
    const std::string printed = printed_by(server_program() + " --version");
    const std::string commit =
        first_match(printed, "\ncommit ([0-9a-f]{12}( with changes)?|unknown)\n");
    EXPECT_NE(commit, "") << printed;
    EXPECT_EQ(printed, server::version_text(commit) + "\n");
}

TEST(Version, IsTheSameInTheBuildTheChangeLogAndTheCitation) {
    const std::string version =
        first_match(text_of("CMakeLists.txt"), R"(VERSION (\d+\.\d+\.\d+))");
    EXPECT_EQ(server::version_number(), version);
    EXPECT_EQ(first_match(text_of("CHANGELOG.md"), R"(\n## (\d+\.\d+\.\d+))"), version);
    EXPECT_EQ(first_match(text_of("CITATION.cff"), R"(\nversion: (\S+))"), version);
}

TEST(Version, OfTheApiIsTheOneThePageExpects) {
    EXPECT_EQ(first_match(text_of("web-client/src/protocol/messages.ts"), R"(apiLevel = (\d+))"),
              std::to_string(protocol::api_level));
}

TEST(Version, OfEveryFormatIsExplained) {
    const std::string table = text_of("docs/versions.md");
    for (const std::string& row :
         {"API level | " + std::to_string(protocol::api_level),
          "store format | " + std::to_string(store::store_format_version) + ", " +
              std::to_string(store::brick_format_version),
          "journal schema | " + std::to_string(server::state_layout),
          "session file | " + std::to_string(protocol::session_file_version),
          "mesh frame | " + std::to_string(protocol::frame_version)})
        EXPECT_NE(table.find("| " + row + " |"), std::string::npos) << row;
}

} // namespace wakesurf::tests::version_test
