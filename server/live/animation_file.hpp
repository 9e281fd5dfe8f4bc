// An animation as a file with its recipe: of a download, of `wakesurf surface`, and of `wakesurf verify`, which makes it again.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface_statistics.hpp"
#include "protocol/files/recipe.hpp"
#include "server/data/open_dataset.hpp"
#include "server/live/surface_file.hpp"

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

inline constexpr std::size_t animation_steps = 200; ///< where no times are named
inline constexpr std::size_t most_steps = 2000;     ///< of an animation, or of numbers

/// Returns the plan of the surface until that time. Level sets keep theirs: they have no age.
core::Result<core::SurfacePlan> until(core::SurfacePlan plan, double last);

/// Says whether there is anything to see at one time that there is not at another. Error: InvalidArgument, with the reason.
core::Result<void> check_moves(const core::SurfacePlan& plan, const core::DatasetInfo& dataset);

struct AnimationFile {
    SurfaceFile file;
    core::SurfaceStatistics statistics; ///< of the last step
    std::string without_body; ///< why the data's body is not in it; empty: it is, or there is none
    std::size_t frame_bytes = 0;
    std::size_t most_vertices = 0;  ///< of a step
    std::uint64_t all_vertices = 0; ///< of all steps together
};

/// Builds the surface at the recipe's times, in order, and makes its file. The same recipe, data and viewer give the same bytes, on any
/// number of threads. Error: as check_moves, animate, body_frames and animation_page; InvalidArgument for a surface that is empty and
/// should not be; OverLimit.
/// @param plan    of the recipe's rake and parameters, until its last time
/// @param viewer  the page without data
/// @param text    stands in the file for that of the recipe; empty: the recipe's own
core::Result<AnimationFile> make_animation_file(protocol::Recipe recipe,
                                                const core::SurfacePlan& plan,
                                                const LoadedDataset& dataset,
                                                std::string_view viewer,
                                                const std::stop_token& stop,
                                                const FileMemory& memory,
                                                const std::string& text = {},
                                                core::WorkDone* done = nullptr);

} // namespace wakesurf::server
