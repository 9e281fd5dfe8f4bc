// A built-in flow -> a store like an import's: sampled a piece at a time, so that a time-step is never in
// memory as a whole, and going on where an earlier, interrupted run of the same request ended.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/dataset/grid.hpp"
#include "store/import_progress.hpp"
#include "store/store_layout.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::store {

struct GenerateRequest {
    std::string flow; ///< NAME[?k=v,...]
    core::UniformGrid grid;
    std::vector<double> times; ///< strictly increasing, at least one
    StepPlacement placement = StepPlacement::Auto;
};

/// Returns the bytes of all files but the manifest, at most: a mask in bricks is smaller. Error:
/// InvalidArgument; OverLimit beyond any storage.
core::Result<std::uint64_t> generated_bytes(const GenerateRequest& request);

/// Runs in the calling thread and its arena; `show` hears of phase `generate`, and `done` at the end. Error:
/// OverLimit when the disk has too little room (nothing is written then), InvalidArgument for a folder that
/// holds something else, Cancelled, Io.
core::Result<void> generate_store(const GenerateRequest& request,
                                  const std::filesystem::path& folder,
                                  const std::function<void(const ImportProgress&)>& show,
                                  std::stop_token stop);

} // namespace wakesurf::store
