#include "store/command/layout_option.hpp"

#include <CLI/CLI.hpp>

namespace wakesurf::command {

void add_layout_option(CLI::App& command, std::string& layout) {
    command
        .add_option(
            "--layout", layout,
            "How time-steps are stored: whole, in bricks of 32 cells, which are read one by "
            "one, or auto: in bricks if a time-step's velocity is larger than 1 GiB")
        ->check(CLI::IsMember({"auto", "whole", "bricks"}))
        ->capture_default_str();
}

} // namespace wakesurf::command
