// The relevant header lines of an answer (server/remote/web/http_transport.hpp). The server is not trusted:
// they may hold anything.
#pragma once

#include "server/remote/web/http_transport.hpp"

#include <string_view>

namespace wakesurf::server {

/// Reads one line. A status line begins the answer anew: there is one for each intermediate answer.
void read_header(std::string_view line, HttpAnswer& answer);

} // namespace wakesurf::server
