// What waits to be sent to one client. Messages are never dropped: too many of them end the connection. Frames wait at their
// surfaces: here are only the places up to which this client has them.
#pragma once

#include "server/net/outbox_memory.hpp"
#include "server/service/live/frame_cursor.hpp"

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

/// Loop thread only.
class Outbox {
  public:
    using Frame = FrameCursor::Frame;
    /// The same text may wait for many.
    using Message = std::shared_ptr<const std::string>;
    using Item = std::variant<Message, Frame>;

    /// @param all  what waits for all clients; null: each is for itself
    explicit Outbox(OutboxMemory* all = nullptr) : memory_(all) {}

    /// False when the client is too slow for its messages: close it.
    [[nodiscard]] bool push(Message message);

    [[nodiscard]] bool push(std::string message) {
        return push(std::make_shared<const std::string>(std::move(message)));
    }

    bool may_follow(std::uint32_t surface);

    /// Replaces the cursor of the same surface, if there is one. REQUIRES: may_follow.
    void follow(FrameCursor cursor);

    /// False when there was none.
    bool unfollow(std::uint32_t surface);

    /// Null when there is none.
    FrameCursor* cursor(std::uint32_t surface);

    /// The next thing to send: messages before frames, so that no answer waits for a large mesh; surfaces take turns.
    /// The cursors' notices may push messages meanwhile.
    std::optional<Item> pop();

    /// All that was popped has been written.
    void sent();

  private:
    std::optional<Item> pop_message();
    Frame pop_frame();

    struct Waiting {
        Message message;
        std::size_t share; ///< of its bytes: a text that waits for many is there once
    };

    std::deque<Waiting> messages_;
    std::size_t message_bytes_ = 0;
    OutboxMemory::Share memory_;
    std::size_t popped_ = 0;                       ///< bytes of memory_ that are being written
    std::map<std::uint32_t, FrameCursor> cursors_; ///< by surface
    std::uint32_t last_ = 0;                       ///< surface that had the last turn
};

} // namespace wakesurf::server
