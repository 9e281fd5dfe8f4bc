// Normals of a surface's vertices, for programs that shade by them and know only flat triangles without.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_triangles.hpp"

#include <vector>

namespace wakesurf::protocol {

/// Returns a normal of length 1 for each vertex: the mesh's own, else the mean of its triangles' normals by
/// their areas, (0, 0, 1) if there is none or they cancel. Same input, same bytes.
std::vector<core::Vec3f> vertex_normals(const core::QuadComplex& mesh,
                                        const std::vector<Triangle>& triangles);

} // namespace wakesurf::protocol
