// One accepted connection: TLS if the server speaks it, then HTTP requests, one after the other, until it closes or
// becomes a WebSocket.
#pragma once

#include "server/net/admission.hpp"
#include "server/net/connections.hpp"
#include "server/net/outbox_memory.hpp"
#include "server/net/routes.hpp"
#include "server/net/security_headers.hpp"
#include "server/net/tls_context.hpp"
#include "server/net/trusted_proxies.hpp"
#include "server/net/write_turns.hpp"
#include "server/service/compute/budgets.hpp"
#include "server/service/metrics/metrics.hpp"

#include <boost/asio/ip/tcp.hpp>

namespace wakesurf::server {

/// What connections need of the server. All outlive them.
struct NetServices {
    Routes& routes;
    Connections& connections;
    Grants& grants;
    Admission& admission;
    Budgets& budgets;
    const TrustedProxies& proxies;
    Metrics& metrics;
    OutboxMemory& outboxes;
    WriteTurns& turns;
    const SecurityHeaders& headers; ///< of every answer
    TlsContext* tls;                ///< nothing: plain TCP
};

/// Serves the socket until it closes; keeps itself alive meanwhile. Closes it at once where there is no room.
void serve_http(boost::asio::ip::tcp::socket socket, NetServices services);

} // namespace wakesurf::server
