// The completions of `wakesurf` in bash, made from the same declarations as --help.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace wakesurf::server {

/// Returns a script for bash-completion's folder: commands, options, the words that an option takes, else
/// files.
std::string bash_completion(const CLI::App& program, const CLI::App* implied = nullptr);

} // namespace wakesurf::server
