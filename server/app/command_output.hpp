// Everything that a command writes to its terminal, and the lines of the log. Names of files, fields or users in it have no effect on a
// terminal.
#pragma once

#include "core/base/plain_text.hpp"
#include "core/base/result.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace wakesurf::server {

/// Logs to standard error from now on, without ever waiting for its reader. Lines are left out while none can be written, as to a full pipe, one
/// without a reader, or a full disk; the next line that is written states their number. @param level  of
/// spdlog
void log_to_standard_error(const std::string& level);

/// Prints text: the one way in which commands do.
template <class... Arguments>
void tell(std::FILE* stream, fmt::format_string<Arguments...> words, Arguments&&... arguments) {
    const std::string text = fmt::format(words, std::forward<Arguments>(arguments)...);
    std::fputs(core::printable(text).c_str(), stream);
}

template <class... Arguments>
void tell(fmt::format_string<Arguments...> words, Arguments&&... arguments) {
    tell(stdout, words, std::forward<Arguments>(arguments)...);
}

inline constexpr int wrong_usage = 2; ///< exit status

/// Prints `wakesurf: MESSAGE (HINT)`; returns the exit status.
int report_failure(const core::Error& error);

/// Prints likewise that a request is refused; the exit status is `wrong_usage` where an argument is wrong.
int report_refusal(const core::Error& error);

} // namespace wakesurf::server
