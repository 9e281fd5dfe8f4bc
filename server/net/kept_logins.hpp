// What of logins outlives the server, in the folder of --state: the key that their cookies are signed with, and which of them have
// ended. Both files are only for their owner (0600).
#pragma once

#include "core/base/result.hpp"
#include "server/base/entropy.hpp"
#include "server/base/unix_time.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace wakesurf::server {

/// Loop thread only.
class KeptLogins {
  public:
    /// So many that have ended are remembered one by one.
    static constexpr std::size_t most_ended = 1024;

    /// Makes the key where there is none. REQUIRES: this server holds the folder. Error: Io; Corrupt, the key is not one.
    static core::Result<KeptLogins>
    open(const std::filesystem::path& folder, Entropy& entropy, UnixTime unix_time = unix_seconds);

    const std::string& key() const { return key_; }

    bool ended(const std::string& grant, const std::string& id, std::int64_t made) const;

    /// It has ended, also for servers to come. Writes at most 80 kB and does not wait for the disk: a power cut may undo it. Where too
    /// many have ended, all logins of the link with the most ended ones are over at the next start.
    void end(const std::string& grant, const std::string& id, std::int64_t made);

  private:
    struct Ended {
        std::map<std::string, std::int64_t> made; ///< by id
        std::int64_t before = -1;                 ///< all that were made until then
    };

    KeptLogins(std::filesystem::path folder, std::string key, UnixTime unix_time)
        : folder_(std::move(folder)), key_(std::move(key)), unix_time_(std::move(unix_time)) {}

    void read();
    void forget_expired();
    void make_room();
    void write() const;

    std::filesystem::path folder_;
    std::string key_;
    UnixTime unix_time_;
    std::map<std::string, Ended> ended_; ///< by grant
};

} // namespace wakesurf::server
