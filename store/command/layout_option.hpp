// The option --layout of commands that write stores: how time-steps lie on the disk.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace wakesurf::command {

/// Declares --layout auto|whole|bricks. The text is what store::parse_step_placement reads.
void add_layout_option(CLI::App& command, std::string& layout);

} // namespace wakesurf::command
