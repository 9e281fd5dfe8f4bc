// The command of a line that names none: `wakesurf case.foam`.
#pragma once

#include "core/base/result.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::server {

struct CommandWords {
    std::vector<std::string> words; ///< with the command in front
    /// The command was added: the data are served, and the page is opened.
    bool implied = false;
};

/// Adds the command if it is missing. A word that is neither a command nor existing data counts as a mistyped
/// command, unless it looks like a file's name. Error: InvalidArgument, with the command that may be meant.
/// @param words  without the program
core::Result<CommandWords> with_command(const CLI::App& program, std::vector<std::string> words);

} // namespace wakesurf::server
