// The command line of `surface`, and as checked values; what depends on the dataset is still open.
#pragma once

#include "command/source_options.hpp"
#include "core/base/result.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/files/surface_lines.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

/// The command line as given; texts are checked by check_surface_options.
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

struct SurfaceRequest {
    core::Rake rake;
    core::SurfaceParameters
        parameters; ///< `from`, `to` to be filled in where the options leave them open
    std::optional<double> from, to;
    std::optional<protocol::LinesWanted> lines; ///< instead of the mesh
    std::string asked;    ///< JSON: of surface.set, what was given; without rakes and dataset
    bool picture = false; ///< instead of the mesh
};

/// Error: InvalidArgument for what can never be right (wrong usage), Unsupported for what wakesurf cannot do,
/// NotFound when the folder of the output does not exist.
core::Result<SurfaceRequest> check_surface_options(const SurfaceOptions& options);

/// `from` and `to` where the options leave them open: the first and last time of the data, the other way round with `--direction backward`;
/// 10 time units from `from` where there are no such times.
void choose_times(SurfaceRequest& request, const std::vector<double>& times);

} // namespace wakesurf::server
