// What is said in the words of the API, as the command line says it. Errors and hints write names of the API in backticks, `maxQuads` and
// `session.list`; here these are options and commands. Python has the same in wakesurf/own_words.py.
#pragma once

#include "core/base/result.hpp"

#include <span>
#include <string_view>

namespace wakesurf::server {

struct CommandOfMethod {
    std::string_view method;
    std::string_view command;
};

/// Methods of the API that a command does the work of.
std::span<const CommandOfMethod> commands_of_methods();

/// Methods are commands. A hint that names a method without a command leads nowhere here, and is left out.
core::Error with_commands(core::Error error);

/// Parameters of surface.set are options of `wakesurf surface`.
core::Error with_options(core::Error error);

} // namespace wakesurf::server
