// The parameters of a download, from its path and its query: /api/v1/sessions/S/surfaces/U/mesh.vtp?time=2.5
#pragma once

#include "core/base/result.hpp"
#include "protocol/files/mesh_file.hpp"
#include "server/data/obstacle_mesh.hpp"
#include "server/live/surface_job.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// The query of a request's target, behind its `?`.
/// Parses `time=2.5&draco=false` into values by name, percent signs resolved; empty for an empty text. Error:
/// InvalidArgument for a part without `=`, a name twice, or a percent sign without two digits.
core::Result<std::map<std::string, std::string>> url_query(std::string_view text);

/// Reads the whole of a text as a finite number.
std::optional<double> finite_number(const std::string& text);

struct DownloadRequest {
    protocol::MeshFormat format = protocol::MeshFormat::Vtp;
    protocol::GlbCoding glb = protocol::GlbCoding::Draco;
    std::string lines{};          ///< which lines instead of the mesh, as text; empty: the mesh
    std::uint32_t tessellate = 1; ///< quads that each cell is cut into, each way
    bool now = false;             ///< the newest state, also if it is not final
    bool at_the_end = false;      ///< whatever the session's clock shows
    std::optional<double> time;   ///< likewise; without either: as the clock shows
};

/// Parses a download. Error: NotFound for another file; InvalidArgument, naming the fault in the query.
/// @param file  the last part of the path, `mesh.vtp`
core::Result<DownloadRequest> read_download(std::string_view file,
                                            const std::map<std::string, std::string>& query);

/// Returns the time at which a surface is shown; empty for its end, and for a surface that does not move. A
/// clock before or after the times of the surface shows it at the nearer end. Error: OutOfTime for an
/// explicit time outside of them.
core::Result<std::optional<double>> shown_at(const DownloadRequest& request,
                                             const core::SurfaceParameters& parameters,
                                             std::optional<double> clock);

/// What is asked for along a dataset's obstacle, as in obstacle.bin?time=2.5&field=p or body.vtp?patch=hull.
struct ObstacleRequest {
    std::optional<double> time; ///< of the velocity along it; empty: its shape alone
    std::string field{};        ///< also along it, at that time; empty: none
    PatchChoice patches{};
};

/// Error: InvalidArgument, also for a field without a time.
core::Result<ObstacleRequest> read_obstacle(const std::map<std::string, std::string>& query);

} // namespace wakesurf::server
