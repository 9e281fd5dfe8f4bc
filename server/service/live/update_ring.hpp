// The updates of a surface's newest epoch, encoded once for everybody who looks at it: each subscription reads on from where it
// is. Bounded in bytes and age; who falls behind gets a keyframe of the newest state, made once for all who need one then.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/memory_account.hpp"
#include "core/surface/surface_statistics.hpp"
#include "protocol/wire/mesh_stream.hpp"
#include "server/service/base/pass_seconds.hpp"
#include "server/service/base/value_ranges.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace wakesurf::server {

using protocol::Phase;

/// A state of a surface, and the frames that lead to it. Immutable once published.
struct Update {
    protocol::EncodedUpdate wire;
    core::SurfaceStatistics statistics;
    double time = 0.0;    ///< simulation time shown
    double seconds = 0.0; ///< to build and encode
    PassSeconds took;
    ValueRanges ranges;
    std::shared_ptr<core::MemoryAccount::Share>
        memory{}; ///< of the frames, while somebody holds them
};

using SharedUpdate = std::shared_ptr<const Update>;

/// The share of an update's frames. @param account  null: no one counts
std::shared_ptr<core::MemoryAccount::Share> counted(const core::MemoryAccount* account,
                                                    std::size_t bytes);

/// Loop thread only. Held by shared_ptr: by its surface and by those who read.
class UpdateRing {
  public:
    UpdateRing(std::uint32_t number, const core::Clock& clock, std::function<void()> want_key);
    UpdateRing(const UpdateRing&) = delete;
    UpdateRing& operator=(const UpdateRing&) = delete;

    /// Of the surface on the wire.
    std::uint32_t number() const { return number_; }

    std::uint32_t epoch() const { return epoch_; }

    bool closed() const { return closed_; }

    /// Forgets every update.
    void begin(std::uint32_t epoch);

    /// The next update, based on the newest or a key. Others than of this epoch are forgotten.
    /// @param state  that it leads to: a key can be made of it; needed where the update is none
    void add(SharedUpdate update, std::shared_ptr<const protocol::WireMesh> state = nullptr);

    /// What want_key asked for; null: it could not be made, ask again.
    void add_key(SharedUpdate key);

    /// Drops what is too old or too much; the newest stays.
    void trim();

    /// Drops all but the newest: those who are not there yet get a key.
    void keep_newest();

    /// No one will add anything more; readers have nothing to read.
    void close();

    /// Null before the epoch's first.
    SharedUpdate newest() const { return updates_.empty() ? nullptr : updates_.back(); }

    /// What the newest leads to; null where the newest is a key itself.
    const std::shared_ptr<const protocol::WireMesh>& state() const { return state_; }

    /// Somebody reads, or may go on reading at any moment.
    bool read() const;

    /// The oldest update held if it is a key: where those who have just come to the epoch begin.
    SharedUpdate first() const;

    /// What the holder of the state `seq` reads next: the newest key after it, else the update based on it. Null: not held.
    SharedUpdate after(std::uint32_t seq) const;

    /// Whether a reader that holds the state `seq` is better served by a keyframe than by all that came since.
    bool far_behind(std::uint32_t seq) const;

    /// A key from which it is not far to the newest state, for who holds the state `after_seq` or none. Null: one is asked for
    /// (once) and news follow.
    SharedUpdate key(std::optional<std::uint32_t> after_seq);

    /// Calls `news` whenever there is something new to read, until the ticket is dropped. `news` must not change the ring.
    [[nodiscard]] std::shared_ptr<void> listen(std::function<void()> news);

    std::size_t bytes() const { return bytes_; }

    /// Whether it is one of the updates in a row, and no key made of one on request.
    bool holds(const SharedUpdate& update) const;

    /// How many frames there have been, of all epochs, before the update `seq` of this one: the difference of two is what lies between them.
    std::uint64_t frames_before(std::uint32_t seq) const;

  private:
    using Listener = std::function<void()>;

    void news();

    std::uint32_t number_;
    const core::Clock& clock_;
    std::function<void()> want_key_;
    std::uint32_t epoch_ = 0;
    bool closed_ = false;
    bool key_wanted_ = false;
    std::deque<SharedUpdate> updates_; ///< oldest first, consecutive
    std::shared_ptr<const protocol::WireMesh> state_;
    std::deque<std::chrono::steady_clock::time_point> since_;
    std::size_t bytes_ = 0;
    std::uint64_t frames_ = 0;  ///< of all updates ever added
    std::size_t key_bytes_ = 0; ///< of the epoch's newest key
    SharedUpdate key_;          ///< of one of updates_, made on request
    std::chrono::steady_clock::time_point key_since_;
    std::vector<std::weak_ptr<Listener>> listeners_;
};

} // namespace wakesurf::server
