// A family of stream surfaces as it is requested, and the plan made of it for a flow and a time: checked, and
// with the plane that its curve lies in.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/family/plane_curve.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>

namespace wakesurf::core {

/// The part of the domain's boundary through which the flow enters.
struct FamilyInflow {
    bool operator==(const FamilyInflow&) const = default;
};

/// Passages count where the flow goes the way most of it does. A node that no such passage leads to or comes
/// from takes one the other way.
struct FamilyPlane {
    Vec3 point{0.0};
    Vec3 normal{0.0, 0.0, 1.0}; ///< of any length

    bool operator==(const FamilyPlane&) const = default;
};

/// On an inflow or a plane the scalar is `scalar`; for a rake it is the distance from it
/// in its plane, positive on one side.
struct FamilyRequest {
    std::variant<FamilyInflow, FamilyPlane, Rake> source;
    std::string scalar{"y"}; ///< x, y or z, a coordinate; else a scalar field of the dataset
    Accuracy accuracy = Accuracy::Balanced;
    /// The longest way along which a node is followed, a length; 0: ten of the domain's diagonals.
    double length = 0.0;

    bool operator==(const FamilyRequest&) const = default;
};

/// Returns which coordinate the scalar is, 0 to 2; -1 for a field.
inline int coordinate_axis(const std::string& scalar) {
    return scalar == "x" ? 0 : scalar == "y" ? 1 : scalar == "z" ? 2 : -1;
}

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
