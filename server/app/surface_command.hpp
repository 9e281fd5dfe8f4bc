// `wakesurf surface`: from a dataset and a rake to a mesh file, without a server.
#pragma once

#include "server/app/surface_request.hpp"

namespace CLI {
class App;
}

namespace wakesurf::server {

/// Declares the options of `surface` on its subcommand.
void add_surface_options(CLI::App& command, SurfaceOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_surface(const SurfaceOptions& options);

} // namespace wakesurf::server
