// $/progress for one call that takes its time and came with a `workDoneToken`: begin, now and then a report,
// end. A measure at the work ten times a second, not an event for each change, so that no work can flood its
// caller.
#pragma once

#include "server/base/loop.hpp"
#include "server/net/methods/method.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Returns the token that was given, as JSON text. None of a call that nothing stops when its caller goes:
/// over HTTP, or a notification.
std::optional<std::string> work_token(const Call& call, const std::optional<std::string>& given);

/// Reports for one call. Loop thread only. Ends with the answer: destroy it just before. Says nothing once
/// its call was cancelled, and never touches a client that has gone, because a client stops its calls first.
class WorkProgress {
  public:
    /// Returns what the work would report now, or nothing new. Members of `value` beside `kind`.
    using Measure = std::function<nlohmann::json()>;

    /// Tells `begin` at once. REQUIRES: call.client, and a token that work_token returned.
    WorkProgress(const Call& call, std::string token, std::string title, Measure measure);
    /// Tells `end`.
    ~WorkProgress();
    WorkProgress(const WorkProgress&) = delete;
    WorkProgress& operator=(const WorkProgress&) = delete;

  private:
    void tell(nlohmann::json value);
    void arm();
    void report();

    Client& client_;
    Loop& loop_;
    std::stop_token stop_;
    std::string token_;
    Measure measure_;
    std::string sent_; ///< as text: the newest report
    std::shared_ptr<void> timer_;
};

} // namespace wakesurf::server
