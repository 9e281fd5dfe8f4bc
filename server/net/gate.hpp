// Who may come in, and as whom: Host against DNS rebinding, Origin against other pages in the user's browser, and the token
// or the key of a share link. Asked before anything else happens with a request, an upgrade above all. Threat model:
// README.md here.
#pragma once

#include "core/base/clock.hpp"
#include "server/net/http_message.hpp"
#include "server/net/logins.hpp"
#include "server/service/base/entropy.hpp"
#include "server/service/base/visitor.hpp"
#include "server/service/compute/address_rates.hpp"
#include "server/service/metrics/metrics.hpp"
#include "server/service/session/people/grants.hpp"

#include <tl/expected.hpp>

#include <chrono>
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
    KeptLogins* kept = nullptr;       ///< nothing: logins end with the server
    UnixTime unix_time = unix_seconds;
};

/// Why a request was refused.
struct Refusal {
    unsigned status = 403;
    std::string message;
    std::string hint;
    std::optional<std::uint64_t> limit = {}; ///< more than that was asked for
    std::chrono::seconds retry_after{5};     ///< of 429 and 503
};

/// Loop thread only. The grants outlive it.
class Gate {
  public:
    /// @param metrics  counts refusals; may be null
    Gate(GateOptions options,
         Entropy& entropy,
         const core::Clock& clock,
         const Grants& grants,
         Metrics* metrics = nullptr);

    /// Of requests that need no token: the same Host and Origin as all others. Nothing: come in.
    std::optional<Refusal> check_open(const HttpRequest& request) const;

    /// Of the page's own files, which hold nothing secret: the same Host as all others. Browsers name an Origin for scripts and styles,
    /// and a page without them could not say why it is refused.
    std::optional<Refusal> check_file(const HttpRequest& request) const;

    /// Of /healthz: the same Origin as all others. A proxy asks under any name.
    std::optional<Refusal> check_health(const HttpRequest& request) const;

    /// Counts a request that needs no token, with an answer of so many bytes. Error: 429 where its address sends more of them than it
    /// may; who shows a token all the same is not refused.
    std::optional<Refusal> count_open(const HttpRequest& request, std::size_t bytes = 0);

    /// Who comes. Without authentication everyone is a host.
    tl::expected<Visitor, Refusal> check(const HttpRequest& request);

    /// Whether check() will let it in as a host, by its header; counts nothing.
    bool is_host(const HttpRequest& header);

    /// Whether that is still so, for answers that took their time.
    bool still(const Visitor& visitor) const;

    /// What POST /api/v1/login asks for.
    struct LoginWish {
        std::optional<std::string> token; ///< the server's, or the key of a share link
        std::optional<std::string> login; ///< that the page has
    };

    struct LoggedIn {
        std::string login;   ///< for the page to keep, and to show from now on
        std::string session; ///< the only one that it is good for; empty: every one
    };

    /// The login that the page has, for another week, where it is good, and for the same as the token if one is shown; else a new one.
    tl::expected<LoggedIn, Refusal> login(const HttpRequest& request, const LoginWish& wish);

    /// Ends the login that is shown. `kept` is called, now or later, once a server that starts again will know it; with nothing to end,
    /// at once. @returns  Visitor::person of who has gone; empty: no one
    std::string logout(const HttpRequest& request, KeptLogins::Done kept);

  private:
    std::optional<Refusal> check_host(const HttpRequest& request) const;
    std::optional<Refusal> check_origin(const HttpRequest& request) const;
    tl::expected<Visitor, Refusal> check_token(const HttpRequest& request);
    std::optional<Visitor> visitor_of(const HttpRequest& request) const;
    std::optional<Refusal> count_stranger(const std::string& from, double count);
    std::optional<Identity> holder_of(std::string_view token) const;
    std::optional<Identity> holder_of_grant(const std::string& grant) const;
    bool tunnelled(const HttpRequest& request) const;
    std::string scheme() const;
    Refusal wrong_token(const std::string& from);
    void over_budget(Budgeted kind) const;

    GateOptions options_;
    SecretDigest token_;
    std::optional<KeptLogins> own_; ///< where nothing is kept
    Logins logins_;
    const Grants& grants_;
    std::vector<std::string> hosts_;
    std::vector<std::string> origins_;
    AddressRates wrong_tokens_;
    AddressRates strangers_; ///< requests that show no token
    Metrics* metrics_;
};

/// The name in a Host header or an authority, in lower case, without the port and with the brackets of an IPv6 address;
/// nothing for what is not one.
std::optional<std::string> host_name(std::string_view authority);

/// Whether only this machine can reach the address.
bool is_loopback(std::string_view host);

} // namespace wakesurf::server
