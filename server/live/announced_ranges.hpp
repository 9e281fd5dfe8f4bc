// The ranges of a surface's values, the same for all its viewers, so that colours mean the same to all of
// them. While it plays, ranges only grow: a colour keeps its meaning until a user makes it another surface.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "protocol/wire/wire_mesh.hpp"
#include "server/live/surface_events.hpp"
#include "server/live/surface_job.hpp"

namespace wakesurf::server {

/// Returns the ranges of speed, t and the fields of one state; s is always from 0 to 1. The range of t is
/// that of the age, for a streak surface the time since the release; it is never clipped.
/// @param time  simulation time of the state
ValueRanges ranges_of(const SurfaceJob& job,
                      const core::QuadComplex& mesh,
                      const protocol::MeshFields& fields,
                      double time);

/// Says whether both are one surface that is playing: the same data, rake and parameters. A stream surface
/// plays by being frozen at successive times; other fields may be requested.
bool plays_on(const SurfaceJob& before, const SurfaceJob& now);

class AnnouncedRanges {
  public:
    /// Begins another surface.
    void begin();

    /// Adds a state. One of less than full quality has ranges of its own, until there is one of full quality.
    /// Returns whether announced() has changed.
    bool add(const ValueRanges& ranges, bool early);

    const ValueRanges& announced() const { return announced_; }

  private:
    ValueRanges full_; ///< of all states of full quality
    ValueRanges announced_;
};

} // namespace wakesurf::server
