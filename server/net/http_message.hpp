// HTTP requests and responses as plain values, so that only the connection knows Beast, and the security headers of every response.
#pragma once

#include <chrono>
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

} // namespace wakesurf::server
