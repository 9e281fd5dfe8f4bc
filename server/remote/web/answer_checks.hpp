// Checks of a web server's answer (server/remote/web/http_transport.hpp): is it the object that was asked
// for, or a page about something else? Errors name the address.
#pragma once

#include "core/base/result.hpp"
#include "server/remote/web/http_transport.hpp"

#include <cstdint>
#include <string>

namespace wakesurf::server {

/// Says that a retry may succeed: the server says so, or the connection ended early.
bool comes_again(const HttpAnswer& answer);

/// Checks the status. Error: NotFound; Corrupt for another object than was asked for, and for a web page; Io
/// for all else.
/// @param times  ", 5 times" after retries
core::Result<void>
check_status(const HttpRequest& request, const HttpAnswer& answer, const std::string& times);

/// Returns the size of the whole object, from the answer to a HEAD or for its beginning. Error: Io, Corrupt.
core::Result<std::uint64_t> size_told(const HttpRequest& request, const HttpAnswer& answer);

/// Checks that the answer has the part asked for, of an object of that size. Error: Io, Corrupt.
core::Result<void>
check_part(const HttpRequest& request, const HttpAnswer& answer, std::uint64_t size);

/// Returns the error for an object that has been replaced by another one.
tl::unexpected<core::Error> changed(const std::string& address);

} // namespace wakesurf::server
