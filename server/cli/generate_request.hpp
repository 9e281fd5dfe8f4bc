// The command line of `generate` as checked values.
#pragma once

#include "server/catalogue/store_generation.hpp"
#include "server/cli/generate_command.hpp"

namespace wakesurf::server {

/// Error: InvalidArgument for what can never be right (wrong usage), NotFound for an unknown flow with those there are.
core::Result<GenerateRequest> check_generate_options(const GenerateOptions& options);

} // namespace wakesurf::server
