// `wakesurf serve` with arguments it cannot serve: one line on standard error, and the right exit status.
#include "tests/support/programs.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

namespace wakesurf::tests::serve_command_test {

namespace {

struct Ended {
    int status = 0;
    std::string text; ///< standard error
};

/// `wakesurf serve ARGUMENTS` with variables of the environment before it, until it ends by itself.
Ended serve(const std::string& variables, const std::string& arguments) {
    std::FILE* pipe = ::popen(
        (variables + " " + server_program() + " serve " + arguments + " 2>&1 >/dev/null").c_str(),
        "r");
    Ended ended;
    std::array<char, 1024> part{};
    while (std::fgets(part.data(), part.size(), pipe) != nullptr)
        ended.text += part.data();
    ended.status = WEXITSTATUS(::pclose(pipe));
    return ended;
}

} // namespace

TEST(ServeCommand, TakesDefaultsFromTheEnvironmentAndTheCommandLineWins) {
    // What it says shows what it took: an address it cannot parse, or, with a good one, a flow it does not know.
    EXPECT_TRUE(holds(serve("WAKESURF_LISTEN=from-the-environment", "flow:nonsense").text,
                      "from-the-environment"));
    const auto overridden =
        serve("WAKESURF_LISTEN=from-the-environment", "flow:nonsense --listen 127.0.0.1:0");
    EXPECT_TRUE(holds(overridden.text, "lamb-oseen"));
    EXPECT_TRUE(
        holds(serve("WAKESURF_DATASET=flow:nonsense", "--listen 127.0.0.1:0").text, "lamb-oseen"));
    EXPECT_TRUE(
        holds(serve("WAKESURF_TOKEN_FILE=/etc/hostname", "flow:abc --listen 127.0.0.1:0").text,
              "32 to 512"));
    const auto no_token =
        serve("WAKESURF_TOKEN_FILE=/etc/hostname", "flow:nonsense --listen 127.0.0.1:0 --no-auth");
    EXPECT_TRUE(holds(no_token.text, "lamb-oseen"));
}

TEST(ServeCommand, SaysInOneLineWhyItCannotServe) {
    const std::vector<std::tuple<std::string, int, std::string>> cases{
        {"/nonexistent --listen 127.0.0.1:0", 1, "nonexistent"},
        {"flow:nonsense --listen 127.0.0.1:0", 1, "lamb-oseen"},
        {"flow:abc --listen 192.0.2.1:0", 1, "192.0.2.1"},
        {"flow:abc --token-file /etc/hostname", 1, "32 to 512"},
        {"flow:abc --listen nonsense", 2, "HOST:PORT"},
        {"flow:abc --listen :8080", 2, "HOST:PORT"},
        {"flow:abc --listen 127.0.0.1:99999", 2, "HOST:PORT"},
        {"flow:abc --no-auth --listen 0.0.0.0:0", 2, "anyone"},
        {"flow:abc --no-auth --token-file x", 2, "--token-file"},
        {"flow:abc --origin evil", 2, "https://"},
        {"flow:abc --frame-origin *", 2, "--frame-origin"},
        {"flow:abc --frame-origin https://wiki.example/page", 2, "--frame-origin"},
        {"flow:abc --new-token", 2, "--token-file"},
        {"flow:abc --listen 127.0.0.1:0 --url-file /nonexistent/link", 1, "--url-file"},
        {"flow:abc --threads 0", 2, "--threads"},
        {"flow:abc --memory banana", 2, "banana"},
        {"flow:abc --nonsense", 2, "--nonsense"},
        {"flow:abc --tls-cert x", 2, "--tls-key"},
        {"flow:abc --tls-key x", 2, "--tls-cert"},
        {"flow:abc --listen 127.0.0.1:0 --tls-cert /nowhere/c --tls-key /nowhere/k", 1,
         "--tls-cert cannot be read"},
        {"flow:abc --listen 127.0.0.1:0 --tls-cert /etc/hostname --tls-key /etc/hostname", 1,
         "--tls-cert holds no PEM certificate"},
    };
    for (const auto& [arguments, status, words] : cases) {
        const auto [end, text] = serve("", arguments);
        EXPECT_EQ(end, status) << arguments << "\n" << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << arguments << "\n" << text;
        EXPECT_TRUE(holds(text, words)) << arguments << "\n" << text;
    }
}

} // namespace wakesurf::tests::serve_command_test
