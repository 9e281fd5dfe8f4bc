// What one person, one share link and all together may use of the server: the quotas of session/budgets, of logins and of links.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace wakesurf::server::limits {

/// What somebody may use at a time, and how fast, over all WebSockets and HTTP requests.
struct Budget {
    std::size_t sockets;   ///< WebSockets
    std::size_t requests;  ///< HTTP requests let in and not answered yet
    std::size_t downloads; ///< asked for and not written yet
    std::size_t probes;    ///< running
    std::size_t waits;     ///< calls that wait for a surface or an import
    double edits;          ///< a second; twice as many at once
    double calls;          ///< the same
    double messages;       ///< the same; what comes faster is read later. A KiB counts for one more
};

inline constexpr Budget person{64, 64, 8, 4, 32, 200.0, 2000.0, 4000.0}; ///< by one link
inline constexpr Budget link{512, 256, 16, 8, 48, 600.0, 6000.0, 6000.0};
inline constexpr Budget token{2048, 1024, 64, 32, 1024, 2000.0, 20000.0, 40000.0};
/// Of everybody. Rates are those of each link and of the token.
inline constexpr Budget all{2048, 1024, 64, 32, 1024, 0.0, 0.0, 0.0};
/// The part of all that only the server's token opens.
inline constexpr Budget for_hosts{128, 256, 8, 4, 64, 0.0, 0.0, 0.0};

// Logins by cookie.
inline constexpr std::size_t logins = 16384;           ///< the last 1024 are for the server's token
inline constexpr std::size_t logins_of_one = 1024;     ///< of the token, of a share link
inline constexpr std::size_t logins_from_one = 256;    ///< of those of a link, from one address
inline constexpr std::chrono::seconds login_proof{10}; ///< for a new login to come back once
inline constexpr std::chrono::seconds login_idle{7 * 24 * 3600};
inline constexpr std::chrono::seconds login_most{30 * 24 * 3600};

// Share links.
inline constexpr std::uint64_t grant_seconds_default = std::uint64_t{7} * 24 * 3600;
inline constexpr std::size_t grant_depth = 8; ///< links made by links
inline constexpr std::size_t lowered = 64;    ///< participants of a link with a lesser role
inline constexpr std::size_t seated = 4096;   ///< participants of a link whose person is known

} // namespace wakesurf::server::limits
