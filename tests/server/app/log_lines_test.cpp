// A server whose output nobody takes any more, and the signals of a terminal that is closed.
#include "tests/support/programs.hpp"
#include "tests/support/server/raw_socket.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests::log_lines_test {

namespace {

struct Pipe {
    Pipe() {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
            throw std::runtime_error("no pipe");
    }

    ~Pipe() {
        close_reader();
        if (ends[1] >= 0)
            ::close(ends[1]);
    }

    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    void close_reader() {
        if (ends[0] >= 0)
            ::close(std::exchange(ends[0], -1));
    }

    std::array<int, 2> ends{-1, -1};
};

/// A server on outputs that the test holds. Its link is in a file, because it may be unable to say it.
class Server {
  public:
    Server(int out, int error, bool hangup_ignored = false, std::vector<std::string> more = {}) {
        std::vector<std::string> texts{server_program(),
                                       "serve",
                                       "flow:abc",
                                       "--listen",
                                       "127.0.0.1:0",
                                       "--log-level",
                                       "debug",
                                       "--url-file",
                                       (folder_ / "url").string(),
                                       "--state",
                                       (folder_ / "state").string()};
        texts.insert(texts.end(), more.begin(), more.end());
        std::vector<char*> words;
        for (std::string& each : texts)
            words.push_back(each.data());
        words.push_back(nullptr);
        pid_ = ::fork();
        if (pid_ == 0) {
            ::dup2(out, STDOUT_FILENO);
            ::dup2(error, STDERR_FILENO);
            ::signal(SIGHUP, hangup_ignored ? SIG_IGN : SIG_DFL);
            ::execv(words[0], words.data());
            ::_exit(127);
        }
        for (int i = 0; i < 600 && link().empty(); ++i)
            ::usleep(100'000); // until it is written as a whole
    }

    ~Server() {
        if (pid_ > 0) {
            ::kill(pid_, SIGKILL);
            ::waitpid(pid_, nullptr, 0);
        }
    }

    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    std::string link() const { return read_file(folder_ / "url"); }

    std::uint16_t port() const {
        const std::string address = link();
        return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
    }

    /// Something that has a line written, at this level.
    int ask() const { return http(port(), "GET", "/openrpc.json").status; }

    bool counted() const { return std::filesystem::exists(folder_ / "state" / "starts"); }

    void signal(int number) const { ::kill(pid_, number); }

    /// Exit status; negative: the signal that ended it.
    int ended() {
        int status = 0;
        ::waitpid(std::exchange(pid_, -1), &status, 0);
        return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
    }

    int stop(int number) {
        signal(number);
        return ended();
    }

  private:
    TemporaryFolder folder_;
    pid_t pid_ = -1;
};

} // namespace

TEST(ServerOutput, MayLoseItsReaderAtAnyTime) {
    Pipe out, error;
    Server server(out.ends[1], error.ends[1]);
    out.close_reader();
    error.close_reader();
    for (int i = 0; i < 100; ++i)
        ASSERT_EQ(server.ask(), 401) << i;
    EXPECT_EQ(server.stop(SIGTERM), 0);
}

TEST(ServerOutput, MayHaveHadNoReaderFromTheBeginning) {
    Pipe out, error;
    out.close_reader();
    error.close_reader();
    Server server(out.ends[1], error.ends[1]);
    EXPECT_EQ(server.ask(), 401);
    EXPECT_EQ(server.stop(SIGTERM), 0);
}

TEST(ServerOutput, MayBeAFullDisk) {
    const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
    ASSERT_GE(full, 0);
    Server server(full, full);
    EXPECT_EQ(server.ask(), 401);
    EXPECT_EQ(server.stop(SIGTERM), 0);
    ::close(full);
}

TEST(ServerOutput, IsNotWaitedForWhereItsReaderHasFallenAsleep) {
    Pipe out, error;
    ASSERT_GT(::fcntl(error.ends[1], F_SETPIPE_SZ, 4096), 0);
    Server server(out.ends[1], error.ends[1]);
    for (int i = 0; i < 500; ++i) // many times what the pipe holds
        ASSERT_EQ(server.ask(), 401) << i;
    std::array<char, 8192> read{};
    ASSERT_GT(::read(error.ends[0], read.data(), read.size()), 0);
    EXPECT_EQ(server.ask(), 401);
    const auto size = ::read(error.ends[0], read.data(), read.size());
    ASSERT_GT(size, 0);
    const std::string next(read.data(), static_cast<std::size_t>(size));
    EXPECT_NE(next.find("event=lines_left_out count="), std::string::npos) << next;
    EXPECT_EQ(server.stop(SIGTERM), 0);
}

TEST(ServerOutput, OfAClosedTerminalEndsItInOrder) {
    Pipe out, error;
    Server server(out.ends[1], error.ends[1]);
    EXPECT_TRUE(server.counted());
    RawSocket waiting(server.port());
    EXPECT_EQ(server.stop(SIGHUP), 0);
    EXPECT_FALSE(server.counted()) << "no death for the careful start";
}

TEST(ServerOutput, OfAClosedTerminalDoesNotEndItUnderNohup) {
    Pipe out, error;
    Server server(out.ends[1], error.ends[1], true);
    server.signal(SIGHUP);
    EXPECT_EQ(server.ask(), 401);
    EXPECT_EQ(server.stop(SIGTERM), 0);
}

} // namespace wakesurf::tests::log_lines_test
