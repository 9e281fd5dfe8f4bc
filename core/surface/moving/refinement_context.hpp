// The data that the phases of a moving surface's refinement work on.
#pragma once

#include "core/field/flow.hpp"
#include "core/surface/moving/moving_mesh.hpp"
#include "core/surface/moving/refinement_rules.hpp"

#include <stop_token>

namespace wakesurf::core {

struct RefinementContext {
    MovingMesh& mesh;
    const Flow& flow;
    const RefinementRules& rules; ///< as now in force
    /// Ends every phase where it is when it is requested: the mesh is of no use then.
    const std::stop_token stop{};

    /// Returns the squared length of a part of the separation.
    double squared_separation(double part = 1.0) const {
        return part * part * rules.separation * rules.separation;
    }

    /// Longest edge allowed, squared, with what rounding may add: what is made just as long is not cut again.
    double longest_allowed() const { return squared_separation() * (1.0 + 2e-9); }
};

} // namespace wakesurf::core
