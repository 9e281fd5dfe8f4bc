// Where a curve passes a plane: the roots of its dense output, step by step.
#pragma once

#include "core/integrate/curve.hpp"
#include "core/surface/family/family_plan.hpp"

#include <optional>

namespace wakesurf::core {

/// Finds the first passages of one curve, in the order of its steps.
class PlanePassages {
  public:
    /// Looks at a step. False: the main passage is found.
    /// @param sign  +1 downstream, -1 upstream
    bool look(const SourcePlane& plane, const Curve& curve, const CurveStep& step, double sign);

    /// Ends a curve after its last step. A curve that ends in the plane, as where that is a face of the
    /// domain, passes there.
    /// @param slack  how far from the plane it still ends in it
    void end(const SourcePlane& plane, const Curve& curve, double sign, double slack);

    std::optional<Vec3> main;  ///< the way the normal points, as the flow goes
    std::optional<Vec3> other; ///< the other way

  private:
    void pass(const Vec3& at, bool rising, double sign);

    int side_ = 0; ///< of the plane, where the last step ended; 0: there was none
};

} // namespace wakesurf::core
