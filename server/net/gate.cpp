#include "server/net/gate.hpp"

#include "server/base/limits.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <utility>

namespace wakesurf::server {

namespace {

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

bool contains(const std::vector<std::string>& list, std::string_view value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

constexpr std::string_view login_word = "login "; // of Visitor::person
constexpr std::string_view login_protocol = "wakesurf.login.";

std::string person_of(const Login& login) {
    return std::string(login_word) + login.id;
}

std::optional<std::string> login_of(std::string_view person) {
    if (!person.starts_with(login_word))
        return std::nullopt;
    return std::string(person.substr(login_word.size()));
}

std::optional<std::string_view> bearer(std::string_view header) {
    constexpr std::string_view scheme = "bearer ";
    if (header.size() <= scheme.size() || lower(header.substr(0, scheme.size())) != scheme)
        return std::nullopt;
    header.remove_prefix(scheme.size());
    return header;
}

/// Returns the token, the key of a link or the login of a request: from its header, or, since browsers can
/// give a WebSocket no header, from its subprotocols. Cookies are ignored, because browsers send them to
/// every port of a host, and every port can set them.
std::optional<std::string_view> shown_secret(const HttpRequest& request) {
    const auto authorization = request.all("authorization");
    if (!authorization.empty())
        return authorization.size() == 1 ? bearer(authorization.front()) : std::nullopt;
    if (!request.upgrade)
        return std::nullopt;
    std::optional<std::string_view> found;
    for (const std::string_view offer : request.list("sec-websocket-protocol")) {
        if (!offer.starts_with(login_protocol))
            continue;
        if (found)
            return std::nullopt;
        found = offer.substr(login_protocol.size());
    }
    return found;
}

bool shows_something(const HttpRequest& request) {
    return shown_secret(request) || !request.all("authorization").empty();
}

} // namespace

std::optional<std::string> host_name(std::string_view authority) {
    const auto bracket = authority.rfind(']');
    const auto colon = authority.find(':', bracket == std::string_view::npos ? 0 : bracket);
    const std::string_view port =
        colon == std::string_view::npos ? std::string_view{} : authority.substr(colon + 1);
    const std::string_view name = authority.substr(0, colon);
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto fits = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_';
    };
    const bool numeric_v6 = name.size() > 2 && name.front() == '[' && name.back() == ']';
    const auto fits_v6 = [](char c) {
        return std::isxdigit(static_cast<unsigned char>(c)) != 0 || c == ':' || c == '.';
    };
    const bool good = numeric_v6 ? std::all_of(name.begin() + 1, name.end() - 1, fits_v6)
                                 : !name.empty() && std::all_of(name.begin(), name.end(), fits);
    constexpr unsigned last_port = 65535;
    unsigned number = 0;
    std::from_chars(port.data(), port.data() + port.size(), number);
    if (!good || port.size() > 5 || !std::all_of(port.begin(), port.end(), digit) ||
        (colon != std::string_view::npos && port.empty()) || number > last_port)
        return std::nullopt;
    return lower(name);
}

bool is_loopback(std::string_view host) {
    const std::string name = lower(host);
    return name == "localhost" || name == "::1" || name == "[::1]" ||
           (name.starts_with("127.") && std::count(name.begin(), name.end(), '.') == 3 &&
            name.find_first_not_of("0123456789.") == std::string::npos);
}

Gate::Gate(GateOptions options,
           Entropy& entropy,
           const core::Clock& clock,
           const Grants& grants,
           Metrics* metrics)
    : options_(std::move(options)), token_(secret_digest(options_.token)),
      own_(options_.logins == nullptr
               ? std::optional<Logins>(std::in_place, entropy, options_.unix_time)
               : std::nullopt),
      logins_(own_ ? *own_ : *options_.logins), grants_(grants),
      secrets_([this](const std::string& grant) {
          return grant.empty() ? std::optional(token_) : grants_.digest(grant);
      }),
      wrong_tokens_(limits::wrong_tokens_per_second, limits::wrong_tokens_at_once, clock),
      strangers_(limits::strangers_per_second, limits::strangers_at_once, clock),
      metrics_(metrics) {
    const bool v6 = options_.host.find(':') != std::string::npos && options_.host.front() != '[';
    hosts_ = {"localhost", "127.0.0.1", "[::1]",
              v6 ? "[" + options_.host + "]" : lower(options_.host)};
    for (const std::string& host : hosts_) {
        origins_.push_back(scheme() + host + ":" + std::to_string(options_.port));
        if (options_.port == (options_.tls ? 443 : 80)) // browsers leave the default port out
            origins_.push_back(scheme() + host);
    }
    for (const std::string& origin : options_.origins) {
        origins_.push_back(lower(origin));
        const auto end = origin.find("://");
        if (end != std::string::npos)
            if (const auto name = host_name(origin.substr(end + 3)))
                hosts_.push_back(*name);
    }
}

std::optional<HttpResponse> Gate::check_open(const HttpRequest& request) const {
    if (auto refusal = check_host(request))
        return refusal;
    return check_origin(request);
}

tl::expected<Visitor, HttpResponse> Gate::check(const HttpRequest& request) {
    if (auto refusal = check_open(request)) {
        auto too_many = count_stranger(request.from, 1.0);
        return tl::unexpected(too_many ? std::move(*too_many) : std::move(*refusal));
    }
    if (options_.token.empty())
        return Visitor({}, request.from);
    return check_token(request);
}

bool Gate::is_host(const HttpRequest& header) {
    if (check_open(header))
        return false;
    if (options_.token.empty())
        return true;
    const auto visitor = visitor_of(header);
    return visitor && visitor->grant.empty();
}

bool Gate::still(const Visitor& visitor) const {
    const auto login = login_of(visitor.person);
    return !(login && logins_.ended(visitor.grant, *login)) &&
           holder_of_grant(visitor.grant).has_value();
}

std::optional<HttpResponse> Gate::check_host(const HttpRequest& request) const {
    const auto values = request.all("host");
    const auto name = values.size() == 1 ? host_name(values.front()) : std::nullopt;
    if (name && (contains(hosts_, *name) || is_loopback(*name)))
        return std::nullopt;
    return http_error(403, "the request is for a host name that this server does not use",
                      "use the address wakesurf printed, or start it with --origin and the address "
                      "that the browser shows, up to the path");
}

std::optional<HttpResponse> Gate::check_origin(const HttpRequest& request) const {
    const auto values = request.all("origin");
    const bool one = values.size() == 1;
    if (values.empty() || (one && (contains(origins_, values.front()) || tunnelled(request))))
        return std::nullopt;
    return http_error(
        403, "the request comes from a page of another origin",
        "open the page at the address wakesurf printed, or start it with --origin and "
        "the address that the browser shows, up to the path");
}

/// Through `ssh -L` browsers know the server by another port. The page's origin is then the address that the
/// request went to, under a name of the browser's own machine, which no foreign DNS can point here.
bool Gate::tunnelled(const HttpRequest& request) const {
    const std::string_view authority = request.header("host");
    const auto name = host_name(authority);
    return name && is_loopback(*name) &&
           request.header("origin") == scheme() + std::string(authority);
}

std::string Gate::scheme() const {
    return options_.tls ? "https://" : "http://";
}

tl::expected<Visitor, HttpResponse> Gate::check_token(const HttpRequest& request) {
    if (auto visitor = visitor_of(request))
        return std::move(*visitor);
    if (shows_something(request))
        return tl::unexpected(wrong_token(request.from));
    if (auto refusal = count_stranger(request.from, 1.0))
        return tl::unexpected(std::move(*refusal));
    return tl::unexpected(
        http_error(401, "a token is needed",
                   "send `Authorization: Bearer TOKEN` with the token wakesurf printed, or "
                   "the key of a share link"));
}

/// Accepts a token or a key as such, or a login made for one.
std::optional<Visitor> Gate::visitor_of(const HttpRequest& request) const {
    const auto secret = shown_secret(request);
    if (!secret)
        return std::nullopt;
    if (auto identity = holder_of(*secret))
        return Visitor(std::move(*identity), request.from);
    if (const auto login = logins_.find(*secret, secrets_))
        if (auto identity = holder_of_grant(login->grant))
            return Visitor(std::move(*identity), person_of(*login));
    return std::nullopt;
}

std::optional<HttpResponse> Gate::count_open(const HttpRequest& request, std::size_t bytes) {
    auto refusal =
        count_stranger(request.from, 1.0 + static_cast<double>(bytes / limits::strangers_bytes));
    if (refusal && (options_.token.empty() || visitor_of(request)))
        return std::nullopt;
    return refusal;
}

std::optional<HttpResponse> Gate::count_stranger(const std::string& from, double count) {
    const auto wait = strangers_.wait_for(from);
    if (wait.count() == 0) {
        strangers_.take(from, count);
        return std::nullopt;
    }
    over_budget(Budgeted::Strangers);
    return http_too_fast("too many requests without a token come from this address",
                         "wait a moment, or log in first", wait);
}

void Gate::over_budget(Budgeted kind) const {
    if (metrics_ != nullptr)
        metrics_->over_budget(kind);
}

/// Both are looked up in any case, so that the time reveals nothing.
std::optional<Identity> Gate::holder_of(std::string_view token) const {
    const auto shared = grants_.find(token);
    return same_digest(secret_digest(token), token_) ? Identity{} : shared;
}

std::optional<Identity> Gate::holder_of_grant(const std::string& grant) const {
    return grant.empty() ? Identity{} : grants_.identity(grant);
}

HttpResponse Gate::wrong_token(const std::string& from) {
    const auto wait = wrong_tokens_.wait_for(from);
    if (wait.count() > 0) {
        over_budget(Budgeted::WrongTokens);
        return http_too_fast("too many wrong tokens have been tried from this address",
                             "wait a few seconds", std::chrono::seconds(5));
    }
    wrong_tokens_.take(from, 1.0);
    return http_error(
        401, "the token is wrong, or the share link has ended",
        "use the token wakesurf printed when it was last started, or ask for a new link");
}

tl::expected<Gate::LoggedIn, HttpResponse> Gate::login(const HttpRequest& request,
                                                       const LoginWish& wish) {
    const auto had = wish.login ? logins_.find(*wish.login, secrets_) : std::nullopt;
    const auto grant = wish.token && !options_.token.empty() ? holder_of(*wish.token)
                       : options_.token.empty()              ? std::optional(Identity{})
                       : had                                 ? holder_of_grant(had->grant)
                                                             : std::nullopt;
    if (!grant)
        return tl::unexpected(wrong_token(request.from));
    const SecretDigest secret = secrets_(grant->grant).value_or(SecretDigest{});
    const bool same = had && had->grant == grant->grant;
    return LoggedIn{same ? logins_.renew(*had, secret) : logins_.make(grant->grant, secret),
                    *grant};
}

std::string Gate::logout(const HttpRequest& request, Logins::Done kept) {
    const auto secret = shown_secret(request);
    const auto login = secret ? logins_.end(*secret, secrets_, kept) : std::nullopt;
    if (!login)
        kept({});
    return login ? person_of(*login) : std::string();
}

} // namespace wakesurf::server
