// One question to a web server and its answer. What is asked, how often, and what an answer is worth is decided in server/service/web/web_disk.hpp;
// server/service/web/curl_transport.hpp is the real one.
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

/// Bytes of an object, `count` of them.
struct HttpRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

struct HttpRequest {
    std::string address;
    bool head = false;                ///< what it is, without its bytes
    std::optional<HttpRange> range{}; ///< nothing: all
    std::string if_match{};           ///< ETag that it has to have; empty: any
};

struct HttpAnswer {
    /// Content-Range: `first`-`last` of `total`; of no bytes where there are none to have.
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
    std::size_t bytes = 0; ///< of the body, those that there was room for
    bool longer = false;   ///< there were more
};

/// Why there is no answer.
struct HttpFault {
    std::string what;
    bool passing = false;   ///< it may go better in a moment
    bool cancelled = false; ///< `stop` fired
};

/// Thread safety: concurrent calls are fine.
class HttpTransport {
  public:
    virtual ~HttpTransport() = default;

    /// Follows no redirects. The bytes of an answer with status 200 or 206 go to `body`; where there are more, it ends there.
    virtual tl::expected<HttpAnswer, HttpFault>
    perform(const HttpRequest& request, std::span<std::byte> body, const std::stop_token& stop) = 0;
};

} // namespace wakesurf::server
