// A dataset ready to be used: its description, the flow that carries particles, and the cache behind it.
#pragma once

#include "command/source_options.hpp"
#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/dataset/time_step_cache.hpp"
#include "core/field/flow.hpp"
#include "server/service/bricks/ranked_store.hpp"
#include "server/service/catalogue/dataset_argument.hpp"
#include "server/service/levels/level_sets.hpp"
#include "store/import_progress.hpp"
#include "store/store_reader.hpp"
#include "store/store_scalars.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace wakesurf::server {

struct LoadedDataset {
    core::DatasetInfo info;
    std::shared_ptr<const core::Flow> flow;
    std::shared_ptr<core::TimeStepCache> cache;      ///< null for a built-in flow
    std::shared_ptr<const store::StoreReader> store; ///< behind the cache; null for a built-in flow
    std::shared_ptr<core::MemoryAccount::Share> memory{}; ///< of its grid; null where no one counts
    std::shared_ptr<const LevelSets> levels{}; ///< of its fields; null for a built-in flow
    std::shared_ptr<const store::StoreScalars>
        scalars{}; ///< of the store; null for a built-in flow
    std::shared_ptr<core::MemoryAccount::Share> family_memory{}; ///< of its families; likewise
    std::shared_ptr<const RankedStore> ranks{}; ///< who holds its bricks; null where nobody does
};

/// Says how a store is opened.
struct StoreOptions {
    core::TimeStepCache::Options cache;
    /// A job beside the server holds bricks, where time-steps do not fit; the store's folder is filled in.
    std::optional<RankBricks::Options> ranks{};
};

struct OpenOptions {
    std::filesystem::path store_root; ///< where sources are imported to
    core::TimeStepCache::Options cache;
    std::filesystem::path importer{}; ///< empty: wakesurf-import beside our own executable
    std::chrono::milliseconds watch_period{
        2000};                      ///< how often a server looks whether data have changed
    std::size_t lanes = 4;          ///< imports at a time
    command::SourceOptions taken{}; ///< of all sources; times are refused for what is no source
    std::optional<RankBricks::Options> ranks{}; ///< as in StoreOptions

    StoreOptions of_store() const { return {cache, ranks}; }
};

/// Error: InvalidArgument, NotFound (the list of names).
core::Result<LoadedDataset> open_flow(const DatasetArgument& argument);

/// Says whether the time-steps of a store, and its scalars, are read brick by brick, or whole.
struct HowServed {
    /// On the web, where the less is read the better, and where four time-steps do not fit.
    bool by_brick = false;
    /// Bytes that there are for whole time-steps, beside the grid and what sampling scalars takes.
    std::size_t room = 0;
};

/// Decides as open_store does. @param options  with the memory. @param chunk_bytes  of it that chunks of a
/// Zarr take at least
HowServed how_served(const store::StoreReader& reader,
                     const core::TimeStepCache::Options& options,
                     std::size_t chunk_bytes = 0);

/// A store, whole or still being written. @param options  the budget, or the account, is for its grid as
/// well. Error: as read_store_manifest and StoreReader::open; OverLimit where that does not hold the grid
/// and 4 time-steps.
core::Result<LoadedDataset> open_store(const std::filesystem::path& folder,
                                       const StoreOptions& options);

/// Opens the same store as what is open of it: with its cache, and with ranges known now, as long as it is
/// the same series of the same values. Error: as open_store.
core::Result<LoadedDataset> open_again(const LoadedDataset& open,
                                       const std::filesystem::path& folder,
                                       const StoreOptions& options);

/// The families become fields of the dataset, in the place of those listed before.
void list_families(core::DatasetInfo& info, const store::StoreScalars& scalars);

/// Returns the same, with the families that are in its store now.
LoadedDataset with_families(LoadedDataset open, const core::TimeStepCache::Options& cache);

/// The store on the disk has all the values of what is open of it, and perhaps more.
bool still_there(const LoadedDataset& open);

/// Time-steps that can be used now.
std::size_t steps_ready(const LoadedDataset& open);

/// Returns what its values are told from others by: store::ValueMarks::text. Empty for a built-in flow.
std::string values_of(const LoadedDataset& open);

/// Whatever the argument names, imported first where that is needed: blocks until the import is complete.
/// Error: what importing and opening report; Cancelled.
core::Result<LoadedDataset>
open_dataset(const DatasetArgument& argument,
             const OpenOptions& options,
             const std::function<void(const store::ImportProgress&)>& listener,
             std::stop_token stop = {});

} // namespace wakesurf::server
