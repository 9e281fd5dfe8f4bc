// The shortest steps of a curve that goes cell by cell. One that grazes a face may cross it back and forth at
// once, and then continues for a little regardless.
#pragma once

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

/// Velocities on either side of a face may both point at it, or fall to zero there: the particle then slides
/// along. With the shortest steps alone a sheet on a snappyHexMesh sphere was busy without end (50,000 steps
/// for a fiftieth of a cell), and so was one of a sampled tornado (20,000 steps for five cells). The steps
/// double, up to a hundredth of the cell.
class GrazingSteps {
  public:
    /// A part of the time in which the particle would cross its cell.
    static constexpr double shortest = 1e-5;

    /// Returns how long the next step is at least, in the units of `exit`.
    double least(double exit) {
        if (exit > 0.1)
            short_steps_ = 0;
        const double least =
            std::min(std::ldexp(shortest, std::max(short_steps_ - round_a_corner, 0)), longest);
        if (exit < least)
            ++short_steps_;
        return least;
    }

  private:
    static constexpr double longest = 1e-2;
    /// Counts the cells whose corners a path may cut one after another.
    static constexpr int round_a_corner = 6;

    int short_steps_ = 0; ///< since it last crossed a cell
};

} // namespace wakesurf::core
