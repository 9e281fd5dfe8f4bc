// A family of stream surfaces of a dataset: its scalar is traced, and stored as a field like any other.
// Shared by `family.make` and `wakesurf family`.
#pragma once

#include "core/base/work_done.hpp"
#include "core/surface/family/family_record.hpp"
#include "server/data/open_dataset.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// The most families of a dataset for holders of links, who cannot remove them: more are the host's alone.
inline constexpr std::size_t families_of_links = store::most_families / 2;

struct FamilyWish {
    std::string name;
    core::FamilyRequest request;
    std::vector<double> times;               ///< the nearest time-steps; empty: the first one
    std::size_t most = store::most_families; ///< with those that there are
};

/// Checks a wish as far as possible without tracing. Loads no data. Error: Unsupported (a built-in flow),
/// InvalidArgument (an invalid or used name, a missing scalar), OutOfTime, OverLimit, and as
/// store::check_room_for.
core::Result<void> check_family(const LoadedDataset& dataset, const FamilyWish& wish);

/// Traces and stores it, in the caller's arena. If it ends early nothing is stored. Error: as check_family,
/// plan_family and trace_family; Io.
core::Result<core::FamilyRecord> make_family(const LoadedDataset& dataset,
                                             const FamilyWish& wish,
                                             const std::stop_token& stop,
                                             const core::WorkPart& work = {});

/// Removes a family. Error: Unsupported (a built-in flow), NotFound, Io.
core::Result<void> remove_family(const LoadedDataset& dataset, const std::string& name);

} // namespace wakesurf::server
