// Tells which participant drags which rake. A lease is soft: it ends by itself a few seconds after the last
// edit of its holder, so that no participant waits for a client that is gone.
#pragma once

#include "server/base/session_services.hpp"
#include "server/sessions/records/author.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

struct Lease {
    Author by;
    std::chrono::milliseconds left{}; ///< until it ends by itself
};

/// Loop thread only.
class Leases {
  public:
    /// `expired` is told of a lease that has just ended by itself.
    Leases(const SessionServices& services, std::function<void(const std::string& rake)> expired);

    /// Takes, renews or takes over. Returns the number of the drag, which stays while the lease is only
    /// renewed.
    std::uint64_t take(const std::string& rake, const Author& author);

    void end(const std::string& rake) { held_.erase(rake); }

    std::optional<Lease> find(const std::string& rake) const;

    /// Returns the number of the drag, if this author holds the rake; else 0.
    std::uint64_t drag(const std::string& rake, const Author& author) const;

    /// Lists the rakes that a participant holds.
    std::vector<std::string> of(const std::string& participant) const;

  private:
    struct Held {
        Author by;
        std::uint64_t drag = 0;
        std::chrono::steady_clock::time_point until;
        std::shared_ptr<void> timer;
    };

    SessionServices services_;
    std::function<void(const std::string&)> expired_;
    std::map<std::string, Held> held_;
    std::uint64_t drags_ = 0;
};

} // namespace wakesurf::server
