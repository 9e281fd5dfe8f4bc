// How far a surface on its way to what was asked for is: over its passes, over jobs that are given up for another time of the clock, and
// until it is there. The part that is done never shrinks on one way.
#pragma once

#include "core/base/work_done.hpp"
#include "protocol/wire/mesh_frame.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

namespace wakesurf::server {

struct BuildStanding {
    double fraction = 0.0;        ///< of the way; early passes are a little of it
    double seconds = 0.0;         ///< since the way began
    std::optional<double> time{}; ///< simulation time that a streak or time surface has come to
    std::uint64_t quads = 0;      ///< that the pass of full quality has so far
};

/// Loop thread only; those who work tell of it through the WorkDone.
class BuildProgress {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// An edit: another way.
    void begin(Time now);

    /// A pass starts. Where what was asked for was there, this is the beginning of another way.
    void start(protocol::Phase phase, std::shared_ptr<const core::WorkDone> work, Time now);

    /// The pass has ended, whatever came of it.
    void end();

    /// All is there that was asked for.
    void arrive();

    BuildStanding standing(Time now) const;

  private:
    double fraction() const;

    Time began_{};
    double from_ = 0.0;                          ///< of the way, when the pass started
    double to_ = 0.0;                            ///< when it will have ended
    std::shared_ptr<const core::WorkDone> work_; ///< of the pass that runs
    std::shared_ptr<const core::WorkDone> full_; ///< of the newest one of full quality
    bool there_ = false;
};

} // namespace wakesurf::server
