// The updates of a surface's newest epoch, encoded once for all viewers: each subscription reads on from its
// own position. Bounded in bytes and age; a subscription that falls behind gets a keyframe of the newest
// state, made once for all that need one at that time.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/surface/surface_statistics.hpp"
#include "protocol/wire/mesh_stream.hpp"
#include "server/live/surface_events.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

class Metrics;

using protocol::Phase;

/// Holds a state of a surface, and the frames that lead to it. Immutable once published.
struct Update {
    protocol::EncodedUpdate wire;
    core::SurfaceStatistics statistics;
    double time = 0.0;    ///< simulation time shown
    std::string shape{};  ///< shape_mark of a final state
    double seconds = 0.0; ///< to build and encode
    PassSeconds took;
    ValueRanges ranges;
    /// The error between stored times can be estimated, or the twin compared, and is not yet.
    bool checks_due = false;
    /// Counts the frames as long as they are in use.
    std::shared_ptr<core::MemoryAccount::Share> memory{};
};

using SharedUpdate = std::shared_ptr<const Update>;

/// Counts what a pass took. @param whole  its statistics are of this pass alone, not of all since the release of
/// the surface
void count(Metrics& metrics,
           std::chrono::duration<double> queued,
           const core::Result<Update>& result,
           bool whole);

/// Returns the share of an update's frames. @param account  null: not counted
std::shared_ptr<core::MemoryAccount::Share> counted(const core::MemoryAccount* account,
                                                    std::size_t bytes);

/// Holds the updates. Loop thread only. Owned by shared_ptr: by its surface and by its readers.
class UpdateRing {
  public:
    UpdateRing(std::uint32_t number, const core::Clock& clock, std::function<void()> want_key);
    UpdateRing(const UpdateRing&) = delete;
    UpdateRing& operator=(const UpdateRing&) = delete;

    /// Returns the surface's number on the wire.
    std::uint32_t number() const { return number_; }

    std::uint32_t epoch() const { return epoch_; }

    bool closed() const { return closed_; }

    /// Forgets every update and begins an epoch.
    void begin(std::uint32_t epoch);

    /// Adds the next update, based on the newest or a key. Updates of another epoch are ignored.
    /// @param state  the state that it leads to: a key can be made of it; required unless the update is one
    void add(SharedUpdate update, std::shared_ptr<const protocol::WireMesh> state = nullptr);

    /// Adds the key that want_key asked for; null: it could not be made, ask again.
    void add_key(SharedUpdate key);

    /// Drops updates beyond the bounds on age and bytes; the newest stays.
    void trim();

    /// Drops all but the newest: readers behind it get a key.
    void keep_newest();

    /// Ends the ring: readers have nothing to read.
    void close();

    /// Returns the newest update; null before the epoch's first.
    SharedUpdate newest() const { return updates_.empty() ? nullptr : updates_.back(); }

    /// Returns the newest state; null if its update is a key itself.
    const std::shared_ptr<const protocol::WireMesh>& state() const { return state_; }

    /// Says whether there are readers, or may be at any moment.
    bool read() const;

    /// Returns the oldest update if it is a key: new readers of the epoch begin there.
    SharedUpdate first() const;

    /// Returns the update to read after the state `seq`: the newest key after it, else the update based on
    /// it. Null: not held.
    SharedUpdate after(std::uint32_t seq) const;

    /// Says whether a reader with the state `seq` is better served by a keyframe than by all later updates.
    bool far_behind(std::uint32_t seq) const;

    /// Returns a key close to the newest state, for a reader with the state `after_seq` or none. Null: one is
    /// requested (once), and the listeners are notified.
    SharedUpdate key(std::optional<std::uint32_t> after_seq);

    /// Calls `notify` whenever there is something new to read, until the ticket is dropped. `notify` must not
    /// change the ring.
    [[nodiscard]] std::shared_ptr<void> listen(std::function<void()> notify);

    std::size_t bytes() const { return bytes_; }

    /// Says whether this is one of the consecutive updates, and not a key made of one on request.
    bool holds(const SharedUpdate& update) const;

    /// Returns the number of frames, of all epochs, before the update `seq` of this one: the difference of
    /// two is what lies between them.
    std::uint64_t frames_before(std::uint32_t seq) const;

  private:
    using Listener = std::function<void()>;

    void notify();

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

/// Encodes the state of a surface as one keyframe, on a compute thread, for clients that have none of it. Null where there is no memory for it within 100 ms, and it has to be asked
/// for again. Thread-safe. Cost: of encoding all vertices.
/// @param state  the state that the update leads to
/// @param number  the surface's on the wire
/// @param account  null: memory is not counted
SharedUpdate keyframe_of(const Update& update,
                         std::shared_ptr<const protocol::WireMesh> state,
                         std::uint32_t number,
                         const core::MemoryAccount* account);

} // namespace wakesurf::server
