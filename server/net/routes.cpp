#include "server/net/routes.hpp"

#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"
#include "server/base/limits.hpp"
#include "server/base/split.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>

namespace wakesurf::server {

namespace {

constexpr std::string_view login_path = "/api/v1/login";
constexpr std::string_view logout_path = "/api/v1/logout";
constexpr std::string_view health_path = "/healthz";

bool reads(const HttpRequest& request) {
    return request.method == "GET" || request.method == "HEAD";
}

/// Says whether a request may change something.
bool writes(const HttpRequest& request) {
    const std::string& method = request.method;
    return method == "POST" || method == "PUT" || method == "PATCH" || method == "DELETE";
}

HttpResponse wrong_method(const char* allowed) {
    HttpResponse response =
        http_error(405, "this path does not accept this method", std::string("use ") + allowed);
    response.headers.emplace_back("Allow", allowed);
    return response;
}

/// Says whether a client offers our subprotocol; one that offers none is a script and gets ours.
bool speaks_our_protocol(const HttpRequest& request) {
    const auto offers = request.list("sec-websocket-protocol");
    return offers.empty() || std::ranges::find(offers, "wakesurf.v1") != offers.end();
}

/// Says whether a key is 16 bytes in base64 (RFC 6455, 4.2.1).
bool is_websocket_key(std::string_view key) {
    constexpr std::size_t digits = 22;
    const auto digit = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '/';
    };
    return key.size() == digits + 2 && key.ends_with("==") &&
           std::all_of(key.begin(), key.begin() + digits, digit);
}

/// Says whether a path has files whose names are not known here.
bool has_files(std::string_view path) {
    return path == "/openrpc.json" || path == "/metrics" || path == "/ws" ||
           path.starts_with("/api/v1/sessions/") || path.starts_with("/api/v1/datasets/");
}

/// Says whether an answer takes time and memory to make.
bool is_download(const HttpRequest& request) {
    const std::string& path = request.path;
    return path.starts_with("/api/v1/sessions/") && reads(request) &&
           (path.find("/surfaces/") != std::string::npos || path.ends_with("/session.json"));
}

/// Says whether the memory of an answer is counted already, for all its readers: net/shared_files.
bool is_shared_file(const std::string& path) {
    return path.find("/surfaces/") != std::string::npos || path.ends_with("/obstacle.bin") ||
           path.ends_with("/body.vtp") || path.ends_with("/slice.bin") ||
           path.ends_with("/lines.bin");
}

HttpResponse too_much_waits(std::size_t bytes) {
    return http_over_limit(503, bytes,
                           "too much waits to be sent for the server to answer this now",
                           "try again in a few seconds, or ask for less");
}

HttpResponse too_many_logins(const Budgets::TooFast& slower) {
    return http_too_fast("too many logins and logouts of this token or link, or from this address",
                         "wait a moment", slower.retry_after);
}

HttpResponse nothing_there() {
    return http_error(404, "there is nothing at this path", "README.md lists the paths");
}

/// No path has two slashes together: they come from an address that ended in one. A token does not help.
std::optional<HttpResponse> doubled_slash(const std::string& path) {
    if (!path.starts_with('/') || path.find("//") == std::string::npos)
        return std::nullopt;
    std::string meant;
    for (const char c : path)
        if (c != '/' || !meant.ends_with('/'))
            meant += c;
    return http_error(404, "the path has two slashes together",
                      "ask for " + meant +
                          ": leave out the slash at the end of the address before it");
}

/// Says whether a path belongs to a session that the share link is not for.
bool out_of_reach(std::string_view path, const Visitor& visitor) {
    return !visitor.session.empty() && path.starts_with("/api/v1/sessions/") &&
           split(path, '/')[4] != visitor.session;
}

} // namespace

tl::expected<Admitted, HttpResponse> Routes::admit_upgrade(const HttpRequest& request) {
    if (auto mistaken = doubled_slash(request.path))
        return tl::unexpected(std::move(*mistaken));
    auto visitor = gate_.check(request);
    if (!visitor)
        return tl::unexpected(std::move(visitor.error()));
    if (request.path != "/ws")
        return tl::unexpected(
            http_error(404, "there is no WebSocket at this path", "connect to /ws"));
    if (!speaks_our_protocol(request))
        return tl::unexpected(http_error(
            400, "the server supports none of the offered subprotocols", "offer wakesurf.v1"));
    const auto keys = request.all("sec-websocket-key");
    if (keys.size() != 1 || !is_websocket_key(keys.front()))
        return tl::unexpected(http_error(400, "Sec-WebSocket-Key is not 16 bytes in base64",
                                         "leave it to a WebSocket library"));
    auto permit = budgets_.take(*visitor, Use::Socket);
    if (!permit)
        return tl::unexpected(http_error(permit.error()));
    return Admitted{std::move(*visitor), std::move(*permit)};
}

std::size_t Routes::longest_body(const HttpRequest& header) {
    if (header.method != "POST" || header.path != SessionFiles::import_path)
        return limits::message_bytes;
    return gate_.is_host(header) ? limits::session_file_bytes : limits::message_bytes;
}

void Routes::handle(const HttpRequest& request,
                    const std::function<void()>& let_in,
                    Respond respond) {
    if (request.path == logout_path && request.method == "POST" && !gate_.check_open(request))
        return logout(request, std::move(respond));
    if (auto answer = answer_open(request))
        return respond(counted_open(request, std::move(*answer)));
    const auto visitor = gate_.check(request);
    if (!visitor)
        return respond(visitor.error());
    const double messages = 1.0 + static_cast<double>(request.body.size()) / 1024.0;
    const auto pause = budgets_.read(*visitor, messages);
    auto permits = permits_for(request, *visitor);
    if (!permits) {
        HttpResponse refusal = http_error(permits.error());
        refusal.pause = pause;
        return respond(std::move(refusal));
    }
    let_in();
    // After a wait or a file the share link or login may have ended: check again.
    serve(request, *visitor,
          [&gate = gate_, &outboxes = outboxes_, visitor = *visitor, pause,
           permits = std::move(*permits), shared = is_shared_file(request.path),
           respond = std::move(respond)](HttpResponse response) {
              if (!gate.still(visitor))
                  response = http_error(401, "the share link or login has ended",
                                        "ask for a new link, or log in again");
              const std::size_t bytes = shared ? 0 : response.body->size();
              auto held = outboxes.hold(bytes);
              if (held == nullptr)
                  response = too_much_waits(bytes);
              response.pause = pause;
              response.held =
                  std::make_shared<std::pair<std::shared_ptr<void>, std::shared_ptr<void>>>(
                      permits, std::move(held));
              respond(std::move(response));
          });
}

/// Answers requests that need no token; empty for all other paths.
std::optional<HttpResponse> Routes::answer_open(const HttpRequest& request) {
    const bool file = files_.has(request.path);
    const bool in = request.path == login_path;
    const bool out = request.path == logout_path;
    if (auto mistaken = doubled_slash(request.path)) {
        auto refusal = gate_.check_origin(request);
        return refusal ? std::move(refusal) : std::move(mistaken);
    }
    if (!file && !in && !out && request.path != health_path)
        return std::nullopt;
    auto refusal = file          ? gate_.check_host(request)
                   : (in || out) ? gate_.check_open(request)
                                 : gate_.check_origin(request);
    if (refusal)
        return refusal;
    if (in || out)
        return request.method == "POST" ? login(request) : wrong_method("POST");
    if (!reads(request))
        return wrong_method("GET");
    return file ? files_.respond(request) : http_text(200, health_());
}

/// Counts an open request. A valid login is no stranger's: it counts as an edit of its token or link. /healthz is always answered, or a flood would make
/// monitors restart a healthy server; its connection is delayed instead.
HttpResponse Routes::counted_open(const HttpRequest& request, HttpResponse answer) {
    if (request.path == login_path && answer.status == 200)
        return answer;
    auto refusal = gate_.count_open(request, answer.body->size());
    if (!refusal)
        return answer;
    if (request.path != health_path)
        return std::move(*refusal);
    answer.pause = limits::stranger_pause;
    return answer;
}

/// Takes the permits of a request, and of a download until the response has been written.
core::Result<std::shared_ptr<void>> Routes::permits_for(const HttpRequest& request,
                                                        const Visitor& visitor) {
    auto both = std::make_shared<std::array<Budgets::Permit, 2>>();
    auto permit = budgets_.take(visitor, Use::Request);
    if (!permit)
        return tl::unexpected(permit.error());
    (*both)[0] = std::move(*permit);
    if (!is_download(request))
        return both;
    permit = budgets_.take(visitor, Use::Download);
    if (!permit)
        return tl::unexpected(permit.error());
    (*both)[1] = std::move(*permit);
    return both;
}

void Routes::serve(const HttpRequest& request, const Visitor& visitor, Respond respond) {
    if (request.path == "/rpc")
        return request.method == "POST" ? call(request, visitor, std::move(respond))
                                        : respond(wrong_method("POST"));
    if (request.path == SessionFiles::import_path)
        return request.method == "POST" ? session_files_.post(request, visitor, respond)
                                        : respond(wrong_method("POST"));
    if (!reads(request))
        return respond(has_files(request.path) || !writes(request) ? wrong_method("GET")
                                                                   : nothing_there());
    if (request.path == "/openrpc.json")
        return respond(http_json(dispatcher_.document()));
    if (request.path == "/metrics")
        return respond(visitor.grant.empty()
                           ? http_text(200, metrics_(), "text/plain; version=0.0.4; charset=utf-8")
                           : http_error(403, "a share link does not give access to this",
                                        "send the token wakesurf printed"));
    if (request.path == "/ws")
        return respond(http_error(426, "this path is for WebSockets",
                                  "connect with the subprotocol wakesurf.v1"));
    if (out_of_reach(request.path, visitor))
        return respond(http_error(403, "the share link is for another session",
                                  "ask a host of that session for a link to it"));
    if (!session_files_.get(request, respond) && !downloads_.handle(request, visitor, respond))
        respond(nothing_there());
}

void Routes::call(const HttpRequest& request, const Visitor& visitor, Respond respond) {
    dispatcher_.dispatch(request.body, visitor, nullptr,
                         [respond = std::move(respond)](std::string text) {
                             if (text.empty())
                                 respond({204, {{"Cache-Control", "no-store"}}});
                             else
                                 respond(http_json(std::move(text)));
                         });
}

HttpResponse Routes::login(const HttpRequest& request) {
    constexpr const char* example = R"(send {"token":"..."}, {"login":"..."} or both)";
    const auto body =
        protocol::parse_json(request.body, {limits::message_bytes, limits::message_depth});
    if (!body)
        return http_error(400, "the body is not JSON", example);
    protocol::JsonReader in(*body, true);
    Gate::LoginWish wish;
    in.some("token", wish.token, {.hi = 512, .text = protocol::Text::Line});
    in.some("login", wish.login, {.hi = 512, .text = protocol::Text::Line});
    in.check("token", wish.token || wish.login ? "" : "is missing");
    if (const auto verdict = in.verdict(); !verdict)
        return http_error(400, verdict.error().message, example);
    const auto login = gate_.login(request, wish);
    if (!login)
        return login.error();
    // Each login has a person of its own, so here the address counts as the person.
    if (const auto slower = budgets_.call(Visitor(login->holder, request.from), true))
        return too_many_logins(*slower);
    nlohmann::json answer{{"login", login->login}};
    if (!login->holder.session.empty())
        answer["session"] = login->holder.session;
    return http_json(protocol::json_text(answer));
}

/// Ends the login that is shown at once. The answer waits for the disk, and reports its error.
void Routes::logout(const HttpRequest& request, Respond respond) {
    if (const auto refusal = gate_.count_open(request))
        return respond(*refusal);
    if (const auto visitor = gate_.check(request))
        if (const auto slower = budgets_.call(Visitor(*visitor, request.from), true))
            return respond(too_many_logins(*slower));
    const auto answer = std::make_shared<Respond>(std::move(respond));
    const std::string person = gate_.logout(request, [answer](const core::Result<void>& kept) {
        nlohmann::json said{{"durable", kept.has_value()}};
        if (!kept)
            said["hint"] =
                "the login that ended may be valid again after a restart of the server: " +
                kept.error().message;
        (*answer)(http_json(protocol::json_text(said)));
    });
    if (!person.empty())
        logged_out_(person);
}

} // namespace wakesurf::server
