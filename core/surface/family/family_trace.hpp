// The scalar of a family at the nodes of a grid: each node is traced along the flow to where the scalar is
// given.
#pragma once

#include "core/base/work_done.hpp"
#include "core/dataset/grid.hpp"
#include "core/dataset/scalar_steps.hpp"
#include "core/surface/family/family_plan.hpp"

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Counts what became of the nodes.
struct FamilyCounts {
    std::uint64_t nodes = 0;
    std::uint64_t reached = 0;  ///< have a value; no others have
    std::uint64_t at_rest = 0;  ///< came to rest, or are at rest
    std::uint64_t obstacle = 0; ///< are in an obstacle, or their way ends at one
    std::uint64_t lost = 0;     ///< went the longest way, as where the flow turns in circles
    std::uint64_t outside = 0;  ///< left the domain beside the source, or have no velocity
    std::array<double, 2> range{0.0, 0.0}; ///< of the values

    bool operator==(const FamilyCounts&) const = default;
};

struct FamilyField {
    std::vector<float> values; ///< one a node; NaN: the node has none
    FamilyCounts counts;
};

/// A field whose values a family's source takes: a scalar at one time-step.
struct SourceScalar {
    /// Null if the plan's scalar is a coordinate, or a distance.
    const ScalarSource* source = nullptr;
    std::size_t scalar = 0;
};

/// Traces every node upstream to the source, and where it is not there, downstream. Runs in parallel in the
/// caller's arena; the values do not depend on the number of threads.
/// @param grid  that the flow is stored on Error: InvalidArgument where no node has a value, Cancelled,
///              OverLimit, and what reading reports.
Result<FamilyField> trace_family(const Flow& flow,
                                 const Grid& grid,
                                 const FamilyPlan& plan,
                                 const SourceScalar& scalar,
                                 const std::stop_token& stop,
                                 const WorkPart& work = {});

} // namespace wakesurf::core
