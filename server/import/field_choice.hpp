// Which arrays of a source are its velocity and its solid mask: the rules, apart from any reader.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

struct FieldChoice {
    core::FieldInfo velocity;
    std::string why;
    std::optional<core::FieldInfo> mask;
    bool mask_marks_solid = false; ///< 1 means solid instead of fluid
};

/// Velocity: the 3-component array called U, velocity or vel (any case), else the only 3-component one; point
/// arrays go before cell arrays, and `wanted` (--fields), where given, before everything. Mask: the 1-component
/// array called mask, fluid, fluid_mask or vtkValidPointMask (1 = fluid), or solid, solid_mask or obstacle
/// (1 = solid). Error: NotFound (no vector field; a wanted field is not there), InvalidArgument (several
/// candidates), each listing what there is; Unsupported (a wanted field that is neither).
core::Result<FieldChoice> choose_fields(const std::vector<core::FieldInfo>& fields,
                                        const std::vector<std::string>& wanted);

} // namespace wakesurf::server
