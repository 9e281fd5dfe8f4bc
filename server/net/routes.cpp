#include "server/net/routes.hpp"

#include "protocol/checked_json.hpp"
#include "protocol/json_text.hpp"
#include "server/limits.hpp"
#include "server/net/http_error.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

bool reads(const HttpRequest& request) {
    return request.method == "GET" || request.method == "HEAD";
}

HttpResponse wrong_method(const char* allowed) {
    HttpResponse response =
        http_error(405, "the path does not take this method", std::string("use ") + allowed);
    response.headers.emplace_back("Allow", allowed);
    return response;
}

HttpResponse healthy() {
    HttpResponse response;
    response.headers = {{"Content-Type", "text/plain; charset=utf-8"},
                        {"Cache-Control", "no-store"}};
    response.body = std::make_shared<const std::string>("ok");
    return response;
}

/// The subprotocols a client offers; one that offers none is a script and gets ours.
bool speaks_our_protocol(const HttpRequest& request) {
    const auto offers = request.all("sec-websocket-protocol");
    for (const std::string_view offer : offers)
        if (offer.find("wakesurf.v1") != std::string_view::npos)
            return true;
    return offers.empty();
}

} // namespace

std::optional<HttpResponse> Routes::refuse_upgrade(const HttpRequest& request) {
    if (const auto refusal = gate_.check(request, false))
        return http_error(*refusal);
    if (request.path != "/ws")
        return http_error(404, "there is no WebSocket at this path", "connect to /ws");
    if (!speaks_our_protocol(request))
        return http_error(400, "none of the subprotocols offered is spoken here",
                          "offer wakesurf.v1");
    return std::nullopt;
}

void Routes::handle(const HttpRequest& request, Respond respond) {
    const bool open =
        files_.has(request.path) || request.path == "/healthz" || request.path == "/api/v1/login";
    if (const auto refusal = gate_.check(request, open))
        return respond(http_error(*refusal));
    if (request.path == "/rpc" || request.path == "/api/v1/login")
        return request.method == "POST" ? post(request, std::move(respond))
                                        : respond(wrong_method("POST"));
    if (!reads(request))
        return respond(wrong_method("GET"));
    if (files_.has(request.path))
        return respond(files_.respond(request));
    if (request.path == "/healthz")
        return respond(healthy());
    if (request.path == "/openrpc.json")
        return respond(http_json(dispatcher_.document()));
    if (request.path == "/ws")
        return respond(http_error(426, "this path is for WebSockets",
                                  "connect with the subprotocol wakesurf.v1"));
    if (!downloads_.handle(request, respond))
        respond(http_error(404, "there is nothing at this path", "README.md lists the paths"));
}

void Routes::post(const HttpRequest& request, Respond respond) {
    if (request.path == "/api/v1/login")
        return respond(login(request));
    dispatcher_.dispatch(request.body, nullptr, [respond = std::move(respond)](std::string text) {
        if (text.empty())
            respond({204, {{"Cache-Control", "no-store"}}});
        else
            respond(http_json(std::move(text)));
    });
}

HttpResponse Routes::login(const HttpRequest& request) {
    const auto body =
        protocol::parse_json(request.body, {limits::message_bytes, limits::message_depth});
    if (!body)
        return http_error(400, "the body is not JSON", R"(send {"token":"..."})");
    protocol::CheckedJson in(*body);
    const std::string token = in.text("token", 512);
    if (const auto verdict = in.verdict(); !verdict)
        return http_error(400, verdict.error().message, R"(send {"token":"..."})");
    std::string cookie;
    if (const auto refusal = gate_.login(token, cookie))
        return http_error(*refusal);
    return {204, {{"Set-Cookie", cookie}, {"Cache-Control", "no-store"}}};
}

} // namespace wakesurf::server
