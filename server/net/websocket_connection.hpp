// One WebSocket: text is JSON-RPC, binary is frames and goes one way only. Writes what the outbox holds, one message
// at a time, so a slow client delays no one else.
#pragma once

#include "server/net/byte_stream.hpp"
#include "server/net/http_message.hpp"
#include "server/net/net_services.hpp"

#include <memory>

namespace wakesurf::server {

/// Answers the upgrade request, already let in, and serves the stream until it closes.
void serve_websocket(ByteStream stream,
                     const HttpRequest& upgrade,
                     const Admitted& admitted,
                     NetServices services,
                     std::unique_ptr<Admission::Place> place);

} // namespace wakesurf::server
