// What the values of a surface range over, told to everybody who looks at it, so that colours mean the same to all of them. While it
// plays, ranges only grow: a colour that has been seen keeps its meaning until somebody makes it another surface.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/wire/wire_mesh.hpp"
#include "server/service/base/value_ranges.hpp"
#include "server/service/live/surface_job.hpp"

namespace wakesurf::server {

/// Of speed, t and the fields of one state; s is from 0 to 1 always. What is told of t is the age: of a streak surface what has passed
/// since the release. Of it nothing is left out.
/// @param time  simulation time of the state
ValueRanges ranges_of(const SurfaceJob& job,
                      const core::QuadComplex& mesh,
                      const protocol::MeshFields& fields,
                      double time);

/// Whether both are one surface whose playing shows: the same data, rake and parameters. The field of a stream surface plays by being frozen
/// at one time after the other; other fields may be asked for.
bool plays_on(const SurfaceJob& before, const SurfaceJob& now);

class ToldRanges {
  public:
    /// Another surface.
    void begin();

    /// Of a further state. One of less than full quality has ranges of its own, which hold until there is one of full quality.
    /// Returns whether told() is another now.
    bool add(const ValueRanges& ranges, bool early);

    const ValueRanges& told() const { return told_; }

  private:
    ValueRanges full_; ///< of all states of full quality
    ValueRanges told_;
};

} // namespace wakesurf::server
