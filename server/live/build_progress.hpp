// The progress of a surface towards its complete state: over its passes, also over jobs that are cancelled
// for another time of the clock. It never decreases on one way.
#pragma once

#include "core/base/work_done.hpp"
#include "protocol/wire/mesh_frame.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

namespace wakesurf::server {

struct BuildStatus {
    double fraction = 0.0; ///< of the way, 0..1; early passes are a small part of it
    double seconds = 0.0;  ///< since the beginning of the way
    /// The simulation time that a streak or time surface has reached.
    std::optional<double> time{};
    std::uint64_t quads = 0; ///< of the present pass of full quality
};

/// Tracks the progress. Loop thread only; compute threads report through the WorkDone.
class BuildProgress {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Begins another way, after an edit.
    void begin(Time now);

    /// Starts a pass. If the surface was complete, this begins another way.
    void start(protocol::Phase phase, std::shared_ptr<const core::WorkDone> work, Time now);

    /// Ends the pass, with any result.
    void end();

    /// Marks the surface as complete.
    void arrive();

    BuildStatus status(Time now) const;

  private:
    double fraction() const;

    Time began_{};
    double from_ = 0.0;                          ///< of the way, at the start of the pass
    double to_ = 0.0;                            ///< at the end of the pass
    std::shared_ptr<const core::WorkDone> work_; ///< of the pass that runs
    std::shared_ptr<const core::WorkDone> full_; ///< of the newest one of full quality
    bool there_ = false;
};

} // namespace wakesurf::server
