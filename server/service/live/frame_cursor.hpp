// One subscriber's place among the updates of a surface: which frame its connection sends next, decided when its socket can
// take one. It holds no frames, so a slow client costs nothing; one that falls behind goes on with a keyframe.
#pragma once

#include "server/service/live/update_ring.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

namespace wakesurf::server {

/// A state of a surface: update `seq` of an epoch.
struct UpdatePosition {
    std::uint32_t epoch = 0;
    std::uint32_t seq = 0;

    auto operator<=>(const UpdatePosition&) const = default;
};

/// Loop thread only.
class FrameCursor {
  public:
    using Frame = std::shared_ptr<const std::vector<std::byte>>;
    /// true: it has fallen behind and stale updates are left out; false: it has caught up.
    using Notice = std::function<void(bool behind)>;
    /// So many stale frames have not been sent, and will not be.
    using LeftOut = std::function<void(std::uint64_t frames)>;

    /// @param from  the state the client has, from an earlier connection
    FrameCursor(std::shared_ptr<UpdateRing> ring,
                std::optional<UpdatePosition> from,
                Notice notice,
                LeftOut left_out = {});

    /// True when what follows `from` is still there.
    bool resumed() const { return resumed_; }

    /// The next frame to send, or nothing now. May call the notice.
    Frame next();

    /// The client has folded everything up to here. Positions it was not sent are as good as the newest before them.
    void acknowledge(UpdatePosition position);

    const UpdateRing& ring() const { return *ring_; }

    /// Calls `wake` whenever next() may have something, as long as the cursor lives.
    void wake_by(std::function<void()> wake) { news_ = ring_->listen(std::move(wake)); }

    /// True while updates are left out.
    bool behind() const { return behind_; }

  private:
    SharedUpdate choose();
    void start(SharedUpdate update);
    void stop();
    void leave_out(std::uint64_t frames) const;
    void fall_behind();
    bool window_open(bool half) const;

    std::shared_ptr<UpdateRing> ring_;
    std::shared_ptr<void> news_;
    Notice notice_;
    LeftOut left_out_;
    bool resumed_ = false;
    bool behind_ = false;
    bool met_ = false;                    ///< the client has a state, of whichever epoch
    std::optional<UpdatePosition> state_; ///< of the newest whole update sent
    SharedUpdate sending_;
    std::size_t frame_ = 0;               ///< of `sending_`
    std::optional<std::uint64_t> passed_; ///< frames of the ring up to the newest update begun
    bool acknowledges_ = false;
    std::deque<UpdatePosition> unacknowledged_;
};

} // namespace wakesurf::server
