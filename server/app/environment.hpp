// Defaults of options from the environment: an image or a unit file sets them, a command line overrides them.
#pragma once

#include <string>

namespace wakesurf::server {

/// Returns the variable's value, or `otherwise` if it is unset or empty.
std::string from_environment(const char* variable, std::string otherwise = {});

/// Says whether this process runs in a container, by the variable `container` that systemd, podman and our
/// image set.
bool in_container();

} // namespace wakesurf::server
