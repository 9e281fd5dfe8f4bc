#include "tests/support/server/server_process.hpp"

#include "tests/support/programs.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <utility>

extern char** environ;

namespace wakesurf::tests {

namespace {

std::string read_line(int descriptor) {
    std::string line;
    for (char c = 0; ::read(descriptor, &c, 1) == 1 && c != '\n';)
        line += c;
    return line;
}

std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t got = 0; (got = ::read(descriptor, part.data(), part.size())) > 0;)
        text.append(part.data(), static_cast<std::size_t>(got));
    return text;
}

} // namespace

ServerProcess::ServerProcess(std::vector<std::string> arguments,
                             const std::vector<std::string>& launcher) {
    std::vector<std::string> command = launcher;
    command.insert(command.end(), {server_program(), "serve"});
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.insert(command.end(), {"--listen", "127.0.0.1:0"});
    std::vector<char*> argv;
    for (std::string& each : command)
        argv.push_back(each.data());
    argv.push_back(nullptr);

    std::array<int, 2> out{};
    std::array<int, 2> log{};
    if (::pipe2(out.data(), O_CLOEXEC) != 0 || ::pipe2(log.data(), O_CLOEXEC) != 0)
        throw std::runtime_error("no pipes left");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, log[1], STDERR_FILENO);
    const int error = ::posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(out[1]);
    ::close(log[1]);
    if (error != 0)
        throw std::runtime_error("cannot start " + command[0]);
    first_line_ = read_line(out[0]);
    ::close(out[0]);
    log_ = log[0];
    log_reader_ = std::thread([this] { log_text_ = read_all(log_); });
    const auto port = first_line_.find("127.0.0.1:");
    if (port == std::string::npos)
        throw std::runtime_error("the server said: " + first_line_ + stop().log);
    port_ = static_cast<std::uint16_t>(std::stoi(first_line_.substr(port + 10)));
    if (const auto token = first_line_.find("#token="); token != std::string::npos)
        token_ = first_line_.substr(token + 7);
}

ServerProcess::~ServerProcess() {
    stop();
}

std::string ServerProcess::rpc(std::string_view text) const {
    return http(port_, "POST", "/rpc", bearer(), text).body;
}

bool ServerProcess::running() const {
    return pid_ > 0 && ::waitpid(pid_, nullptr, WNOHANG) == 0;
}

ServerProcess::End ServerProcess::stop() {
    return end_with(SIGTERM);
}

ServerProcess::End ServerProcess::end_with(int signal) {
    End end;
    if (pid_ <= 0)
        return end;
    const auto start = std::chrono::steady_clock::now();
    ::kill(pid_, signal);
    int status = 0;
    ::waitpid(std::exchange(pid_, -1), &status, 0);
    end.took = std::chrono::duration_cast<std::chrono::milliseconds>(
        std::chrono::steady_clock::now() - start);
    end.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    log_reader_.join();
    ::close(log_);
    end.log = log_text_;
    return end;
}

} // namespace wakesurf::tests
