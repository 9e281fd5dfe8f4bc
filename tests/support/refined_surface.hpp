// A surface the engine made, with hanging nodes on it.
#pragma once

#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"

namespace wakesurf::tests {

/// Returns about 1,000 cells of a stream surface in the ABC flow, which folds and shears it.
inline core::QuadComplex refined_surface() {
    core::Rake rake{.points = {{0.5, 0, 0}, {2.5, 0.3, 1}}, .seeds = 8};
    core::SurfaceParameters parameters{.to = 6, .separation = 0.2, .deformation = true};
    return core::build_surface(**core::make_analytic_flow("abc"), rake, parameters).value().mesh;
}

} // namespace wakesurf::tests
