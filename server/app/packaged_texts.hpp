// What packages install beside the program: chapters of its manual page, and completions for bash, made from the same declarations as
// --help.
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace wakesurf::server {

/// The chapters of the manual page besides commands and options: environment, files, exit status and examples, in roff.
std::string_view manual_chapters();

/// Returns a script for bash-completion's folder: commands, options, the words that an option takes, else
/// files.
std::string bash_completion(const CLI::App& program, const CLI::App* implied = nullptr);

} // namespace wakesurf::server
