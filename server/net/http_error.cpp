#include "server/net/http_error.hpp"

#include "protocol/api/json_rpc.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

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
    HttpResponse response = http_json(protocol::rpc_error(protocol::null_id, fault));
    response.status = status;
    return response;
}

} // namespace

HttpResponse http_json(std::string text) {
    HttpResponse response;
    response.headers = {{"Content-Type", "application/json"}, {"Cache-Control", "no-store"}};
    response.body = std::make_shared<const std::string>(std::move(text));
    return response;
}

HttpResponse http_error(unsigned status, std::string message, std::string hint) {
    return fault_response(status, {code_for(status), std::move(message), std::move(hint), {}, {}});
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

HttpResponse http_error(const Refusal& refusal) {
    HttpResponse response =
        refusal.limit
            ? http_over_limit(refusal.status, *refusal.limit, refusal.message, refusal.hint)
            : http_error(refusal.status, refusal.message, refusal.hint);
    if (refusal.status == 401)
        response.headers.emplace_back("WWW-Authenticate", "Bearer");
    if (refusal.status == 429)
        response.headers.emplace_back("Retry-After", std::to_string(refusal.retry_after.count()));
    return response;
}

} // namespace wakesurf::server
