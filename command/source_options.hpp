// What a command line says about a dataset besides its name: its velocity, times that its files do not state, and how far it
// is trusted.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::command {

struct SourceOptions {
    std::optional<double> dt; ///< from one numbered file to the next; 1 where only `start` is told
    std::optional<double> start; ///< of the first; 0 where only `dt` is told
    std::string velocity;  ///< a vector's name, or three scalars' with commas; empty: by its name
    bool alone = false;    ///< a file with a number in its name without the series it belongs to
    bool confined = false; ///< files that it names outside of its own folder are refused

    bool times() const { return dt || start; }
};

/// Declares --velocity, --alone, --dt, --start and --confined.
void add_source_options(CLI::App& command, SourceOptions& options);

/// As arguments of a command line, exactly.
std::vector<std::string> arguments_of(const SourceOptions& options);

} // namespace wakesurf::command
