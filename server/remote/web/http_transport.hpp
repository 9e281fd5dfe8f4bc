// One request to a web server and its answer. server/remote/web/web_disk.hpp decides on requests, retries
// and checks; server/remote/web/curl_transport.hpp is the real transport.
#pragma once

#include <tl/expected.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

namespace wakesurf::server {

/// Names `count` bytes of an object.
struct HttpRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

struct HttpRequest {
    std::string address;
    bool head = false;                ///< its headers, without its bytes
    std::optional<HttpRange> range{}; ///< empty: all
    std::string if_match{};           ///< the ETag that it must have; empty: any
};

struct HttpAnswer {
    /// Holds Content-Range: `first`-`last` of `total`; without bytes if there are none.
    struct Range {
        std::optional<std::uint64_t> first, last;
        std::uint64_t total = 0;
    };

    int status = 0;
    std::string etag;
    std::string last_modified;
    std::string content_type;
    std::string location; ///< of a redirect
    std::optional<std::uint64_t> content_length;
    std::optional<Range> range;
    std::optional<std::chrono::seconds> retry_after;
    std::size_t bytes = 0; ///< of the body, as far as they fit
    bool longer = false;   ///< the body was longer
};

/// Says why there is no answer.
struct HttpFault {
    std::string what;
    bool passing = false;   ///< a retry may succeed
    bool cancelled = false; ///< `stop` fired
};

/// Sends requests. Thread safety: concurrent calls are allowed.
class HttpTransport {
  public:
    virtual ~HttpTransport() = default;

    /// Sends a request. Follows no redirects. The bytes of an answer with status 200 or 206 go to `body`; a
    /// longer answer is cut off.
    virtual tl::expected<HttpAnswer, HttpFault>
    perform(const HttpRequest& request, std::span<std::byte> body, const std::stop_token& stop) = 0;
};

} // namespace wakesurf::server
