// A connection between a client and the server: two directions, each in order, each with delays of its own;
// it can be cut at any moment, which loses messages on their way.
#pragma once

#include "tests/simulation/world.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace wakesurf::simulation {

/// Text, or a frame.
using Message = std::variant<std::string, std::vector<std::byte>>;

class Link : public std::enable_shared_from_this<Link> {
  public:
    enum End : std::size_t { Client = 0, Server = 1 };

    /// @param slowest  the longest delay of a message
    Link(World& world, Duration slowest) : world_(world), slowest_(slowest) {}

    /// Sets the callbacks of an end, for messages and for the end of the link.
    void attach(End end, std::function<void(Message)> receive, std::function<void()> gone) {
        ends_[end].receive = std::move(receive);
        ends_[end].gone = std::move(gone);
    }

    /// `sent` is called once the message has left the sender: a full line takes longer.
    void send(
        End to, Message message, std::function<void()> sent = [] {}) {
        Side& side = ends_[to];
        side.until =
            std::max(side.until, world_.now() + world_.time_between(Duration(50), slowest_));
        const auto delay = std::chrono::duration_cast<Duration>(side.until - world_.now());
        world_.after(delay / 2, [self = shared_from_this(), sent = std::move(sent)] {
            if (self->open_)
                sent();
        });
        world_.after(delay,
                     [self = shared_from_this(), to, message = std::move(message)]() mutable {
                         if (self->open_)
                             self->ends_[to].receive(std::move(message));
                     });
    }

    /// Cuts the link; both ends learn of it, each after its delay.
    void cut() {
        if (!std::exchange(open_, false))
            return;
        for (Side& side : ends_)
            world_.after(world_.time_between(Duration(0), slowest_),
                         [self = shared_from_this(), gone = side.gone] { gone(); });
    }

    /// Cuts the link without notifying the server, which has crashed.
    void crash() {
        if (!std::exchange(open_, false))
            return;
        world_.after(world_.time_between(Duration(0), slowest_), ends_[Client].gone);
    }

    bool open() const { return open_; }

  private:
    struct Side {
        std::function<void(Message)> receive = [](Message) {};
        std::function<void()> gone = [] {};
        Instant until{};
    };

    World& world_;
    Duration slowest_;
    std::array<Side, 2> ends_;
    bool open_ = true;
};

} // namespace wakesurf::simulation
