#include "server/data/child_process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

namespace wakesurf::server::child_process_test {
namespace {

std::vector<std::string> lines;

ChildOutcome shell(const std::string& script, std::stop_token stop = {}) {
    lines.clear();
    return run_child(
               "/bin/sh", {"-c", script}, 0,
               [](std::string_view line) { lines.emplace_back(line); }, stop)
        .value();
}

TEST(ChildProcess, GivesOutputByLineAndTheExitStatus) {
    const auto outcome = shell("echo one; printf 'two\\nthree'; echo oops >&2; exit 7");
    EXPECT_EQ(lines, (std::vector<std::string>{"one", "two", "three"}));
    EXPECT_EQ(outcome.exit_status, 7);
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.errors, "oops\n");
}

TEST(ChildProcess, HasNothingOnStandardInput) {
    (void)shell("cat; echo end");
    EXPECT_EQ(lines, (std::vector<std::string>{"end"}));
}

TEST(ChildProcess, HasNoneOfTheServersSockets) {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0); // as Asio opens them
    ASSERT_GE(socket, 0);
    (void)shell("for file in /proc/$$/fd/*; do readlink $file; done");
    for (const std::string& line : lines)
        EXPECT_EQ(line.find("socket:"), std::string::npos) << line;
    EXPECT_EQ(lines.size(), 3u) << "standard input, output and error";
    ::close(socket);
}

TEST(ChildProcess, TellsACrash) {
    EXPECT_EQ(shell("kill -SEGV $$").signal, SIGSEGV);
}

TEST(ChildProcess, IsEndedByTheStopToken) {
    std::stop_source stop;
    lines.clear();
    const auto outcome = run_child(
        "/bin/sh", {"-c", "echo up; exec sleep 600"}, 0,
        [&](std::string_view) { stop.request_stop(); }, stop.get_token());
    EXPECT_EQ(outcome->signal, SIGTERM);
}

TEST(ChildProcess, IsKilledIfItDoesNotHeedTheStopToken) {
    std::stop_source stop;
    lines.clear();
    const auto outcome = run_child(
        "/bin/sh", {"-c", "trap '' TERM; echo up; exec sleep 600"}, 0,
        [&](std::string_view) { stop.request_stop(); }, stop.get_token());
    EXPECT_EQ(outcome->signal, SIGKILL);
}

TEST(ChildProcess, KeepsOnlyTheLastWordsOfAChattyProgram) {
    const auto outcome = shell("head -c 1000000 /dev/zero | tr '\\0' x >&2; echo last >&2");
    EXPECT_LT(outcome.errors.size(), 32'000u);
    EXPECT_TRUE(outcome.errors.ends_with("last\n"));
}

TEST(ChildProcess, SaysWhenAProgramIsNotThere) {
    const auto outcome = run_child("/no/such/program", {}, 0, [](std::string_view) {}, {});
    EXPECT_EQ(outcome.error().code, core::Error::Code::Io);
    EXPECT_EQ(outcome.error().message.find("/no"), std::string::npos);
}

} // namespace
} // namespace wakesurf::server::child_process_test
