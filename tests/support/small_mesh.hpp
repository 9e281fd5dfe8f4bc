// Two small cells beside one large one: the least mesh with a hanging node.
#pragma once

#include "core/surface/quad_complex.hpp"

namespace wakesurf::tests {

/// Vertices 0..7; cell 0 has five points because vertex 6 hangs on its far side.
///
///     4 --- 7 --- 5
///     |  1  6  2  |     (6 is the middle of 2-3, shared by all three cells)
///     3 --- 6 --- 2
///     |     0     |
///     0 --------- 1
inline core::QuadComplex small_mesh() {
    core::QuadComplex mesh;
    mesh.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1},       {0, 1, 1e-17},
                     {0, 2, 0}, {1, 2, 0}, {0.5, 1, 1.0 / 3}, {0.5, 2, 0}};
    mesh.s = {0, 1, 1, 0, 0, 1, 0.5, 0.5};
    mesh.t = {0, 0, 1, 1, 2, 2, 1, 2};
    mesh.velocity.assign(8, core::Vec3f(3, 0, 4));
    mesh.deformation = {0, 0, 0.5F, 0.5F, 1, 1, 0.5F, 1};
    mesh.component.assign(8, 0);
    mesh.approximated = {0, 0, 0, 0, 0, 0, 1, 0};
    const auto none = core::no_vertex;
    mesh.cells = {{{0, 1, 2, 3}, {none, none, 6, none}},
                  {{3, 6, 7, 4}, {none, none, none, none}},
                  {{6, 2, 5, 7}, {none, none, none, none}}};
    return mesh;
}

} // namespace wakesurf::tests
