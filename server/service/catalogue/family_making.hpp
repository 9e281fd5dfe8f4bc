// A family of stream surfaces of a dataset: its scalar is traced, and kept in the dataset's store as a field
// like any other. What `family.make` and `wakesurf family` share.
#pragma once

#include "core/base/work_done.hpp"
#include "core/surface/family/family_record.hpp"
#include "server/service/catalogue/open_dataset.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct FamilyWish {
    std::string name;
    core::FamilyRequest request;
    std::vector<double> times; ///< the nearest time-steps; empty: the first one
};

/// Checks what can be told without tracing. Loads no data.
/// Error: Unsupported (a built-in flow), InvalidArgument (a name that is taken or none, a scalar that is not
/// there), OutOfTime, OverLimit, and what check_room_for_family reports.
core::Result<void> check_family(const LoadedDataset& dataset, const FamilyWish& wish);

/// Traces and keeps it. Runs in the caller's arena. Nothing is left of it where it ends early.
/// Error: as check_family, plan_family and trace_family; Io.
core::Result<core::FamilyRecord> make_family(const LoadedDataset& dataset,
                                             const FamilyWish& wish,
                                             const std::stop_token& stop,
                                             const core::WorkPart& work = {});

/// Error: Unsupported (a built-in flow), NotFound, Io.
core::Result<void> remove_family(const LoadedDataset& dataset, const std::string& name);

} // namespace wakesurf::server
