// Maps paths to handlers, once a connection has read a request: the gate first, then static files, JSON-RPC,
// login and the downloads.
#pragma once

#include "server/live/compute/budgets.hpp"
#include "server/net/downloads.hpp"
#include "server/net/gate.hpp"
#include "server/net/http_message.hpp"
#include "server/net/methods/dispatcher.hpp"
#include "server/net/outbox.hpp"
#include "server/net/session_files.hpp"
#include "server/net/static_files.hpp"

#include <tl/expected.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Holds the visitor and the permit of an admitted WebSocket.
struct Admitted {
    Visitor visitor;
    Budgets::Permit permit;
};

/// Routes requests. Loop thread only. REQUIRES: everything it refers to outlives it.
class Routes {
  public:
    /// @param metrics     returns the text of /metrics
    /// @param health      returns the text of /healthz, which every client may read
    /// @param logged_out  closes the sockets of a person whose login has ended
    Routes(Gate& gate,
           Budgets& budgets,
           OutboxMemory& outboxes,
           const StaticFiles& files,
           Dispatcher& dispatcher,
           Downloads& downloads,
           SessionFiles& session_files,
           std::function<std::string()> metrics,
           std::function<std::string()> health,
           std::function<void(const std::string&)> logged_out)
        : gate_(gate), budgets_(budgets), outboxes_(outboxes), files_(files),
          dispatcher_(dispatcher), downloads_(downloads), session_files_(session_files),
          metrics_(std::move(metrics)), health_(std::move(health)),
          logged_out_(std::move(logged_out)) {}

    /// Returns the limit for a request's body, by its header: longer than messages only for authenticated
    /// hosts.
    std::size_t longest_body(const HttpRequest& header);

    /// Admits an upgrade to a WebSocket, or returns why not.
    tl::expected<Admitted, HttpResponse> admit_upgrade(const HttpRequest& request);

    /// Handles a request. @param let_in  called, before this returns, if the request has shown a token
    void handle(const HttpRequest& request, const std::function<void()>& let_in, Respond respond);

    Dispatcher& dispatcher() const { return dispatcher_; }

  private:
    core::Result<std::shared_ptr<void>> permits_for(const HttpRequest& request,
                                                    const Visitor& visitor);
    std::optional<HttpResponse> answer_open(const HttpRequest& request);
    HttpResponse counted_open(const HttpRequest& request, HttpResponse answer);
    void serve(const HttpRequest& request, const Visitor& visitor, Respond respond);
    void call(const HttpRequest& request, const Visitor& visitor, Respond respond);
    HttpResponse login(const HttpRequest& request);
    void logout(const HttpRequest& request, Respond respond);

    Gate& gate_;
    Budgets& budgets_;
    OutboxMemory& outboxes_;
    const StaticFiles& files_;
    Dispatcher& dispatcher_;
    Downloads& downloads_;
    SessionFiles& session_files_;
    std::function<std::string()> metrics_;
    std::function<std::string()> health_;
    std::function<void(const std::string&)> logged_out_;
};

} // namespace wakesurf::server
