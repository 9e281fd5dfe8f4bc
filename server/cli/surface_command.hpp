// `wakesurf surface`: from a dataset and a rake to a mesh file, without a server.
#pragma once

#include "core/surface/surface_parameters.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace wakesurf::server {

/// The command line as given; texts are checked by run_surface.
struct SurfaceOptions {
    std::string dataset;
    std::string kind;
    std::string rake;
    std::uint32_t seeds = 32;
    std::optional<double> from;
    std::optional<double> to;
    double separation = 0.0; ///< 0: the dataset's finest spacing
    std::string accuracy = "balanced";
    std::string direction = "forward";
    std::optional<double> release_until;
    std::string rake2;
    std::string sweep;
    double merge = core::SurfaceParameters{}.merge;
    double angle = core::SurfaceParameters{}.angle;
    std::vector<std::string> fields; ///< scalars written at the vertices
    std::uint64_t max_quads = 1'000'000;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    int threads = 0;          ///< 0: one a core
    std::string output;
    bool draco = true; ///< in .glb files
    std::string stats;
    std::string store;
};

/// Declares the options of `surface` on its subcommand.
void add_surface_options(CLI::App& command, SurfaceOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_surface(const SurfaceOptions& options);

} // namespace wakesurf::server
