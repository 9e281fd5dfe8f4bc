// One accepted TCP connection: HTTP requests, one after the other, until it closes or becomes a WebSocket.
#pragma once

#include "server/net/connections.hpp"
#include "server/net/routes.hpp"

#include <boost/asio/ip/tcp.hpp>

namespace wakesurf::server {

/// What connections need of the server. All outlive them.
struct NetServices {
    Routes& routes;
    Connections& connections;
    Grants& grants;
    std::size_t& clients; ///< WebSockets open
};

/// Serves the socket until it closes; keeps itself alive meanwhile.
void serve_http(boost::asio::ip::tcp::socket socket, NetServices services);

} // namespace wakesurf::server
