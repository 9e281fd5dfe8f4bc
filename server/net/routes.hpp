// Which path does what, once a connection has read a request: the gate first, then static files, JSON-RPC, login and
// the downloads.
#pragma once

#include "server/net/downloads.hpp"
#include "server/net/gate.hpp"
#include "server/net/http_message.hpp"
#include "server/net/static_files.hpp"
#include "server/rpc/dispatcher.hpp"

#include <optional>

namespace wakesurf::server {

/// Loop thread only. Everything it refers to outlives it.
class Routes {
  public:
    Routes(Gate& gate, const StaticFiles& files, const Dispatcher& dispatcher, Downloads& downloads)
        : gate_(gate), files_(files), dispatcher_(dispatcher), downloads_(downloads) {}

    /// Nothing: the request may become a WebSocket.
    std::optional<HttpResponse> refuse_upgrade(const HttpRequest& request);

    void handle(const HttpRequest& request, Respond respond);

    const Dispatcher& dispatcher() const { return dispatcher_; }

  private:
    void post(const HttpRequest& request, Respond respond);
    HttpResponse login(const HttpRequest& request);

    Gate& gate_;
    const StaticFiles& files_;
    const Dispatcher& dispatcher_;
    Downloads& downloads_;
};

} // namespace wakesurf::server
