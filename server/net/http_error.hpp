// Errors of the HTTP side: a JSON-RPC error object, so that scripts read one shape everywhere.
#pragma once

#include "core/base/result.hpp"
#include "server/net/gate.hpp"
#include "server/net/http_message.hpp"

#include <cstdint>
#include <string>

namespace wakesurf::server {

HttpResponse http_error(unsigned status, std::string message, std::string hint);
HttpResponse http_error(const core::Error& error);
/// Returns an error of an exceeded limit: code -32014, for any status.
HttpResponse
http_over_limit(unsigned status, std::uint64_t limit, std::string message, std::string hint);
HttpResponse http_error(const Refusal& refusal);

HttpResponse http_json(std::string text);

} // namespace wakesurf::server
