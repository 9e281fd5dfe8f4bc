// The fields of which slices show values: those at nodes, and the velocity across the plane, whose integral is what flows through it.
#pragma once

#include "core/base/vec3.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/field/sampled_field.hpp"
#include "server/data/node_fields.hpp"

#include <string>
#include <string_view>

namespace wakesurf::server {

/// Names the component of the velocity along the plane's normal.
inline constexpr std::string_view velocity_normal_name = "velocity_normal";

/// Finds a field by its name, as find_node_field, or `velocity_normal` where no field has that name. It must not outlive `scalars`.
/// @param normal  of the plane, of any length. Error: as find_node_field.
core::Result<core::SampledField> slice_field(const std::string& name,
                                             const core::DatasetInfo& info,
                                             const store::StoreScalars* scalars,
                                             const core::Vec3& normal,
                                             std::string_view parameter = "field");

/// Returns the field of `other` that is subtracted from the one of this name in `from`; the velocity is subtracted from the velocity, whatever
/// they are called. Error: NotFound where there is none; InvalidArgument where the units are known and others; OutOfDomain where they share no
/// place.
core::Result<core::SampledField> subtracted_field(const std::string& name,
                                                  const core::DatasetInfo& from,
                                                  const core::DatasetInfo& other,
                                                  const store::StoreScalars* scalars_of_other,
                                                  const core::Vec3& normal);

} // namespace wakesurf::server
