// The request for a family of stream surfaces: where its scalar is given, and how accurately it is carried
// through the domain. van Wijk, Implicit stream surfaces, 1993: the level sets of a scalar that is constant
// along streamlines are stream surfaces.
#pragma once

#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"

#include <string>
#include <variant>

namespace wakesurf::core {

/// The part of the domain's boundary through which the flow enters.
struct FamilyInflow {
    bool operator==(const FamilyInflow&) const = default;
};

/// Counts where the flow passes it the way most of it does. A node that no such passage leads to or comes
/// from takes one the other way.
struct FamilyPlane {
    Vec3 point{0.0};
    Vec3 normal{0.0, 0.0, 1.0}; ///< of any length

    bool operator==(const FamilyPlane&) const = default;
};

/// Asks for a family. On an inflow or a plane the scalar is `scalar`; for a rake it is the distance from it
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

} // namespace wakesurf::core
