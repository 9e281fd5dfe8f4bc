// One WebSocket: text is JSON-RPC, binary is frames and goes one way only. Writes what the outbox holds, one message
// at a time, so a slow client delays nobody else.
#pragma once

#include "server/net/http_connection.hpp"
#include "server/net/http_message.hpp"

#include <boost/asio/ip/tcp.hpp>

namespace wakesurf::server {

/// Answers the upgrade request, already let in as `identity`, and serves the socket until it closes.
void serve_websocket(boost::asio::ip::tcp::socket socket,
                     const HttpRequest& upgrade,
                     const Identity& identity,
                     NetServices services);

} // namespace wakesurf::server
