// How the velocity changes from place to place at points of a flow, and what of that shows vortices: the vorticity, and the Q
// criterion (Hunt, Wray and Moin, CTR Proceedings 1988).
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"
#include "core/field/flow.hpp"

#include <glm/mat3x3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

namespace wakesurf::core {

/// Column k is the derivative of the velocity along axis k, by central differences over two steps; one-sided where a neighbour
/// is outside the domain or in an obstacle, over shorter steps where both are, NaN where the point is. Second order in the step.
/// @param times  one a point
/// @param step   > 0, for a stored field its node spacing
/// Error: Cancelled, what sampling reports. Cost: seven samples a point; time-steps are asked for in their order.
Result<std::vector<glm::dmat3>> velocity_gradients(const Flow& flow,
                                                   std::span<const Vec3> positions,
                                                   std::span<const double> times,
                                                   double step,
                                                   const std::stop_token& stop);

/// |curl v|, 1/s.
double vorticity(const glm::dmat3& gradient);

/// Half of what the squared norm of the rotation rate is above that of the strain rate, 1/s^2: positive in a vortex.
double q_criterion(const glm::dmat3& gradient);

/// What can be asked for at the vertices of a surface.
enum class GradientField : std::uint8_t { Vorticity, QCriterion };

inline constexpr std::string_view vorticity_name = "vorticity";
inline constexpr std::string_view q_criterion_name = "q_criterion";

/// By the names that files and frames have for it.
std::optional<GradientField> find_gradient_field(std::string_view name);

/// One list of values a field, nothing sampled where there is none; of the flow's finest detail, NaN where the gradient is.
/// Error: Cancelled, what sampling reports. Thread safety: concurrent calls are fine.
Result<std::vector<std::vector<float>>>
sample_gradient_fields(std::span<const GradientField> fields,
                       const Flow& flow,
                       std::span<const Vec3> positions,
                       std::span<const double> times,
                       const std::stop_token& stop);

} // namespace wakesurf::core
