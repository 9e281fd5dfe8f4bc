// A dataset's obstacle, or its walls, as frames: for the page, which draws it as the body, and in animations.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "server/data/obstacle_mesh.hpp"
#include "server/data/open_dataset.hpp"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Returns the frames of one KEY, each preceded by its length. protocol/wire/README.md, Obstacle file. Error:
/// NotFound without an obstacle, OverLimit, and as sampling and encoding.
/// @param time   at which the data have a flow; empty: without the flow
/// @param field  also beside the wall, as surface_scalars knows it; empty: none
/// @param share  is grown to the memory needed
core::Result<std::string> body_frames(const LoadedDataset& dataset,
                                      std::optional<double> time,
                                      const std::string& field,
                                      const PatchChoice& patches,
                                      const core::MemoryAccount& account,
                                      core::MemoryAccount::Share& share,
                                      const std::stop_token& stop);

/// Of the frames of a body in an animation: 8 MB of the file.
inline constexpr std::size_t most_body_bytes = 6'000'000;

struct AnimatedBody {
    std::string frames; ///< as body_frames without the flow; empty: none
    std::string
        without; ///< why the body of the data is left out, a sentence; empty: it is not, or there is none
};

/// Returns the body unless its frames would take more than `most` bytes. Error: as body_frames, but NotFound.
core::Result<AnimatedBody> animated_body(const LoadedDataset& dataset,
                                         std::size_t most,
                                         const core::MemoryAccount& account,
                                         core::MemoryAccount::Share& share,
                                         const std::stop_token& stop);

} // namespace wakesurf::server
