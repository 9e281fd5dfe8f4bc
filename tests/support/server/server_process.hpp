// The real program, started as a user would start it, on a port of its own.
#pragma once

#include "tests/support/server/raw_socket.hpp"

#include <signal.h>
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace wakesurf::tests {

class ServerProcess {
  public:
    /// Runs `wakesurf serve ARGUMENTS --listen 127.0.0.1:0` and waits for its first line.
    /// @param launcher  the words before those: a program that becomes it
    explicit ServerProcess(std::vector<std::string> arguments = {"flow:lamb-oseen"},
                           const std::vector<std::string>& launcher = {});
    ~ServerProcess();
    ServerProcess(const ServerProcess&) = delete;
    ServerProcess& operator=(const ServerProcess&) = delete;

    std::uint16_t port() const { return port_; }

    const std::string& token() const { return token_; }

    const std::string& first_line() const { return first_line_; }

    std::string origin() const { return "http://127.0.0.1:" + std::to_string(port_); }

    pid_t pid() const { return pid_; }

    /// Returns `Authorization: Bearer ...`.
    Headers bearer() const { return {{"Authorization", "Bearer " + token_}}; }

    /// Posts to /rpc with the token; returns the body of the answer.
    std::string rpc(std::string_view text) const;

    bool running() const;

    struct End {
        int status = -1; ///< exit status, -1 for a signal
        std::chrono::milliseconds took{};
        std::string log;
    };

    /// Sends SIGTERM and returns the outcome.
    End stop();

    /// Sends SIGKILL: it cannot finish anything.
    void kill() { end_with(SIGKILL); }

  private:
    End end_with(int signal);

    pid_t pid_ = -1;
    int log_ = -1;
    std::uint16_t port_ = 0;
    std::string token_;
    std::string first_line_;
    std::string log_text_;
    std::thread log_reader_;
};

} // namespace wakesurf::tests
