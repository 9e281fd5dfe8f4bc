// Who may come in, and as whom: Host against DNS rebinding, Origin against other pages in the user's browser, and the token
// or the key of a share link. Asked before anything else happens with a request, an upgrade above all. Threat model:
// README.md here.
#pragma once

#include "core/base/clock.hpp"
#include "server/base/entropy.hpp"
#include "server/base/visitor.hpp"
#include "server/compute/address_rates.hpp"
#include "server/metrics/metrics.hpp"
#include "server/net/http_message.hpp"
#include "server/net/login_cookies.hpp"
#include "server/session/people/grants.hpp"

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
    bool tls = false;                 ///< the server's own origins are https, its cookie Secure
    KeptLogins* kept = nullptr;       ///< nothing: logins end with the server
    UnixTime unix_time = unix_seconds;
    bool framed = false; ///< pages of other sites may show this one in a frame
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

    /// A client that shows the token or the key of a share link gets the value of Set-Cookie: the cookie that came with the request
    /// if it is good for the same, else a new one, and the one that came ends.
    /// @param path  of the page, as the browser has it: behind a proxy with a prefix, the cookie is for that alone
    tl::expected<std::string, Refusal>
    login(const HttpRequest& request, std::string_view token, std::string_view path = "/");

    struct LoggedOut {
        std::string cookie;              ///< value of Set-Cookie: the browser forgets it
        std::vector<std::string> people; ///< Visitor::person of the logins that have ended
    };

    /// Ends the logins whose cookies came with the request.
    tl::expected<LoggedOut, Refusal> logout(const HttpRequest& request,
                                            std::string_view path = "/");

  private:
    std::optional<Refusal> check_host(const HttpRequest& request) const;
    std::optional<Refusal> check_origin(const HttpRequest& request) const;
    tl::expected<Visitor, Refusal> check_token(const HttpRequest& request);
    std::optional<Visitor> visitor_of(const HttpRequest& request);
    std::optional<Refusal> count_stranger(const std::string& from, double count);
    std::optional<Identity> holder_of(std::string_view token) const;
    std::optional<Identity> holder_of_grant(const std::string& grant) const;
    bool tunnelled(const HttpRequest& request) const;
    std::string scheme() const;
    std::optional<Refusal> check_sender(const HttpRequest& request) const;
    std::string
    set_cookie(const HttpRequest& request, const std::string& value, std::string_view path) const;
    Refusal wrong_token(const std::string& from);
    void over_budget(Budgeted kind) const;

    GateOptions options_;
    SecretDigest token_;
    LoginCookies cookies_;
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

/// Whether it can be the Path of a cookie: it begins and ends with a slash and holds nothing that a cookie's attribute may not.
bool is_cookie_path(std::string_view path);

/// Whether only this machine can reach the address.
bool is_loopback(std::string_view host);

} // namespace wakesurf::server
