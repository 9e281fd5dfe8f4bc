// `wakesurf case.foam`: what is meant where the command line begins with no command.
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
    bool implied = false; ///< it was not there: the data are served, and the page is opened
};

/// A word that is neither a command nor there as data is taken for a command that was mistyped, unless it looks like a file's name.
/// @param words  without the program. Error: InvalidArgument, with the command that may be meant.
core::Result<CommandWords> with_command(const CLI::App& program, std::vector<std::string> words);

} // namespace wakesurf::server
