// A quad complex as triangles, for formats that know nothing else. A cell's outline, hanging nodes included,
// is cut along its best diagonals, so neighbours share every edge and the triangles are as watertight as the
// quads.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wakesurf::protocol {

using Triangle = std::array<std::uint32_t, 3>;

/// Appends the 2 to 6 triangles of one cell, counter-clockwise like the cell. Of all ways to cut it, this is
/// the one whose flattest triangle is least flat (area over the sum of the squared sides), so that a hanging
/// node on a straight side makes no sliver if that can be avoided. Same input, same triangles.
void append_triangles(const core::QuadComplex& mesh,
                      const core::Cell& cell,
                      std::vector<Triangle>& out);

/// Returns the triangles of every cell, in order. Cost: 0.1 microseconds a plain quad, 2 a cell with four
/// hanging nodes.
std::vector<Triangle> triangles_of(const core::QuadComplex& mesh);

/// Returns normals for programs that shade by them and know only flat triangles without: of length 1 for each vertex: the mesh's own, else the mean of its triangles' normals by
/// their areas, (0, 0, 1) if there is none or they cancel. Same input, same bytes.
std::vector<core::Vec3f> vertex_normals(const core::QuadComplex& mesh,
                                        const std::vector<Triangle>& triangles);

} // namespace wakesurf::protocol
