// HTTP requests and responses as plain values, so that only the connection knows Beast.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::server {

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
