// A uniform flow that a wall and a ball end: where a particle meets them is known.
#pragma once

#include "core/base/point_status.hpp"
#include "core/base/vec3.hpp"

namespace wakesurf::tests {

/// x >= 1 is outside, a ball of radius 0.25 at (0.5, 0, 0) is solid; the flow goes along x.
struct WalledFlow {
    core::Vec3 velocity(const core::Vec3&, double) const { return {2.0, 0.0, 0.0}; }

    core::Vec3 derivative(const core::Vec3&, double, const core::Vec3&) const {
        return core::Vec3(0.0);
    }

    core::PointStatus status(const core::Vec3& p) const {
        if (p.x > 1.0)
            return core::PointStatus::OutsideDomain;
        return glm::length(p - core::Vec3(0.5, 0, 0)) < 0.25 ? core::PointStatus::InObstacle
                                                             : core::PointStatus::Inside;
    }
};

} // namespace wakesurf::tests
