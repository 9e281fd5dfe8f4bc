// A dataset's body, or patches of its boundary, as a file with the values beside it: for the command line and for downloads.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "server/data/obstacle_mesh.hpp"
#include "server/data/open_dataset.hpp"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct ObstacleFileRequest {
    PatchChoice patches;
    std::vector<std::string> fields; ///< the velocity by its name is a vector
    std::optional<double> time{};    ///< needed for fields of a flow that changes with time
};

struct ObstacleFile {
    std::string bytes; ///< a .vtp
    std::size_t points, faces;
    std::vector<core::BoundaryPatch> patches;
};

/// Returns the file, without what closes bodies at the sides of the domain: that is no wall. Error: as obstacle_of and values_beside, and
/// OverLimit. @param share  is grown to the memory needed
core::Result<ObstacleFile> obstacle_file(const LoadedDataset& dataset,
                                         const ObstacleFileRequest& request,
                                         const core::MemoryAccount& account,
                                         core::MemoryAccount::Share& share,
                                         const std::stop_token& stop);

} // namespace wakesurf::server
