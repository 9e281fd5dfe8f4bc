// Gathers what changed about the participants of a session until it is told. The newest is told at most
// every 50 ms; where many would have to be told of many, of some at a time and less often, so that presence
// never crowds out the meshes.
#pragma once

#include "server/base/loop.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Loop thread only. The loop outlives it.
class PresenceEvents {
  public:
    struct Batch {
        std::map<std::string, unsigned> changed; ///< participant -> members (protocol::member)
        std::vector<std::string> left;
    };

    /// Tells a batch; returns how many bytes that took over all clients.
    using Tell = std::function<std::size_t(const Batch&)>;

    /// Returns how many participants may be told at a time; at least 1.
    using Room = std::function<std::size_t()>;

    PresenceEvents(Loop& loop, Room room, Tell tell)
        : loop_(loop), room_(std::move(room)), tell_(std::move(tell)) {}

    void changed(const std::string& participant, unsigned members);
    void left(const std::string& participant);

  private:
    Batch next_batch();
    void flush();

    Loop& loop_;
    Room room_;
    Tell tell_;
    Batch waiting_;
    std::string last_;           ///< told of last: the one after it is next
    std::shared_ptr<void> rest_; ///< runs since the last telling
};

} // namespace wakesurf::server
