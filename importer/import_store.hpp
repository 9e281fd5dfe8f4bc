// The store of an import: its description in store.json, and the time-steps that an earlier import has left in it and that can be
// reused.
#pragma once

#include "importer/first_step.hpp"
#include "importer/step_conversion.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"
#include "store/store_writer.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace wakesurf::importer {

/// Returns a note on the times of time-steps without a single number for velocity: "no velocity is a number
/// at 3 of 9 time-steps: 0.5, 1, 1.5". Empty if there are none.
std::string note_on_missing_velocity(const std::vector<std::size_t>& steps,
                                     const std::vector<double>& times);

/// Returns everything but the checksums of fixed files and `complete`; ranges are those the reader found in
/// the first time-step. Error: Unsupported for bricks of a mesh of cells.
core::Result<store::StoreManifest> describe_store(const ImportPlan& plan,
                                                  const FirstStepReading& reading);

/// Widens the ranges of the velocity and the scalars by those of a time-step. @param first  replaces them:
/// the reader's ranges are of all its nodes, but only stored values count.
void include(const ImportPlan& plan,
             const StepRecord& record,
             bool first,
             store::StoreManifest& manifest);

/// Returns the sentence about half precision. @param velocity  of the first time-step, for measuring
std::string rounding_note(std::span<const float> velocity);

/// Describes a store of the same source, which may have grown since: the same shared files, selection,
/// precision and layout, and every converted time-step, at least the first, of the same files and at the same
/// time.
struct EarlierImport {
    store::StoreManifest manifest;
    bool same_source = false; ///< not grown
    std::shared_ptr<const store::StoreReader> reader;
    std::vector<bool> reusable; ///< by time-step of the plan: its files are complete
};

/// Returns empty if the store must be made again. The grid's files are checked by their checksums, time-steps
/// by their sizes.
std::optional<EarlierImport> earlier_import(const store::StoreWriter& writer,
                                            const ImportPlan& plan);

/// Returns the record of a reusable time-step, read back. Empty if a file is not as it was written: the time-step
/// must be converted again.
std::optional<StepRecord> recorded(const store::StoreReader& store,
                                   std::size_t index,
                                   const std::vector<std::uint8_t>& fluid);

} // namespace wakesurf::importer
