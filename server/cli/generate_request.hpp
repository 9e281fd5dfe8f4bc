// The command line of `generate` as checked values.
#pragma once

#include "server/cli/generate_command.hpp"
#include "store/store_generation.hpp"

namespace wakesurf::server {

/// Error: InvalidArgument for what can never be right (wrong usage), NotFound for an unknown flow with those there are.
core::Result<store::GenerateRequest> check_generate_options(const GenerateOptions& options);

} // namespace wakesurf::server
