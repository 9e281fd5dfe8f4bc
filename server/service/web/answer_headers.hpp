// The header lines of an answer that count (server/service/web/http_transport.hpp). What a stranger's server sends, so anything may stand there.
#pragma once

#include "server/service/web/http_transport.hpp"

#include <string_view>

namespace wakesurf::server {

/// Takes one line. A status line begins the answer anew: there is one for each intermediate answer.
void read_header(std::string_view line, HttpAnswer& answer);

} // namespace wakesurf::server
