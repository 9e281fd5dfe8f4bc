// HTTP requests and responses as plain values, so that only the connection knows Beast; the responses that many
// paths share, and the security headers of every one.
#pragma once

#include "core/base/result.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// The security headers of every response: errors and the 101 of a WebSocket included.
class SecurityHeaders {
  public:
    /// @param frame_origins  origins whose pages may show ours in a frame; empty: no page may
    explicit SecurityHeaders(const std::vector<std::string>& frame_origins = {});

    std::span<const std::pair<std::string_view, std::string>> all() const { return headers_; }

  private:
    std::vector<std::pair<std::string_view, std::string>> headers_;
};

/// The value of Strict-Transport-Security, sent over TLS under a name other than this machine's own: browsers
/// apply it to every port of a host, and other servers of localhost speak plain HTTP.
inline constexpr std::string_view transport_security = "max-age=86400";

struct HttpRequest {
    std::string method;
    std::string path;                                         ///< as received, without the query
    std::string query;                                        ///< the part behind its `?`
    std::vector<std::pair<std::string, std::string>> headers; ///< names in lower case
    std::string body;
    bool upgrade = false; ///< to a WebSocket
    /// Fires on the loop's thread when the client no longer waits for the answer.
    std::stop_token gone;
    std::string from; ///< the client's address group: see admission

    /// Returns the values of a header, in order.
    std::vector<std::string_view> all(std::string_view name) const {
        std::vector<std::string_view> out;
        for (const auto& [key, value] : headers)
            if (key == name)
                out.push_back(value);
        return out;
    }

    /// Returns the first value of a header, or empty.
    std::string_view header(std::string_view name) const {
        const auto values = all(name);
        return values.empty() ? std::string_view{} : values.front();
    }

    /// Returns the elements of a header that is a list; several such headers are one list.
    std::vector<std::string_view> list(std::string_view name) const;

    /// Says whether If-None-Match names this tag; weak ones count (RFC 9110, 13.1.2).
    bool has(std::string_view tag) const;
};

struct HttpResponse {
    unsigned status = 200;
    std::vector<std::pair<std::string, std::string>> headers;
    std::shared_ptr<const std::string> body = std::make_shared<const std::string>();
    std::shared_ptr<void> held = {};      ///< until it has been written
    std::chrono::milliseconds pause = {}; ///< before the connection is read from again
};

/// Takes the one response, now or later, on the loop's thread.
using Respond = std::function<void(HttpResponse)>;

/// Returns a text that is not stored.
HttpResponse
http_text(unsigned status, std::string text, const char* type = "text/plain; charset=utf-8");

HttpResponse http_json(std::string text);

/// Errors are JSON-RPC error objects, so that scripts read one shape everywhere.
HttpResponse http_error(unsigned status, std::string message, std::string hint);
HttpResponse http_error(const core::Error& error);

/// Returns an error of an exceeded limit: code -32014, for any status.
HttpResponse
http_over_limit(unsigned status, std::uint64_t limit, std::string message, std::string hint);

/// Returns an error 429.
HttpResponse
http_too_fast(std::string message, std::string hint, std::chrono::nanoseconds retry_after);

} // namespace wakesurf::server
