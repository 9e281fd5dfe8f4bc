// Who may come in: Host against DNS rebinding, Origin against other pages in the user's browser, and the token.
// Asked before anything else happens with a request, an upgrade above all. Threat model: README.md here.
#pragma once

#include "core/base/clock.hpp"
#include "server/net/http_message.hpp"
#include "server/session/entropy.hpp"

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
};

/// Why a request was refused.
struct Refusal {
    unsigned status = 403;
    std::string message;
    std::string hint;
};

/// Loop thread only.
class Gate {
  public:
    Gate(GateOptions options, Entropy& entropy, const core::Clock& clock);

    /// Nothing: come in. `open_to_all` requests need no token, but the same Host and Origin as all others.
    std::optional<Refusal> check(const HttpRequest& request, bool open_to_all);

    /// Whoever shows the token gets `cookie`, the value of Set-Cookie.
    std::optional<Refusal> login(std::string_view token, std::string& cookie);

  private:
    std::optional<Refusal> check_host(const HttpRequest& request) const;
    std::optional<Refusal> check_origin(const HttpRequest& request) const;
    std::optional<Refusal> check_token(const HttpRequest& request);
    Refusal wrong_token();

    GateOptions options_;
    std::string cookie_;
    const core::Clock& clock_;
    std::vector<std::string> hosts_;
    std::vector<std::string> origins_;
    double wrong_tokens_left_;
    std::chrono::steady_clock::time_point counted_at_;
};

/// Compares in a time that depends on the lengths only.
bool same_secret(std::string_view a, std::string_view b);

/// The name in a Host header or an authority, in lower case, without the port and with the brackets of an IPv6 address;
/// nothing for what is not one.
std::optional<std::string> host_name(std::string_view authority);

/// Whether only this machine can reach the address.
bool is_loopback(std::string_view host);

} // namespace wakesurf::server
