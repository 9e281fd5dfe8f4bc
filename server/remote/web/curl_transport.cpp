#include "server/remote/web/curl_transport.hpp"

#include "server/remote/web/http_transport.hpp"

#include <curl/curl.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Reads one line. A status line begins the answer anew: there is one for each intermediate answer.
void read_header(std::string_view line, HttpAnswer& answer);

namespace {

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const auto begin = text.find_first_not_of(blank);
    if (begin == std::string_view::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

template <class Number = std::uint64_t>
std::optional<Number> number(std::string_view text) {
    Number value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || fault != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

// Parses "bytes 0-99/1000" and "bytes */1000".
std::optional<HttpAnswer::Range> content_range(std::string_view text) {
    constexpr std::string_view unit = "bytes ";
    const auto slash = text.find('/');
    if (!text.starts_with(unit) || slash == std::string_view::npos)
        return std::nullopt;
    const auto total = number(text.substr(slash + 1));
    if (!total)
        return std::nullopt;
    const auto part = text.substr(unit.size(), slash - unit.size());
    if (part == "*")
        return HttpAnswer::Range{std::nullopt, std::nullopt, *total};
    const auto dash = part.find('-');
    if (dash == std::string_view::npos)
        return std::nullopt;
    const auto first = number(part.substr(0, dash));
    const auto last = number(part.substr(dash + 1));
    if (!first || !last)
        return std::nullopt;
    return HttpAnswer::Range{first, last, *total};
}

} // namespace

void read_header(std::string_view line, HttpAnswer& answer) {
    if (line.starts_with("HTTP/")) {
        const auto space = line.find(' ');
        answer = {};
        if (space != std::string_view::npos)
            answer.status = number<int>(without_blanks(line.substr(space + 1, 3))).value_or(0);
        return;
    }
    const auto colon = line.find(':');
    if (colon == std::string_view::npos)
        return;
    const std::string_view name = line.substr(0, colon);
    const std::string_view value = without_blanks(line.substr(colon + 1));
    const auto is = [&](std::string_view known) {
        return std::equal(name.begin(), name.end(), known.begin(), known.end(), [](char a, char b) {
            return std::tolower(static_cast<unsigned char>(a)) == b;
        });
    };
    if (is("etag"))
        answer.etag = value;
    else if (is("last-modified"))
        answer.last_modified = value;
    else if (is("content-type"))
        answer.content_type = value;
    else if (is("location"))
        answer.location = value;
    else if (is("content-length"))
        answer.content_length = number(value);
    else if (is("content-range"))
        answer.range = content_range(value);
    else if (is("retry-after"))
        if (const auto seconds = number<std::uint32_t>(value))
            answer.retry_after = std::chrono::seconds(*seconds);
}

namespace {

constexpr long connect_seconds = 10;
// Ends an answer that comes more slowly: a server that drips would be waited for without an end.
constexpr long slow_seconds = 20;
constexpr long least_speed = 64 * 1024 / slow_seconds; // bytes a second
constexpr std::size_t most_unused = std::size_t{64}
                                    << 10; // of an error's page, read to keep the connection

std::string variable(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

struct FreeHandle {
    void operator()(CURL* handle) const { curl_easy_cleanup(handle); }
};

using Handle = std::unique_ptr<CURL, FreeHandle>;

struct FreeList {
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};

using Headers = std::unique_ptr<curl_slist, FreeList>;

void add(Headers& headers, const std::string& line) {
    curl_slist* const longer = curl_slist_append(headers.get(), line.c_str());
    if (longer == nullptr)
        throw std::bad_alloc();
    (void)headers.release();
    headers.reset(longer);
}

/// Holds what a call fills while libcurl calls back.
struct Transfer {
    HttpAnswer answer;
    std::span<std::byte> body;
    std::stop_token stop;
    std::size_t unused = 0;
};

std::size_t take_header(char* line, std::size_t one, std::size_t count, void* to) {
    read_header({line, one * count}, static_cast<Transfer*>(to)->answer);
    return one * count;
}

std::size_t take_body(char* bytes, std::size_t one, std::size_t count, void* to) {
    Transfer& transfer = *static_cast<Transfer*>(to);
    const std::size_t size = one * count;
    HttpAnswer& answer = transfer.answer;
    if (answer.status != 200 && answer.status != 206) {
        transfer.unused += size;
        return transfer.unused <= most_unused ? size : 0;
    }
    const std::size_t room = std::min(size, transfer.body.size() - answer.bytes);
    if (room > 0)
        std::memcpy(transfer.body.data() + answer.bytes, bytes, room);
    answer.bytes += room;
    answer.longer = room < size;
    return room;
}

int go_on(void* of, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
    return static_cast<const Transfer*>(of)->stop.stop_requested() ? 1 : 0;
}

bool passes(CURLcode code) {
    switch (code) {
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_CONNECT:
    case CURLE_PARTIAL_FILE:
    case CURLE_OPERATION_TIMEDOUT:
    case CURLE_SSL_CONNECT_ERROR:
    case CURLE_GOT_NOTHING:
    case CURLE_SEND_ERROR:
    case CURLE_RECV_ERROR:
    case CURLE_HTTP2:
    case CURLE_HTTP2_STREAM:
        return true;
    default:
        return false;
    }
}

} // namespace

HttpCredentials HttpCredentials::of_environment() {
    return {variable("WAKESURF_HTTP_TOKEN"), variable("WAKESURF_HTTP_S3_REGION"),
            variable("AWS_ACCESS_KEY_ID"), variable("AWS_SECRET_ACCESS_KEY"),
            variable("AWS_SESSION_TOKEN")};
}

struct CurlTransport::State {
    HttpCredentials credentials;
    std::string trusted = variable("SSL_CERT_FILE");
    std::mutex mutex; ///< guards what follows
    std::vector<Handle> idle;

    Handle take() {
        {
            const std::scoped_lock lock(mutex);
            if (!idle.empty()) {
                Handle handle = std::move(idle.back());
                idle.pop_back();
                return handle;
            }
        }
        Handle handle(curl_easy_init());
        if (!handle)
            throw std::runtime_error("libcurl cannot be initialised");
        return handle;
    }

    void give_back(Handle handle) {
        const std::scoped_lock lock(mutex);
        idle.push_back(std::move(handle));
    }

    void prove(CURL* handle, Headers& headers) const {
        if (!credentials.token.empty()) {
            add(headers, "Authorization: Bearer " + credentials.token);
        } else if (!credentials.s3_region.empty()) {
            const std::string service = "aws:amz:" + credentials.s3_region + ":s3";
            curl_easy_setopt(handle, CURLOPT_AWS_SIGV4, service.c_str());
            curl_easy_setopt(handle, CURLOPT_USERNAME, credentials.access_key.c_str());
            curl_easy_setopt(handle, CURLOPT_PASSWORD, credentials.secret_key.c_str());
            if (!credentials.session_token.empty())
                add(headers, "X-Amz-Security-Token: " + credentials.session_token);
        }
    }
};

CurlTransport::CurlTransport(HttpCredentials credentials) : state_(std::make_unique<State>()) {
    static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
    if (ready != CURLE_OK)
        throw std::runtime_error("libcurl cannot be initialised");
    state_->credentials = std::move(credentials);
}

CurlTransport::~CurlTransport() = default;

tl::expected<HttpAnswer, HttpFault> CurlTransport::perform(const HttpRequest& request,
                                                           std::span<std::byte> body,
                                                           const std::stop_token& stop) {
    Handle kept = state_->take();
    CURL* const handle = kept.get();
    curl_easy_reset(handle); // keeps its connection
    Transfer transfer{{}, body, stop};
    char words[CURL_ERROR_SIZE] = "";
    Headers headers;
    const auto set = [&](CURLoption option, auto value) {
        curl_easy_setopt(handle, option, value);
    };
    set(CURLOPT_URL, request.address.c_str());
    set(CURLOPT_PROTOCOLS_STR, "http,https");
    set(CURLOPT_FOLLOWLOCATION, 0L);
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_CONNECTTIMEOUT, connect_seconds);
    set(CURLOPT_LOW_SPEED_LIMIT, least_speed);
    set(CURLOPT_LOW_SPEED_TIME, slow_seconds);
    set(CURLOPT_USERAGENT, "wakesurf/" WAKESURF_VERSION);
    set(CURLOPT_ERRORBUFFER, static_cast<char*>(words));
    set(CURLOPT_HEADERFUNCTION, &take_header);
    set(CURLOPT_HEADERDATA, static_cast<void*>(&transfer));
    set(CURLOPT_WRITEFUNCTION, &take_body);
    set(CURLOPT_WRITEDATA, static_cast<void*>(&transfer));
    set(CURLOPT_NOPROGRESS, 0L);
    set(CURLOPT_XFERINFOFUNCTION, &go_on);
    set(CURLOPT_XFERINFODATA, static_cast<void*>(&transfer));
    if (state_->credentials.any() && request.address.starts_with("http://"))
        set(CURLOPT_NOPROXY, "*"); // of this machine alone: a proxy would read the credentials
    if (!state_->trusted.empty())
        set(CURLOPT_CAINFO, state_->trusted.c_str());
    if (request.head)
        set(CURLOPT_NOBODY, 1L);
    if (request.range) // set by hand, so that it is signed as well
        add(headers, "Range: bytes=" + std::to_string(request.range->first) + "-" +
                         std::to_string(request.range->first + request.range->count - 1));
    if (!request.if_match.empty())
        add(headers, "If-Match: " + request.if_match);
    state_->prove(handle, headers);
    set(CURLOPT_HTTPHEADER, headers.get());
    const CURLcode code = curl_easy_perform(handle);
    state_->give_back(std::move(kept));
    const bool ended_here = code == CURLE_WRITE_ERROR && transfer.answer.status != 0 &&
                            (transfer.answer.longer || transfer.unused > most_unused);
    if (code == CURLE_OK || ended_here)
        return std::move(transfer.answer);
    if (code == CURLE_ABORTED_BY_CALLBACK)
        return tl::unexpected(HttpFault{"it was cancelled", false, true});
    return tl::unexpected(
        HttpFault{words[0] != '\0' ? words : curl_easy_strerror(code), passes(code), false});
}

} // namespace wakesurf::server
