// The description of a family beside its values: its request, the version that made it, and its outcome at
// each time-step.
#pragma once

#include "core/surface/family/family_plan.hpp"
#include "core/surface/family/family_trace.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace wakesurf::core {

struct FamilyStep {
    std::size_t index = 0; ///< of the time-step
    double time = 0.0;
    FamilyCounts counts;

    bool operator==(const FamilyStep&) const = default;
};

struct FamilyRecord {
    std::string name; ///< as fields are called
    FamilyRequest request;
    std::string version;           ///< of the program
    std::vector<FamilyStep> steps; ///< at least one; at other time-steps there are no values

    bool operator==(const FamilyRecord&) const = default;
};

} // namespace wakesurf::core
