// The bodies of closed forms as geometry to look at. Particles never meet these triangles: a form knows its body exactly.
#pragma once

#include "core/base/box.hpp"
#include "core/dataset/wall_geometry.hpp"

namespace wakesurf::core {

/// Around the origin. Points lie on the sphere, but for those outside `box`, which are put on its border; closed, so that a body
/// which the border cuts is capped there. Nothing for a radius of 0.
WallGeometry sphere_wall(double radius, const Box& box);

/// Around the z axis, all along the box; otherwise as sphere_wall().
WallGeometry cylinder_wall(double radius, const Box& box);

} // namespace wakesurf::core
