// From what a family is asked to be, a flow and a time to how its nodes are traced: checked, and with the
// plane that its curve lies in.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/family/family_request.hpp"
#include "core/surface/family/plane_curve.hpp"

#include <optional>
#include <span>
#include <stop_token>

namespace wakesurf::core {

/// A plane that the flow passes.
struct SourcePlane {
    Vec3 point{0.0};
    Vec3 normal{0.0}; ///< of length 1, the way most of the flow passes

    double height(const Vec3& at) const { return glm::dot(at - point, normal); }
};

/// The request that plan_family has checked and completed; a value.
struct FamilyPlan {
    FamilyRequest request;
    double time = 0.0;
    TraceOptions trace;
    double length = 0.0;   ///< longest way of a node
    double duration = 0.0; ///< in which even the slowest that counts as moving goes so far
    std::optional<SourcePlane> plane; ///< none: the inflow
    std::optional<PlaneCurve> curve;  ///< none: the scalar is `request.scalar`
};

/// @param some  places of the data's nodes, by which it is told how fast the flow is Error: InvalidArgument
///              (a curve that is not planar, a normal without length, a flow that does not pass plane or
///              curve, or stands still), OutOfDomain (plane or curve outside), Cancelled, and what sampling
///              reports.
Result<FamilyPlan> plan_family(const Flow& flow,
                               const FamilyRequest& request,
                               double time,
                               std::span<const Vec3> some,
                               const std::stop_token& stop);

} // namespace wakesurf::core
