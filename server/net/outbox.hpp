// What waits to be sent to one client. Messages are never dropped: too many of them end the connection. Frames can
// be made again: of each surface only the newest state waits, and a state that is out of date goes as a whole. States
// are shared with their surface, so a slow client costs no memory of its own.
#pragma once

#include "server/session/surface_job.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace wakesurf::server {

class Outbox {
  public:
    using Frame = std::shared_ptr<const std::vector<std::byte>>;
    using Item = std::variant<std::string, Frame>;

    /// False when the client is too slow for its messages: close it.
    [[nodiscard]] bool push(std::string message);

    /// Replaces what waits of the same surface.
    void push(std::uint32_t surface, std::shared_ptr<const SurfaceState> state);

    /// Drops what waits of `surface` from epochs before `epoch`.
    void drop_frames(std::uint32_t surface, std::uint32_t epoch);

    /// The next thing to send: messages before frames, so that no answer waits for a large mesh.
    std::optional<Item> pop();

    bool empty() const { return messages_.empty() && states_.empty(); }

  private:
    struct Pending {
        std::uint32_t surface;
        std::shared_ptr<const SurfaceState> state;
        std::size_t next = 0; ///< frame
    };

    std::deque<std::string> messages_;
    std::size_t message_bytes_ = 0;
    std::deque<Pending> states_;
};

} // namespace wakesurf::server
