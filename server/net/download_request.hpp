// What a download asks for, from its path and its query: /api/v1/sessions/S/surfaces/U/mesh.vtp?time=2.5
#pragma once

#include "core/base/result.hpp"
#include "protocol/files/mesh_file.hpp"
#include "server/service/live/surface_job.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

struct DownloadRequest {
    protocol::MeshFormat format = protocol::MeshFormat::Vtp;
    protocol::GlbCoding glb = protocol::GlbCoding::Draco;
    std::string lines{};          ///< which lines instead of the mesh, as text; empty: the mesh
    std::uint32_t tessellate = 1; ///< quads that each cell is cut into, each way
    bool now = false;             ///< what is shown, also where it is not final yet
    bool at_the_end = false;      ///< whatever the session's clock says
    std::optional<double> time;   ///< likewise; neither: as the clock says
};

/// @param file  the last part of the path, `mesh.vtp`
/// Error: NotFound for another file; InvalidArgument, naming what is wrong in the query.
core::Result<DownloadRequest> read_download(std::string_view file,
                                            const std::map<std::string, std::string>& query);

/// The time a surface is to be shown at; nothing: at its end, and where it does not move. A clock that is before or after what the
/// surface is shown over shows it at that end. Error: OutOfTime for a time that was named and lies outside.
core::Result<std::optional<double>> shown_at(const DownloadRequest& request,
                                             const core::SurfaceParameters& parameters,
                                             std::optional<double> clock);

/// The time at which the flow along a dataset's obstacle is wanted, as in obstacle.bin?time=2.5; nothing: its shape alone. Error: InvalidArgument.
core::Result<std::optional<double>>
read_obstacle_time(const std::map<std::string, std::string>& query);

} // namespace wakesurf::server
