// A command of the program under test while it runs, and how it ends at a signal.
#pragma once

#include "tests/support/programs.hpp"

#include <signal.h>
#include <sys/types.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>
#include <utility>

namespace wakesurf::tests {

class RunningProgram {
  public:
    /// Runs `wakesurf ARGUMENTS`, as a shell reads them.
    explicit RunningProgram(const std::string& arguments)
        : pipe_(::popen(("echo $$; exec " + server_program() + " " + arguments + " 2>&1").c_str(),
                        "r")) {
        process_ = std::stoi(line());
    }

    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    ~RunningProgram() {
        if (pipe_ != nullptr)
            (void)stop(SIGKILL);
    }

    /// Returns its next line of output; empty if it has ended.
    std::string line() {
        std::array<char, 256> text{};
        return std::fgets(text.data(), text.size(), pipe_) == nullptr ? "" : text.data();
    }

    struct End {
        int status = -1; ///< exit status, -1 for a signal
        std::string words;
    };

    End stop(int signal) {
        ::kill(process_, signal);
        End end;
        for (std::string more = line(); !more.empty(); more = line())
            end.words += more;
        const int status = ::pclose(std::exchange(pipe_, nullptr));
        if (WIFEXITED(status))
            end.status = WEXITSTATUS(status);
        return end;
    }

  private:
    std::FILE* pipe_;
    pid_t process_ = -1;
};

} // namespace wakesurf::tests
