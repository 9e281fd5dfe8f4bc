// The surface that a path of HTTP names, /api/v1/sessions/S/surfaces/U/..., with what its files are made from.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/generated/surface.hpp"
#include "server/base/identity.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/live/live_surface.hpp"
#include "server/sessions/session_directory.hpp"

#include <memory>
#include <string>

namespace wakesurf::server {

struct AskedSurface {
    std::shared_ptr<Session> session;
    protocol::SurfaceRecord record;
    std::shared_ptr<LiveSurface> live;
    std::shared_ptr<const LoadedDataset> dataset; ///< keeps what its plan needs
    /// Tells its dataset from one of other values, or of more time-steps.
    std::string data_mark;
};

/// Error: NotFound.
core::Result<AskedSurface> find_surface(const SessionDirectory& sessions,
                                        const DatasetCatalogue& catalogue,
                                        const std::string& session,
                                        const std::string& surface);

/// Returns the key for taking turns in the pool: one file of each link and session at a time, beside the
/// surfaces on display.
std::string turns_of(const std::string& session, const Identity& identity);

} // namespace wakesurf::server
