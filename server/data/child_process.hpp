// A program run to its end: output by line, the end of standard error, exit status. POSIX, no shell.
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

struct ChildOutcome {
    int exit_status = 0; ///< meaningful when `signal` is 0
    int signal = 0;      ///< that ended it
    std::string errors;  ///< from standard error, at most the last 16 KiB
};

/// Runs a program with standard input empty and `address_space` bytes at most (0: no limit). `line` is called
/// in this thread for every line of its standard output. SIGTERM is sent to it when `stop` fires. Error: Io
/// if it cannot be started.
core::Result<ChildOutcome> run_child(const std::filesystem::path& program,
                                     const std::vector<std::string>& arguments,
                                     std::size_t address_space,
                                     const std::function<void(std::string_view)>& line,
                                     std::stop_token stop);

} // namespace wakesurf::server
