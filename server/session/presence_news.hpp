// What changed about the participants of a session, gathered until it is told. The newest of everything is told at most every
// 50 ms, less often where many would have to be told of many, so that presence never crowds out the meshes.
#pragma once

#include "server/session/loop.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Loop thread only. The loop outlives it.
class PresenceNews {
  public:
    struct Batch {
        std::map<std::string, unsigned> changed; ///< participant -> members (protocol::member)
        std::vector<std::string> left;
    };

    /// Tells a batch; gives how many bytes that took over all who were told.
    using Tell = std::function<std::size_t(const Batch&)>;

    PresenceNews(Loop& loop, Tell tell) : loop_(loop), tell_(std::move(tell)) {}

    void changed(const std::string& participant, unsigned members);
    void left(const std::string& participant);

  private:
    void flush();

    Loop& loop_;
    Tell tell_;
    Batch batch_;
    std::shared_ptr<void> rest_; ///< runs since the last telling
};

} // namespace wakesurf::server
