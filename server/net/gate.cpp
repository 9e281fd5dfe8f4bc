#include "server/net/gate.hpp"

#include "server/limits.hpp"

#include <algorithm>
#include <cctype>

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

constexpr std::string_view login_word = "login ";

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

/// Browsers send a cookie to every port of a host, so its name says which: two servers would log each other out. It is the port
/// browsers know, which may be another than ours behind a proxy or in a container.
std::string cookie_name(const HttpRequest& request, std::uint16_t own_port) {
    const std::string_view authority = request.header("host");
    const auto colon = authority.rfind(':');
    const bool port =
        colon != std::string_view::npos && authority.find(']', colon) == std::string_view::npos;
    return "wakesurf_session_" +
           (port ? std::string(authority.substr(colon + 1)) : std::to_string(own_port));
}

/// Several of one name may come, from a host and the domain above it.
std::vector<std::string_view> cookies_named(std::string_view name, const HttpRequest& request) {
    std::vector<std::string_view> found;
    for (std::string_view header : request.all("cookie"))
        while (!header.empty()) {
            const auto end = std::min(header.find(';'), header.size());
            std::string_view pair = header.substr(0, end);
            header.remove_prefix(std::min(end + 1, header.size()));
            pair.remove_prefix(std::min(pair.find_first_not_of(' '), pair.size()));
            const auto equals = pair.find('=');
            if (equals != std::string_view::npos && pair.substr(0, equals) == name)
                found.push_back(pair.substr(equals + 1));
        }
    return found;
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
    if (!good || port.size() > 5 || !std::all_of(port.begin(), port.end(), digit) ||
        (colon != std::string_view::npos && port.empty()))
        return std::nullopt;
    return lower(name);
}

bool is_loopback(std::string_view host) {
    const std::string name = lower(host);
    return name == "localhost" || name == "::1" || name == "[::1]" ||
           (name.starts_with("127.") && std::count(name.begin(), name.end(), '.') == 3 &&
            name.find_first_not_of("0123456789.") == std::string::npos);
}

bool is_cookie_path(std::string_view path) {
    constexpr std::size_t longest = 512;
    constexpr std::string_view marks =
        "/-._~%!$&'()*+,=:@"; // of a URL's path (RFC 3986), without the semicolon
    const auto fits = [&](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || marks.find(c) != marks.npos;
    };
    return path.size() <= longest && path.starts_with('/') && path.ends_with('/') &&
           std::all_of(path.begin(), path.end(), fits);
}

Gate::Gate(GateOptions options,
           Entropy& entropy,
           const core::Clock& clock,
           const Grants& grants,
           Metrics* metrics)
    : options_(std::move(options)), token_(secret_digest(options_.token)),
      cookies_({entropy, clock, options_.unix_time,
                [this](const std::string& grant) {
                    return grant.empty() ? std::optional(token_) : grants_.digest(grant);
                },
                options_.kept}),
      grants_(grants),
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

std::optional<Refusal> Gate::check_open(const HttpRequest& request) const {
    if (auto refusal = check_host(request))
        return refusal;
    return check_origin(request);
}

std::optional<Refusal> Gate::check_file(const HttpRequest& request) const {
    return check_host(request);
}

std::optional<Refusal> Gate::check_health(const HttpRequest& request) const {
    return check_origin(request);
}

tl::expected<Visitor, Refusal> Gate::check(const HttpRequest& request) {
    if (auto refusal = check_open(request)) {
        auto too_many = count_stranger(request.from, 1.0);
        return tl::unexpected(too_many ? std::move(*too_many) : std::move(*refusal));
    }
    if (options_.token.empty())
        return Visitor({}, request.from);
    auto identity = check_token(request);
    if (!identity)
        return identity;
    if (auto refusal = check_sender(request))
        return tl::unexpected(std::move(*refusal));
    return identity;
}

bool Gate::is_host(const HttpRequest& header) {
    if (check_open(header))
        return false;
    if (options_.token.empty())
        return true;
    const auto visitor = visitor_of(header);
    return visitor && visitor->grant.empty() && !check_sender(header);
}

/// A browser says where a page that posts or opens a WebSocket comes from. Without that only the token itself will
/// do, because the cookie goes along with other pages' requests in browsers that do not know SameSite.
std::optional<Refusal> Gate::check_sender(const HttpRequest& request) const {
    const bool harmless = (request.method == "GET" || request.method == "HEAD") && !request.upgrade;
    if (harmless || !request.all("origin").empty() || !request.all("authorization").empty())
        return std::nullopt;
    return Refusal{403, "the request has no Origin header",
                   "send the token in an Authorization header"};
}

bool Gate::still(const Visitor& visitor) const {
    const auto login = login_of(visitor.person);
    return (!login || cookies_.lasts(*login)) && holder_of_grant(visitor.grant);
}

std::optional<Refusal> Gate::check_host(const HttpRequest& request) const {
    const auto values = request.all("host");
    const auto name = values.size() == 1 ? host_name(values.front()) : std::nullopt;
    if (name && (contains(hosts_, *name) || is_loopback(*name)))
        return std::nullopt;
    return Refusal{403, "the request is for a host name that this server does not use",
                   "use the address wakesurf printed, or start it with --origin and the address "
                   "that the browser shows, up to the path"};
}

std::optional<Refusal> Gate::check_origin(const HttpRequest& request) const {
    const auto values = request.all("origin");
    const bool one = values.size() == 1;
    if (values.empty() || (one && (contains(origins_, values.front()) || tunnelled(request))))
        return std::nullopt;
    return Refusal{403, "the request comes from a page of another origin",
                   "open the page at the address wakesurf printed, or start it with --origin and "
                   "the address that the browser shows, up to the path"};
}

/// Through `ssh -L` browsers know the server by another port. The page's origin is then the very address that the request went to;
/// under a name of the browser's own machine, which no foreign DNS can point here.
bool Gate::tunnelled(const HttpRequest& request) const {
    const std::string_view authority = request.header("host");
    const auto name = host_name(authority);
    return name && is_loopback(*name) &&
           request.header("origin") == scheme() + std::string(authority);
}

std::string Gate::scheme() const {
    return options_.tls ? "https://" : "http://";
}

tl::expected<Visitor, Refusal> Gate::check_token(const HttpRequest& request) {
    if (auto visitor = visitor_of(request))
        return std::move(*visitor);
    if (!request.all("authorization").empty())
        return tl::unexpected(wrong_token(request.from));
    if (auto refusal = count_stranger(request.from, 1.0))
        return tl::unexpected(std::move(*refusal));
    return tl::unexpected(
        Refusal{401, "a token is needed",
                "send `Authorization: Bearer TOKEN` with the token wakesurf printed, or "
                "the key of a share link"});
}

/// By the header where there is one, else by a cookie.
std::optional<Visitor> Gate::visitor_of(const HttpRequest& request) {
    const auto authorization = request.all("authorization");
    if (!authorization.empty()) {
        const auto token = authorization.size() == 1 ? bearer(authorization.front()) : std::nullopt;
        auto identity = token ? holder_of(*token) : std::nullopt;
        return identity ? std::optional(Visitor(std::move(*identity), request.from)) : std::nullopt;
    }
    for (const std::string_view cookie :
         cookies_named(cookie_name(request, options_.port), request))
        if (const auto login = cookies_.find(cookie, request.from))
            if (auto identity = holder_of_grant(login->grant))
                return Visitor(std::move(*identity), person_of(*login));
    return std::nullopt;
}

std::optional<Refusal> Gate::count_open(const HttpRequest& request, std::size_t bytes) {
    auto refusal =
        count_stranger(request.from, 1.0 + static_cast<double>(bytes / limits::strangers_bytes));
    if (refusal && (options_.token.empty() || visitor_of(request)))
        return std::nullopt;
    return refusal;
}

std::optional<Refusal> Gate::count_stranger(const std::string& from, double count) {
    const auto wait = strangers_.wait_for(from);
    if (wait.count() == 0) {
        strangers_.take(from, count);
        return std::nullopt;
    }
    over_budget(Budgeted::Strangers);
    return Refusal{429,
                   "too many requests without a token come from this address",
                   "wait a moment, or log in first",
                   {},
                   std::chrono::ceil<std::chrono::seconds>(wait)};
}

void Gate::over_budget(Budgeted kind) const {
    if (metrics_ != nullptr)
        metrics_->over_budget(kind);
}

/// Both are looked for whichever it is, so that the time tells nothing.
std::optional<Identity> Gate::holder_of(std::string_view token) const {
    const auto shared = grants_.find(token);
    return same_digest(secret_digest(token), token_) ? Identity{} : shared;
}

std::optional<Identity> Gate::holder_of_grant(const std::string& grant) const {
    return grant.empty() ? Identity{} : grants_.identity(grant);
}

Refusal Gate::wrong_token(const std::string& from) {
    const auto wait = wrong_tokens_.wait_for(from);
    if (wait.count() > 0) {
        over_budget(Budgeted::WrongTokens);
        return {429, "too many wrong tokens have been tried from this address",
                "wait a few seconds"};
    }
    wrong_tokens_.take(from, 1.0);
    return {401, "the token is wrong, or the share link has ended",
            "use the token wakesurf printed when it was last started, or ask for a new link"};
}

tl::expected<std::string, Refusal>
Gate::login(const HttpRequest& request, std::string_view token, std::string_view path) {
    const auto identity = options_.token.empty() ? Identity{} : holder_of(token);
    if (!identity)
        return tl::unexpected(wrong_token(request.from));
    const std::string name = cookie_name(request, options_.port);
    for (const std::string_view cookie : cookies_named(name, request))
        if (const auto login = cookies_.find(cookie, request.from);
            login && login->grant == identity->grant)
            return set_cookie(request, std::string(cookie), path);
    for (const std::string_view cookie : cookies_named(name, request))
        cookies_.end(cookie); // the browser is about to forget it
    const auto made = cookies_.make(identity->grant, request.from);
    if (made)
        return set_cookie(request, *made, path);
    over_budget(Budgeted::Logins);
    constexpr std::chrono::seconds later{60};
    return tl::unexpected(
        Refusal{429, made.error().message, made.error().hint, made.error().limit, later});
}

tl::expected<Gate::LoggedOut, Refusal> Gate::logout(const HttpRequest& request,
                                                    std::string_view path) {
    if (auto refusal = check_sender(request))
        return tl::unexpected(std::move(*refusal));
    const std::string name = cookie_name(request, options_.port);
    LoggedOut out{set_cookie(request, {}, path) + "; Max-Age=0", {}};
    for (const std::string_view cookie : cookies_named(name, request))
        if (const auto login = cookies_.end(cookie))
            out.people.push_back(person_of(*login));
    return out;
}

/// Pages of other sites that show this one in a frame get no cookie that is Strict or Lax. Where they may, over TLS, it is good below the
/// page that holds the frame alone (Partitioned); what it opens is guarded by the Origin all the same.
std::string Gate::set_cookie(const HttpRequest& request,
                             const std::string& value,
                             std::string_view path) const {
    const bool secure = options_.tls || request.header("origin").starts_with("https://");
    const std::string_view site =
        options_.framed && secure ? "SameSite=None; Partitioned" : "SameSite=Strict";
    std::string out = cookie_name(request, options_.port) + "=" + value + "; HttpOnly; ";
    out.append(site).append("; Path=").append(path);
    return out + (secure ? "; Secure" : "");
}

} // namespace wakesurf::server
