// vtkStreaklineFilter on a sampled flow: the peer for carrying many particles through unsteady data.
#pragma once

#include "tests/bench/support/sampled_flows.hpp"

#include <span>

namespace wakesurf::bench {

/// 200 seeds, released again at every one of 65 time-steps. The filter does two RK4 steps in each interval whatever one
/// asks for (docs/measurements.md, VTK's filters); both are counted.
class VtkStreaklines {
  public:
    explicit VtkStreaklines(const SampledFlow& flow);

    /// Seconds from the first time-step to the last, without making the filter. Time-steps are handed over in memory.
    double run() const;

    /// RK4 steps of particles one run takes, those that leave within an interval counted as whole.
    double vertex_steps() const { return vertex_steps_; }

  private:
    const SampledFlow& flow_;
    double vertex_steps_ = 0.0;
};

} // namespace wakesurf::bench
