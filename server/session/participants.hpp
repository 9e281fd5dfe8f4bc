// Who is in a session. A lost connection comes back with its resume token and keeps its place.
#pragma once

#include "core/base/result.hpp"
#include "server/session/entropy.hpp"
#include "server/session/observer.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace wakesurf::server {

struct Participant {
    std::string id;
    std::string name;
    std::string resume_token;
    Observer* observer = nullptr;
};

/// Loop thread only. Observers leave before they end.
class Participants {
  public:
    explicit Participants(Entropy& entropy) : entropy_(entropy) {}

    /// With the token of an earlier stay the participant gets that place again; a connection that still holds it is
    /// no longer told anything. Error: OverLimit.
    core::Result<Participant>
    join(std::string name, const std::string& resume_token, Observer& observer);

    void leave(const Observer& observer);

    const std::vector<Participant>& present() const { return present_; }

  private:
    Participant place_for(const std::string& resume_token);

    Entropy& entropy_;
    std::vector<Participant> present_;
    std::deque<Participant> gone_; ///< newest last
    std::size_t next_ = 1;
};

} // namespace wakesurf::server
