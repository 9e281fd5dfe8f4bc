// A velocity of one's own as a flow: any function of place and time, sampled exactly, never through a grid.
#pragma once

#include "core/base/box.hpp"
#include "core/base/vec3.hpp"
#include "core/dataset/wall_geometry.hpp"
#include "core/field/flow.hpp"

#include <functional>
#include <memory>

namespace wakesurf::core {

/// Velocity at a place and time, in the units that places and times are in. Many threads call it at once. It
/// is smooth, finite also a little beyond the domain and inside a body, and depends on nothing but its
/// arguments: surfaces are then the same on any number of threads.
using VelocityFunction = std::function<Vec3(const Vec3& position, double time)>;

/// Describes the solid that stands in the flow.
struct FlowBody {
    /// Particles end where it returns true; many threads may call it at once.
    std::function<bool(const Vec3& position)> solid;
    WallGeometry wall{}; ///< for display; may be empty
};

/// Makes a flow in a box, known at all times. Its `finest_spacing` is 1/100 of the box's shortest side.
std::unique_ptr<Flow> make_function_flow(VelocityFunction velocity, const Box& domain);

/// Makes a flow round a body. REQUIRES: `body.solid` is set.
std::unique_ptr<Flow>
make_function_flow(VelocityFunction velocity, const Box& domain, FlowBody body);

} // namespace wakesurf::core
