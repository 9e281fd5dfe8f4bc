#include "server/net/routes.hpp"

#include "protocol/checked_json.hpp"
#include "protocol/json_text.hpp"
#include "server/limits.hpp"
#include "server/net/http_error.hpp"
#include "server/session_limits.hpp"

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

HttpResponse counted(std::string text) {
    HttpResponse response;
    response.headers = {{"Content-Type", "text/plain; version=0.0.4; charset=utf-8"},
                        {"Cache-Control", "no-store"}};
    response.body = std::make_shared<const std::string>(std::move(text));
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

/// Meshes of sessions a share link is not for.
bool out_of_reach(std::string_view path, const Identity& identity) {
    constexpr std::string_view sessions = "/api/v1/sessions/";
    if (identity.session.empty() || !path.starts_with(sessions))
        return false;
    path.remove_prefix(sessions.size());
    return path.substr(0, path.find('/')) != identity.session;
}

} // namespace

tl::expected<Identity, HttpResponse> Routes::admit_upgrade(const HttpRequest& request) {
    auto identity = gate_.check(request);
    if (!identity)
        return tl::unexpected(http_error(identity.error()));
    if (request.path != "/ws")
        return tl::unexpected(
            http_error(404, "there is no WebSocket at this path", "connect to /ws"));
    if (!speaks_our_protocol(request))
        return tl::unexpected(http_error(400, "none of the subprotocols offered is spoken here",
                                         "offer wakesurf.v1"));
    return std::move(*identity);
}

std::size_t Routes::longest_body(const HttpRequest& header) {
    if (header.method != "POST" || header.path != SessionFiles::import_path)
        return limits::message_bytes;
    const auto identity = gate_.check(header);
    return identity && identity->grant.empty() ? limits::session_file_bytes : limits::message_bytes;
}

void Routes::handle(const HttpRequest& request, Respond respond) {
    const bool file = files_.has(request.path);
    if (file || request.path == "/healthz" || request.path == "/api/v1/login") {
        if (const auto refusal = gate_.check_open(request))
            return respond(http_error(*refusal));
        if (request.path == "/api/v1/login")
            return respond(request.method == "POST" ? login(request) : wrong_method("POST"));
        if (!reads(request))
            return respond(wrong_method("GET"));
        return respond(file ? files_.respond(request) : healthy());
    }
    const auto identity = gate_.check(request);
    if (!identity)
        return respond(http_error(identity.error()));
    // What took its time, a wait or a file, is not for those whose share link has ended meanwhile.
    serve(
        request, *identity,
        [&gate = gate_, identity = *identity, respond = std::move(respond)](HttpResponse response) {
            if (gate.still(identity))
                return respond(std::move(response));
            respond(http_error(Refusal{401, "the share link has ended", "ask for a new one"}));
        });
}

void Routes::serve(const HttpRequest& request, const Identity& identity, Respond respond) {
    if (request.path == "/rpc")
        return request.method == "POST" ? call(request, identity, std::move(respond))
                                        : respond(wrong_method("POST"));
    if (request.path == SessionFiles::import_path)
        return request.method == "POST" ? session_files_.post(request, identity, respond)
                                        : respond(wrong_method("POST"));
    if (!reads(request))
        return respond(wrong_method("GET"));
    if (request.path == "/openrpc.json")
        return respond(http_json(dispatcher_.document()));
    if (request.path == "/metrics")
        return respond(identity.grant.empty() ? counted(metrics_())
                                              : http_error(403, "a share link does not open this",
                                                           "send the token wakesurf printed"));
    if (request.path == "/ws")
        return respond(http_error(426, "this path is for WebSockets",
                                  "connect with the subprotocol wakesurf.v1"));
    if (out_of_reach(request.path, identity))
        return respond(http_error(403, "the share link is for another session",
                                  "ask a host of that session for a link to it"));
    if (!session_files_.get(request, respond) && !downloads_.handle(request, identity, respond))
        respond(http_error(404, "there is nothing at this path", "README.md lists the paths"));
}

void Routes::call(const HttpRequest& request, const Identity& identity, Respond respond) {
    dispatcher_.dispatch(request.body, identity, nullptr,
                         [respond = std::move(respond)](std::string text) {
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
    const auto cookie = gate_.login(request, token);
    if (!cookie)
        return http_error(cookie.error());
    return {204, {{"Set-Cookie", *cookie}, {"Cache-Control", "no-store"}}};
}

} // namespace wakesurf::server
