// `wakesurf surface`: from a dataset and a rake to a mesh file, without a server.
#pragma once

#include "command/source_options.hpp"
#include "protocol/api/generated/limits.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wakesurf::server {

/// The command line as given; texts are checked by run_surface.
struct SurfaceOptions {
    std::string dataset;
    std::string rake;
    std::string rake_kind;  ///< empty: by the number of its points
    std::string rake2_kind; ///< likewise
    std::uint32_t seeds = 32;
    /// What surface.set takes as well, by its parameters' names, as it was written; empty: left out.
    std::map<std::string, std::string> asked;
    std::vector<std::string> fields; ///< scalars written at the vertices
    std::uint64_t max_quads = protocol::limits::quads_default;
    std::uint64_t memory = 0; ///< 0: by the machine and the control group
    int threads = 0;          ///< 0: one a core
    double seconds = 0.0; ///< of the wall clock, after which what is there is written; 0: no limit
    std::string output;
    bool draco = true;            ///< in .glb files
    std::uint32_t tessellate = 1; ///< quads a cell becomes, each way
    std::string lines;            ///< which lines are written instead of the mesh; empty: the mesh
    std::string stats;
    std::string size = "1600x1000"; ///< of a picture, in pixels
    std::string store;
    command::SourceOptions taken;
};

/// Declares the options of `surface` on its subcommand.
void add_surface_options(CLI::App& command, SurfaceOptions& options);

/// Returns the exit status: 0 done, 1 failed, 2 wrong usage; says why on standard error.
int run_surface(const SurfaceOptions& options);

} // namespace wakesurf::server
