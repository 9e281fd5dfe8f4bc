// Defaults of options from the environment: what an image or a unit file sets once and a command line overrides.
#pragma once

#include <string>

namespace wakesurf::server {

/// The variable's value, or `otherwise` where it is unset or empty.
std::string from_environment(const char* variable, std::string otherwise = {});

/// Whether this process runs in a container, by the variable `container` that systemd, podman and our image set.
bool in_container();

} // namespace wakesurf::server
