// Which path does what, once a connection has read a request: the gate first, then static files, JSON-RPC, login and
// the downloads.
#pragma once

#include "server/net/downloads.hpp"
#include "server/net/gate.hpp"
#include "server/net/http_message.hpp"
#include "server/net/session_files.hpp"
#include "server/net/static_files.hpp"
#include "server/rpc/dispatcher.hpp"

#include <tl/expected.hpp>

#include <cstddef>
#include <functional>
#include <string>

namespace wakesurf::server {

/// Loop thread only. Everything it refers to outlives it.
class Routes {
  public:
    /// @param metrics  gives the text of /metrics
    Routes(Gate& gate,
           const StaticFiles& files,
           Dispatcher& dispatcher,
           Downloads& downloads,
           SessionFiles& session_files,
           std::function<std::string()> metrics)
        : gate_(gate), files_(files), dispatcher_(dispatcher), downloads_(downloads),
          session_files_(session_files), metrics_(std::move(metrics)) {}

    /// How long the body of a request may be, by its header: longer than messages only for what is known to be let in.
    std::size_t longest_body(const HttpRequest& header);

    /// Whose WebSocket the request may become, or why it may not.
    tl::expected<Identity, HttpResponse> admit_upgrade(const HttpRequest& request);

    void handle(const HttpRequest& request, Respond respond);

    Dispatcher& dispatcher() const { return dispatcher_; }

  private:
    void serve(const HttpRequest& request, const Identity& identity, Respond respond);
    void call(const HttpRequest& request, const Identity& identity, Respond respond);
    HttpResponse login(const HttpRequest& request);

    Gate& gate_;
    const StaticFiles& files_;
    Dispatcher& dispatcher_;
    Downloads& downloads_;
    SessionFiles& session_files_;
    std::function<std::string()> metrics_;
};

} // namespace wakesurf::server
