// vtkStreaklineFilter on a sampled flow: the peer for carrying many particles through unsteady data.
#pragma once

#include "tests/bench/support/sampled_flows.hpp"

#include <span>

namespace wakesurf::bench {

/// Carries 200 seeds, released again at every one of 65 time-steps. The filter always does two RK4 steps in
/// each interval (docs/measurements.md, VTK's filters); both are counted.
class VtkStreaklines {
  public:
    explicit VtkStreaklines(const SampledFlow& flow);

    /// Returns the seconds from the first time-step to the last, without making the filter. Time-steps are
    /// handed over in memory.
    double run() const;

    /// Returns the RK4 steps of particles of one run, those that leave within an interval counted as whole.
    double vertex_steps() const { return vertex_steps_; }

  private:
    const SampledFlow& flow_;
    double vertex_steps_ = 0.0;
};

} // namespace wakesurf::bench
