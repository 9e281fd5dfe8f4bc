// One accepted connection: TLS if the server speaks it, then HTTP requests, one after the other, until it
// closes or becomes a WebSocket.
#pragma once

#include "server/net/net_services.hpp"

#include <boost/asio/ip/tcp.hpp>

namespace wakesurf::server {

/// Serves the socket until it closes; keeps itself alive meanwhile. Closes it at once without a permit.
void serve_http(boost::asio::ip::tcp::socket socket, NetServices services);

} // namespace wakesurf::server
