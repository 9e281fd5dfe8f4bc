// The queue of one client. Messages are never dropped: too many of them end the connection. Frames stay at
// their surfaces: the queue holds only cursors into those.
#pragma once

#include "core/base/memory_account.hpp"
#include "server/live/frame_cursor.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace wakesurf::server {

/// The bound on what waits to be sent to all clients together: a sixteenth of `--memory`. Each client may have
/// a quarter of the remaining memory waiting, so that clients that do not read, with any number of sockets,
/// never exhaust it. A minimum is always available to each.
/// Bounds the memory of all outboxes. Loop thread only. REQUIRES: it outlives its shares.
class OutboxMemory {
  public:
    explicit OutboxMemory(const core::MemoryAccount& account);
    OutboxMemory(const OutboxMemory&) = delete;
    OutboxMemory& operator=(const OutboxMemory&) = delete;

    /// Counts what one client, or one answer, has waiting.
    class Share {
      public:
        /// @param all  null: no bound
        explicit Share(OutboxMemory* all = nullptr) : all_(all) {}

        ~Share() { shrink(bytes_); }

        Share(const Share&) = delete;
        Share& operator=(const Share&) = delete;

        /// Returns false, and changes nothing, if it does not fit.
        [[nodiscard]] bool grow(std::size_t more);
        void shrink(std::size_t less);

      private:
        OutboxMemory* all_;
        std::size_t bytes_ = 0;
    };

    /// Counts one answer until it has been sent; null if it does not fit.
    std::shared_ptr<void> hold(std::size_t bytes);

    /// Returns the sum of all shares, in bytes.
    std::size_t bytes() const { return bytes_; }

  private:
    bool fits(std::size_t own, std::size_t more) const;
    void changed();

    std::size_t most_;
    std::size_t bytes_ = 0;
    core::MemoryAccount::Share counted_; ///< follows bytes_ in steps
};

/// Queues messages and cursors. Loop thread only.
class Outbox {
  public:
    using Frame = FrameCursor::Frame;
    /// A text that several clients may share.
    using Message = std::shared_ptr<const std::string>;
    using Item = std::variant<Message, Frame>;

    /// @param all  the bound for all clients; null: none
    explicit Outbox(OutboxMemory* all = nullptr) : memory_(all) {}

    /// Queues a message. Returns false if the client is too slow for its messages: close it.
    [[nodiscard]] bool push(Message message);

    [[nodiscard]] bool push(std::string message) {
        return push(std::make_shared<const std::string>(std::move(message)));
    }

    bool may_follow(std::uint32_t surface);

    /// Adds a cursor, or replaces the one of the same surface. REQUIRES: may_follow.
    void follow(FrameCursor cursor);

    /// Removes a cursor. Returns false without one.
    bool unfollow(std::uint32_t surface);

    /// Returns the cursor of a surface; null without one.
    FrameCursor* cursor(std::uint32_t surface);

    /// Returns the next item: messages before frames, so that no answer waits for a large mesh; surfaces
    /// alternate. The cursors' notices may push messages meanwhile.
    /// @param frames  false: messages only
    std::optional<Item> pop(bool frames = true);

    /// Marks all popped items as written.
    void sent();

  private:
    std::optional<Item> pop_message();
    Frame pop_frame();

    struct Waiting {
        Message message;
        std::size_t share; ///< in bytes: a text that several clients share counts once
    };

    std::deque<Waiting> messages_;
    std::size_t message_bytes_ = 0;
    OutboxMemory::Share memory_;
    std::size_t popped_ = 0;                       ///< bytes of memory_ that are being written
    std::map<std::uint32_t, FrameCursor> cursors_; ///< by surface
    std::uint32_t last_ = 0;                       ///< surface of the last frame
};

} // namespace wakesurf::server
