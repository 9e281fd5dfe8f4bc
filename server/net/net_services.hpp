// The parts of the server that connections, of HTTP and WebSockets, use.
#pragma once

#include "server/base/metrics.hpp"
#include "server/live/compute/budgets.hpp"
#include "server/net/admission.hpp"
#include "server/net/connections.hpp"
#include "server/net/outbox_memory.hpp"
#include "server/net/routes.hpp"
#include "server/net/security_headers.hpp"
#include "server/net/tls_context.hpp"
#include "server/net/trusted_proxies.hpp"
#include "server/net/write_turns.hpp"

namespace wakesurf::server {

/// Refers to parts of the server, which outlive all connections.
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
    /// Added to every answer.
    const SecurityHeaders& headers;
    /// Null without TLS.
    TlsContext* tls;
};

} // namespace wakesurf::server
