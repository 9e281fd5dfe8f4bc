// The command line of `surface` as checked values; what depends on the dataset is still open.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/files/surface_lines.hpp"
#include "server/cli/surface_command.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

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
