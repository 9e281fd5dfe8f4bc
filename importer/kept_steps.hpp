// The time-steps that an earlier import has left in a store and that are still good.
#pragma once

#include "importer/step_conversion.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"
#include "store/store_writer.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace wakesurf::importer {

/// Describes a store of the same source, which may have grown since: the same shared files, selection,
/// precision and layout, and every converted time-step, at least the first, of the same files and at the same
/// time.
struct EarlierImport {
    store::StoreManifest manifest;
    bool same_source = false; ///< not grown
    std::shared_ptr<const store::StoreReader> reader;
    std::vector<bool> kept; ///< by time-step of the plan: its files are complete
};

/// Returns empty if the store must be made again. The grid's files are checked by their checksums, time-steps
/// by their sizes.
std::optional<EarlierImport> earlier_import(const store::StoreWriter& writer,
                                            const ImportPlan& plan);

/// Returns the record of a kept time-step, read back. Empty if a file is not as it was written: the time-step
/// must be converted again.
std::optional<StepRecord> recorded(const store::StoreReader& store,
                                   std::size_t index,
                                   const std::vector<std::uint8_t>& fluid);

} // namespace wakesurf::importer
