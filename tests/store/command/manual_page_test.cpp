// Manual page and completion: made from the declarations that --help shows, so that nothing can be missing or stale.
#include "server/app/packaged_texts.hpp"
#include "store/command/manual_page.hpp"
#include "tests/support/programs.hpp"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <regex>
#include <set>
#include <string>
#include <utility>

namespace wakesurf::tests::manual_page_test {

namespace {

std::pair<int, std::string> run(const std::string& command) {
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), part.size(), pipe) != nullptr)
        text += part.data();
    return {WEXITSTATUS(::pclose(pipe)), text};
}

std::set<std::string> all_matches(const std::string& text, const std::string& pattern) {
    std::set<std::string> found;
    const std::regex expression(pattern);
    for (std::sregex_iterator each(text.begin(), text.end(), expression), end; each != end; ++each)
        found.insert((*each)[1].str());
    return found;
}

} // namespace

TEST(ManualPage, HasEveryOptionThatHelpShows) {
    const std::string program = server_program();
    const auto [status, page] = run(program + " --man-page");
    ASSERT_EQ(status, 0);
    for (const char* command : {"", "serve", "sessions", "sessions list", "surface", "info",
                                "import", "generate", "state backup", "bench"}) {
        const auto help = run(program + " " + command + " --help").second;
        const auto options = all_matches(help, "\n +(?:-\\w,)?(--[\\w-]+)");
        EXPECT_FALSE(options.empty()) << command;
        for (const std::string& option : options)
            EXPECT_NE(page.find("\\fB" + command::roff_of(option) + "\\fR"), std::string::npos)
                << command << " " << option;
    }
    EXPECT_NE(page.find(".SS wakesurf state backup\n"), std::string::npos);
    EXPECT_EQ(page.find("man\\-page"), std::string::npos) << "it is for who makes packages";
}

TEST(ManualPage, ShowsTextsLiterally) {
    EXPECT_EQ(command::roff_of(".TP\n'quoted\na.b"), "\\&.TP\n\\&'quoted\na.b");
    EXPECT_EQ(command::roff_of("--a \\n"), "\\-\\-a \\en");
}

TEST(ManualPage, NamesArgumentsValuesDefaultsAndCommandsWithinCommands) {
    CLI::App app{"Does it.", "it"};
    CLI::App* inner =
        app.add_subcommand("outer", "Is outside")->add_subcommand("inner", "Is inside");
    std::string text, file;
    int number = 7;
    inner->add_option("FILE", file, "What to read")->required();
    inner->add_option("-n,--number", number, "How many")->capture_default_str();
    inner->add_option("--secret", text, "Not shown")->group("");
    const std::string page = command::manual_page(app, {"1.2.3", ".SH FILES\nnone\n"});
    EXPECT_TRUE(page.starts_with(".TH IT 1 \"\" \"wakesurf 1.2.3\"")) << page;
    EXPECT_NE(page.find(".SH NAME\nit \\- Does it\n"), std::string::npos) << page;
    EXPECT_NE(
        page.find(".SS it outer inner\nIs inside.\n.PP\n\\fBit outer inner\\fR [\\fIoptions\\fR] "
                  "\\fIFILE\\fR\n"),
        std::string::npos)
        << page;
    EXPECT_NE(page.find("\\fB\\-n\\fR, \\fB\\-\\-number\\fR \\fIINT\\fR (default: 7)\nHow many\n"),
              std::string::npos)
        << page;
    EXPECT_EQ(page.find("secret"), std::string::npos);
    EXPECT_TRUE(page.ends_with(".SH FILES\nnone\n"));
}

TEST(BashCompletion, OffersCommandsOptionsAndTheWordsOfAnOption) {
    const auto completed = [](const std::string& words, int at) {
        return run("bash -c '. <(" + server_program() + " --bash-completion); COMP_WORDS=(" +
                   words + "); COMP_CWORD=" + std::to_string(at) +
                   "; _wakesurf; echo \"${COMPREPLY[*]}\"'")
            .second;
    };
    EXPECT_EQ(completed("wakesurf s", 1), "serve sessions surface slice state\n");
    EXPECT_EQ(completed("wakesurf sessions re", 2), "rename restore\n");
    EXPECT_EQ(completed("wakesurf serve flow:abc --tls-", 3), "--tls-cert --tls-key\n");
    EXPECT_EQ(completed("wakesurf serve --log-level w", 3), "warn\n");
    EXPECT_EQ(completed("wakesurf sessions list --", 3), "--help --trash --json\n");
    EXPECT_EQ(completed("wakesurf serve ca", 2), "\n") << "files, as bash offers them";
    EXPECT_EQ(completed("wakesurf case.foam --no-o", 2), "--no-open\n") << "those of serve";
    EXPECT_EQ(completed("wakesurf --log-level w", 2), "warn\n");
    EXPECT_EQ(completed("wakesurf ca", 1), "\n");
}

} // namespace wakesurf::tests::manual_page_test
