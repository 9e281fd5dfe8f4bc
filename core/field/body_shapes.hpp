// The bodies of closed forms as geometry for display. Particles never meet these triangles: a form knows its
// body exactly.
#pragma once

#include "core/base/box.hpp"
#include "core/dataset/wall_geometry.hpp"

namespace wakesurf::core {

/// Returns a sphere around the origin. Points lie on the sphere, but for those outside `box`, which are put
/// on its border; it is closed, so that a body which the border cuts is capped there. Returns nothing for a
/// radius of 0.
WallGeometry sphere_wall(double radius, const Box& box);

/// Returns a cylinder around the z axis, all along the box; its points lie as those of sphere_wall().
WallGeometry cylinder_wall(double radius, const Box& box);

} // namespace wakesurf::core
