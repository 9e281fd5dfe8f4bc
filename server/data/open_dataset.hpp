// A dataset ready for use: its description, the flow that carries particles, and the cache behind it.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/dataset/time_step_cache.hpp"
#include "core/field/flow.hpp"
#include "server/data/bricks/rank_bricks.hpp"
#include "server/data/dataset_argument.hpp"
#include "server/data/node_fields.hpp"
#include "store/command/source_options.hpp"
#include "store/import_progress.hpp"
#include "store/store_reader.hpp"
#include "store/store_scalars.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct LoadedDataset {
    core::DatasetInfo info;
    std::shared_ptr<const core::Flow> flow;
    std::shared_ptr<core::TimeStepCache> cache;      ///< null for a built-in flow
    std::shared_ptr<const store::StoreReader> store; ///< behind the cache; null for a built-in flow
    /// The share of its grid; null: not counted.
    std::shared_ptr<core::MemoryAccount::Share> memory{};
    std::shared_ptr<const core::LevelSource> levels{}; ///< null for a built-in flow
    /// The scalars of the store; null for a built-in flow.
    std::shared_ptr<const store::StoreScalars> scalars{};
    std::shared_ptr<core::MemoryAccount::Share>
        kept_memory{}; ///< of its families and means; likewise
    /// The job that holds its bricks; null without one.
    std::shared_ptr<const RankedStore> ranks{};
    std::string flow_text{}; ///< of a built-in flow, behind `flow:`; empty: a store
};

/// Says how a store is opened.
struct StoreOptions {
    core::TimeStepCache::Options cache;
    /// The job beside the server that holds bricks, if time-steps do not fit; the store's folder is filled
    /// in.
    std::optional<RankBricks::Options> ranks{};
    std::stop_token closing{}; ///< ends all questions to a web server
};

struct OpenOptions {
    std::filesystem::path store_root; ///< where sources are imported to
    core::TimeStepCache::Options cache;
    std::filesystem::path importer{}; ///< empty: wakesurf-import beside our own executable
    std::chrono::milliseconds watch_period{2000}; ///< the poll interval for changed data
    std::size_t lanes = 4;                        ///< imports at a time
    command::SourceOptions taken{}; ///< of all sources; times are refused for other data
    std::optional<RankBricks::Options> ranks{};   ///< as in StoreOptions
    std::vector<std::filesystem::path> secrets{}; ///< what no source may name: the server's own

    StoreOptions of_store() const { return {cache, ranks}; }
};

/// Opens a built-in flow. Error: InvalidArgument, NotFound (the list of names).
core::Result<LoadedDataset> open_flow(const DatasetArgument& argument);

/// Says whether the time-steps of a store, and its scalars, are read brick by brick, or whole.
struct HowServed {
    /// True on the web, to read as little as possible, and if four time-steps do not fit.
    bool by_brick = false;
    /// The memory for whole time-steps, beside the grid and sampling scalars.
    std::size_t room = 0;
};

/// Decides as open_store does. @param options  with the memory. @param chunk_bytes  the least of it for
/// chunks of a Zarr
HowServed how_served(const store::StoreReader& reader,
                     const core::TimeStepCache::Options& options,
                     std::size_t chunk_bytes = 0);

/// Opens a store, complete or still being written. @param options  the budget, or the account, is for its
/// grid as well. Error: as read_store_manifest and StoreReader::open; OverLimit if that does not hold the
/// grid and 4 time-steps.
core::Result<LoadedDataset> open_store(const std::filesystem::path& folder,
                                       const StoreOptions& options);

/// Opens the same store again: with the cache and the ranges of `open`, as long as it is the same series of
/// the same values. Error: as open_store.
core::Result<LoadedDataset> open_again(const LoadedDataset& open,
                                       const std::filesystem::path& folder,
                                       const StoreOptions& options);

/// Replaces the families and means among the fields of the dataset.
void list_kept_fields(core::DatasetInfo& info, const store::StoreScalars& scalars);

/// Returns the dataset with the families and means that are in its store now.
LoadedDataset with_kept_fields(LoadedDataset open, const core::TimeStepCache::Options& cache);

/// Says whether the store on the disk has all values of the open one, and perhaps more.
bool still_there(const LoadedDataset& open);

/// Returns the number of time-steps that can be used now.
std::size_t steps_ready(const LoadedDataset& open);

/// Returns the text that identifies its values: store::ValueMarks::text. Empty for a built-in flow.
std::string values_of(const LoadedDataset& open);

/// Opens what the argument names, imported first if needed: blocks until the import is complete. Error: as
/// importing and opening; Cancelled.
core::Result<LoadedDataset>
open_dataset(const DatasetArgument& argument,
             const OpenOptions& options,
             const std::function<void(const store::ImportProgress&)>& listener,
             std::stop_token stop = {});

} // namespace wakesurf::server
