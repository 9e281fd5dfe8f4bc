// A subscriber's position among the updates of a surface: which frame its connection sends next, decided when
// its socket can take one. It holds no frames, so a slow client costs no memory; one that falls behind
// continues with a keyframe.
#pragma once

#include "server/live/update_ring.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

namespace wakesurf::server {

/// Identifies a state of a surface: update `seq` of an epoch.
struct UpdatePosition {
    std::uint32_t epoch = 0;
    std::uint32_t seq = 0;

    auto operator<=>(const UpdatePosition&) const = default;
};

/// Chooses the frames for one subscriber. Loop thread only.
class FrameCursor {
  public:
    using Frame = std::shared_ptr<const std::vector<std::byte>>;
    /// Receives true when the client has fallen behind and stale updates are left out, false when it has
    /// caught up.
    using Notice = std::function<void(bool behind)>;
    /// Receives the number of stale frames that are skipped.
    using LeftOut = std::function<void(std::uint64_t frames)>;

    /// @param from  the state the client has, from an earlier connection
    FrameCursor(std::shared_ptr<UpdateRing> ring,
                std::optional<UpdatePosition> from,
                Notice notice,
                LeftOut left_out = {});

    /// Says whether the updates after `from` are still available.
    bool resumed() const { return resumed_; }

    /// Returns the next frame to send; empty if there is none now. May call the notice.
    Frame next();

    /// Records that the client has folded everything up to `position`. A position that was not sent stands
    /// for the newest before it.
    void acknowledge(UpdatePosition position);

    const UpdateRing& ring() const { return *ring_; }

    /// Calls `wake` whenever next() may have a frame, as long as the cursor lives.
    void wake_by(std::function<void()> wake) { listener_ = ring_->listen(std::move(wake)); }

    /// Says whether updates are being left out.
    bool behind() const { return behind_; }

  private:
    SharedUpdate choose();
    void start(SharedUpdate update);
    void stop();
    void leave_out(std::uint64_t frames) const;
    void fall_behind();
    bool window_open(bool half) const;

    std::shared_ptr<UpdateRing> ring_;
    std::shared_ptr<void> listener_;
    Notice notice_;
    LeftOut left_out_;
    bool resumed_ = false;
    bool behind_ = false;
    bool met_ = false;                    ///< the client has a state, of any epoch
    std::optional<UpdatePosition> state_; ///< of the newest whole update sent
    SharedUpdate sending_;
    std::size_t frame_ = 0;               ///< of `sending_`
    std::optional<std::uint64_t> passed_; ///< frames of the ring up to the newest update begun
    bool acknowledges_ = false;
    std::deque<UpdatePosition> unacknowledged_;
};

} // namespace wakesurf::server
