// What one server grants of sessions as a whole, beside limits.hpp: how many it keeps, and what goes out and in of one at a time.
#pragma once

#include <chrono>
#include <cstddef>

namespace wakesurf::server::limits {

inline constexpr std::size_t kept_sessions = 1024;
inline constexpr std::size_t trash = 256;                         ///< deleted sessions
inline constexpr std::chrono::seconds trash_kept{30 * 24 * 3600}; ///< then they are gone for good
inline constexpr std::size_t thumbnail_bytes = std::size_t{24} << 10;

// Session files.
inline constexpr std::size_t session_file_bytes = std::size_t{24} << 20;
inline constexpr std::chrono::seconds session_file_time{120}; ///< for one to come in
inline constexpr std::size_t session_imports = 2;             ///< read at a time
inline constexpr std::size_t session_message_bytes =
    std::size_t{256} << 10; ///< of records that session.export answers with

} // namespace wakesurf::server::limits
