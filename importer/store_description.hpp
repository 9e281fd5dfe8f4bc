// The description of an import in store.json: its grid, fields and ranges.
#pragma once

#include "importer/first_step.hpp"
#include "store/store_manifest.hpp"

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

} // namespace wakesurf::importer
