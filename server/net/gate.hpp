// Authentication and authorization: Host against DNS rebinding, Origin against other pages in the user's
// browser, and the token or the key of a share link. Every request passes it first, upgrades included. Threat
// model: README.md here.
#pragma once

#include "core/base/clock.hpp"
#include "server/base/identity.hpp"
#include "server/base/metrics.hpp"
#include "server/base/secret.hpp"
#include "server/live/compute/budgets.hpp"
#include "server/net/http_message.hpp"
#include "server/net/logins.hpp"
#include "server/sessions/people/grants.hpp"

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

struct GateOptions {
    std::string token; ///< empty: no authentication (loopback only)
    std::string host;  ///< as listened on
    std::uint16_t port = 0;
    std::vector<std::string> origins; ///< further ones, exact: https://viewer.example
    bool tls = false;                 ///< the server's own origins are https
    Logins* logins = nullptr;         ///< null: logins end with the server
    UnixTime unix_time = unix_seconds;
};

/// Checks requests; an answer is why one is refused. Loop thread only. REQUIRES: the grants outlive this.
class Gate {
  public:
    /// @param metrics  counts refusals; may be null
    Gate(GateOptions options,
         Entropy& entropy,
         const core::Clock& clock,
         const Grants& grants,
         Metrics* metrics = nullptr);

    /// Checks requests that need no token: the same Host and Origin as all others. Empty: admitted.
    std::optional<HttpResponse> check_open(const HttpRequest& request) const;

    /// Checks requests for the page's own files, which hold no secret. Browsers name an Origin for scripts and
    /// styles, and a page without them could not say why it is refused.
    std::optional<HttpResponse> check_host(const HttpRequest& request) const;

    /// Checks requests for /healthz: a proxy asks under any name.
    std::optional<HttpResponse> check_origin(const HttpRequest& request) const;

    /// Counts a request that needs no token, with an answer of so many bytes. Error: 429 if its address sends
    /// more of them than it may; a client that shows a token all the same is not refused.
    std::optional<HttpResponse> count_open(const HttpRequest& request, std::size_t bytes = 0);

    /// Authenticates a request. Without authentication every client is a host.
    tl::expected<Visitor, HttpResponse> check(const HttpRequest& request);

    /// Says whether check() will admit a host, by the request's header; counts nothing.
    bool is_host(const HttpRequest& header);

    /// Says whether a visitor would still be admitted, for answers that took a while.
    bool still(const Visitor& visitor) const;

    /// Holds the parameters of POST /api/v1/login.
    struct LoginWish {
        std::optional<std::string> token; ///< the server's, or the key of a share link
        std::optional<std::string> login; ///< that the page has
    };

    struct LoggedIn {
        std::string login; ///< for the page to store and to show from now on
        Identity holder;   ///< what it allows
    };

    /// Renews the page's login for a week if it is valid, and for the same as the token if one is shown; else
    /// makes a new one.
    tl::expected<LoggedIn, HttpResponse> login(const HttpRequest& request, const LoginWish& wish);

    /// Ends the login that is shown. `kept` is called, now or later, once a restarted server will know it;
    /// without a login, at once. @returns  Visitor::person of the login; empty: none
    std::string logout(const HttpRequest& request, Logins::Done kept);

  private:
    tl::expected<Visitor, HttpResponse> check_token(const HttpRequest& request);
    std::optional<Visitor> visitor_of(const HttpRequest& request) const;
    std::optional<HttpResponse> count_stranger(const std::string& from, double count);
    std::optional<Identity> holder_of(std::string_view token) const;
    std::optional<Identity> holder_of_grant(const std::string& grant) const;
    bool tunnelled(const HttpRequest& request) const;
    std::string scheme() const;
    HttpResponse wrong_token(const std::string& from);
    void over_budget(Budgeted kind) const;

    GateOptions options_;
    SecretDigest token_;
    std::optional<Logins> own_; ///< used without a state folder
    Logins& logins_;
    const Grants& grants_;
    Logins::Secrets secrets_;
    std::vector<std::string> hosts_;
    std::vector<std::string> origins_;
    AddressRates wrong_tokens_;
    AddressRates strangers_; ///< of requests that show no token
    Metrics* metrics_;
};

/// Returns the name in a Host header or an authority, in lower case, without the port and with the brackets
/// of an IPv6 address; empty if it is invalid.
std::optional<std::string> host_name(std::string_view authority);

/// Says whether only this machine can reach the address.
bool is_loopback(std::string_view host);

} // namespace wakesurf::server
