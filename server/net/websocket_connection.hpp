// One WebSocket: text is JSON-RPC, binary is frames and goes one way only. It writes from the outbox, one
// batch at a time, so that a slow client delays no other.
#pragma once

#include "server/net/byte_stream.hpp"
#include "server/net/http_message.hpp"
#include "server/net/net_services.hpp"

#include <memory>

namespace wakesurf::server {

/// Answers the upgrade request, already admitted, and serves the stream until it closes.
void serve_websocket(std::shared_ptr<ByteStream> stream,
                     const HttpRequest& upgrade,
                     const Admitted& admitted,
                     NetServices services,
                     std::unique_ptr<Admission::Permit> permit);

} // namespace wakesurf::server
