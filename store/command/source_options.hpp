// Options of a command line about a dataset besides its name: its velocity, times that its files do not state, how far it is trusted,
// and how its time-steps lie on the disk.
#pragma once

#include "core/base/periodic_axes.hpp"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::command {

/// Says that the stored times are one period of a flow that repeats.
struct Loop {
    unsigned periods = 0; ///< how often it runs
    std::optional<double>
        period{}; ///< how long it is; none: by the values of its first and last time-step
};

struct SourceOptions {
    std::optional<double> dt;    ///< from one numbered file to the next; 1 if only `start` is given
    std::optional<double> start; ///< of the first; 0 if only `dt` is given
    std::optional<Loop> loop;
    std::string velocity; ///< a vector's name, or three scalars' with commas; empty: by its name
    std::string mask;     ///< gap or scalar; empty: a mask marks a body that stays
    bool alone = false;   ///< a file with a number in its name without the series it belongs to
    core::PeriodicAxes periodic{}; ///< along these the flow repeats, besides those that files state
    bool confined = false;         ///< files that it names outside of its own folder are refused

    bool times() const { return dt || start; }
};

/// Declares --velocity, --alone, --dt, --start, --loop, --mask, --periodic and --confined.
void add_source_options(CLI::App& command, SourceOptions& options);

/// Returns axes as --periodic takes them: "x,z".
std::string axes_list(const core::PeriodicAxes& axes);

/// Returns the options as arguments that add_source_options reads back exactly.
std::vector<std::string> arguments_of(const SourceOptions& options);

/// Declares --layout auto|whole|bricks. The text is what store::parse_step_placement reads.
void add_layout_option(CLI::App& command, std::string& layout);

} // namespace wakesurf::command
