// Computes how the velocity changes from place to place at points of a flow, and what of that shows vortices:
// the vorticity, and the Q criterion (Hunt, Wray and Moin, CTR Proceedings 1988).
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/field/flow.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

namespace wakesurf::core {

/// The derived fields at the vertices of a surface.
enum class GradientField : std::uint8_t {
    Vorticity, ///< its magnitude
    VorticityX,
    VorticityY,
    VorticityZ,
    QCriterion
};

/// The names that files and frames have for them, in the order of GradientField.
inline constexpr std::array<std::string_view, 5> gradient_field_names{
    "vorticity", "vorticity_x", "vorticity_y", "vorticity_z", "q_criterion"};

/// Returns the field that files and frames call so; empty if there is none.
std::optional<GradientField> find_gradient_field(std::string_view name);

/// One list of values a field, nothing sampled where there is none. The vorticity is curl v, of which there
/// are the magnitude and the components, in 1/s; the Q criterion, in 1/s^2, is half of what the squared norm
/// of the rotation rate is above that of the strain rate: positive in a vortex.
///
/// Gradients are central differences over two of the flow's finest spacings, of second order; one-sided where
/// a neighbour is outside the domain or in an obstacle, over shorter steps where both are, NaN where the
/// point is.
/// @param times  one a point Error: Cancelled, what sampling reports. Cost: seven samples a point; time-steps
///               are asked for in their order. Thread safety: concurrent calls are fine.
Result<std::vector<std::vector<float>>>
sample_gradient_fields(std::span<const GradientField> fields,
                       const Flow& flow,
                       std::span<const Vec3> positions,
                       std::span<const double> times,
                       const std::stop_token& stop);

} // namespace wakesurf::core
