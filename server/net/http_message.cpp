#include "server/net/http_message.hpp"

#include "protocol/api/json_rpc.hpp"
#include "server/base/split.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace wakesurf::server {

std::vector<std::string_view> HttpRequest::list(std::string_view name) const {
    constexpr std::string_view blank = " \t";
    std::vector<std::string_view> out;
    for (const std::string_view value : all(name))
        for (std::string_view each : split(value, ',')) {
            each.remove_prefix(std::min(each.find_first_not_of(blank), each.size()));
            out.push_back(each.substr(0, each.find_last_not_of(blank) + 1));
        }
    return out;
}

bool HttpRequest::has(std::string_view tag) const {
    const std::string_view known = header("if-none-match");
    return known == "*" || known.find(tag) != std::string_view::npos;
}

SecurityHeaders::SecurityHeaders(const std::vector<std::string>& frame_origins)
    : headers_{
          {"X-Content-Type-Options", "nosniff"},
          {"Referrer-Policy", "no-referrer"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Cross-Origin-Opener-Policy", "same-origin"},
          {"Permissions-Policy",
           "camera=(), geolocation=(), microphone=(), payment=(), serial=(), usb=()"},
      } {
    std::string framing;
    for (const std::string& origin : frame_origins)
        framing += " " + origin;
    // X-Frame-Options cannot name other origins: if there are any, it is left out, and frame-ancestors alone
    // decides.
    if (framing.empty())
        headers_.emplace_back("X-Frame-Options", "DENY");
    headers_.emplace_back(
        "Content-Security-Policy",
        "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; "
        "connect-src 'self'; style-src 'self'; img-src 'self' data: blob:; object-src 'none'; "
        "base-uri 'none'; form-action 'none'; frame-ancestors" +
            (framing.empty() ? " 'none'" : framing));
}

namespace {

using protocol::RpcCode;

RpcCode code_for(unsigned status) {
    switch (status) {
    case 401:
    case 429:
        return RpcCode::Unauthenticated;
    case 403:
        return RpcCode::NotPermitted;
    case 404:
    case 405:
        return RpcCode::NotFound;
    default:
        return RpcCode::InvalidRequest;
    }
}

HttpResponse fault_response(unsigned status, const protocol::RpcFault& fault) {
    return http_text(status, protocol::rpc_error(protocol::null_id, fault), "application/json");
}

} // namespace

HttpResponse http_text(unsigned status, std::string text, const char* type) {
    return {status,
            {{"Content-Type", type}, {"Cache-Control", "no-store"}},
            std::make_shared<const std::string>(std::move(text))};
}

HttpResponse http_json(std::string text) {
    return http_text(200, std::move(text), "application/json");
}

HttpResponse http_error(unsigned status, std::string message, std::string hint) {
    HttpResponse response =
        fault_response(status, {code_for(status), std::move(message), std::move(hint), {}, {}});
    if (status == 401)
        response.headers.emplace_back("WWW-Authenticate", "Bearer");
    return response;
}

HttpResponse http_error(const core::Error& error) {
    using Code = core::Error::Code;
    const unsigned status = error.code == Code::NotFound                            ? 404
                            : error.code == Code::Unsupported                       ? 501
                            : error.code == Code::OverLimit                         ? 503
                            : error.code == Code::Cancelled                         ? 503
                            : error.code == Code::Corrupt || error.code == Code::Io ? 500
                                                                                    : 400;
    HttpResponse response = fault_response(status, protocol::fault_of(error));
    if (status == 503)
        response.headers.emplace_back("Retry-After", "5");
    return response;
}

HttpResponse
http_over_limit(unsigned status, std::uint64_t limit, std::string message, std::string hint) {
    HttpResponse response = fault_response(
        status, {protocol::RpcCode::OverLimit,
                 std::move(message),
                 std::move(hint),
                 {},
                 std::make_shared<const nlohmann::json>(nlohmann::json{{"limit", limit}})});
    if (status == 503)
        response.headers.emplace_back("Retry-After", "5");
    return response;
}

HttpResponse
http_too_fast(std::string message, std::string hint, std::chrono::nanoseconds retry_after) {
    HttpResponse response = http_error(429, std::move(message), std::move(hint));
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(retry_after);
    response.headers.emplace_back("Retry-After", std::to_string(seconds.count()));
    return response;
}

} // namespace wakesurf::server
