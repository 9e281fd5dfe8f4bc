// Translates the words of the API into those of the command line. Errors and hints write names of the API in
// backticks, `maxQuads` and `session.list`; here these are options and commands. Python has the same in
// wakesurf/name_mapping.py.
#pragma once

#include "core/base/result.hpp"

#include <span>
#include <string_view>

namespace wakesurf::server {

struct CommandOfMethod {
    std::string_view method;
    std::string_view command;
};

/// Returns the methods of the API that have a command.
std::span<const CommandOfMethod> commands_of_methods();

/// Replaces methods by commands. A hint that names a method without a command is left out.
core::Error with_commands(core::Error error);

/// Replaces parameters of surface.set by options of `wakesurf surface`.
core::Error with_options(core::Error error);

} // namespace wakesurf::server
