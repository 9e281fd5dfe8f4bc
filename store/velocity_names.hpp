// The meaning of an array's name: a velocity of the fluid, a part of one, a momentum, or something else.
#pragma once

#include "core/dataset/dataset_info.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

enum class VectorName {
    Velocity,  ///< U, velocity, vel
    Qualified, ///< a velocity with words that leave it the fluid's: flow velocity, GasVelocity [m/s]
    Unclear,   ///< a velocity with words that are not known: relative velocity
    Average,   ///< UMean, velocity_avg
    Momentum,
    Other, ///< another quantity, a velocity of something else than the fluid, or a single component's
    Unknown
};

/// Returns the meaning of a 3-component array.
VectorName meaning_of_vector(const std::string& name);

bool is_density(const core::FieldInfo& field);

/// Three 1-component arrays of one place, in the order x, y, z.
using Components = std::vector<core::FieldInfo>;

/// Returns every triple with the names of components: u v w, VelocityX.., x_velocity.., vel1.., vx1..,
/// "Velocity[i] (m/s)".. Names that differ by capital letters only are distinct.
std::vector<Components> velocity_components(const std::vector<core::FieldInfo>& fields,
                                            core::FieldInfo::Source source);
std::vector<Components> momentum_components(const std::vector<core::FieldInfo>& fields,
                                            core::FieldInfo::Source source);

} // namespace wakesurf::store
