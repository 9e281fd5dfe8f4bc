// What an answer of a web server is worth (server/service/web/http_transport.hpp): is it what was asked for, or a page about something else? Errors name
// the address.
#pragma once

#include "core/base/result.hpp"
#include "server/service/web/http_transport.hpp"

#include <cstdint>
#include <string>

namespace wakesurf::server {

/// The server says that it may go better in a moment, or the connection ended before all had come.
bool comes_again(const HttpAnswer& answer);

/// Error: NotFound; Corrupt for another object than was asked for, and for a web page; Io for all else.
/// @param times  ", 5 times" where it was asked again
core::Result<void>
check_status(const HttpRequest& request, const HttpAnswer& answer, const std::string& times);

/// Of the whole object, as the answer to the question what it is or for its beginning tells. Error: Io, Corrupt.
core::Result<std::uint64_t> size_told(const HttpRequest& request, const HttpAnswer& answer);

/// It is the part that was asked for, of an object of that size. Error: Io, Corrupt.
core::Result<void>
check_part(const HttpRequest& request, const HttpAnswer& answer, std::uint64_t size);

/// Another object has taken the place of the one that was looked at.
tl::unexpected<core::Error> changed(const std::string& address);

} // namespace wakesurf::server
