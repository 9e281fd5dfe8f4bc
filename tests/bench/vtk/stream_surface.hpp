// vtkStreamSurface with iterative seeding on a sampled flow: the only adaptive stream surface VTK has. It
// traces one step of equal arc length from its whole front, puts chord mid-points where neighbours are
// farther apart than a step, and goes on from there.
#pragma once

#include "core/surface/rake.hpp"
#include "tests/bench/support/sampled_flows.hpp"

#include <array>
#include <memory>
#include <vector>

namespace wakesurf::bench {

struct Triangles {
    std::vector<core::Vec3> position;
    std::vector<std::array<std::uint32_t, 3>> corner;

    double area() const;

    /// Returns the longest of the triangles' two shorter sides: the third is the diagonal of what would be a
    /// quad.
    double longest_side() const;
};

struct VtkStreamSurface {
    const SampledFlow* flow;
    core::Rake rake;      ///< a line
    double step_in_cells; ///< also the longest distance in a front
    double arc_in_cells;  ///< how far it goes

    /// Builds by RK4, on the first time-step. Returns CPU seconds.
    double build(Triangles* result = nullptr) const;
};

} // namespace wakesurf::bench
