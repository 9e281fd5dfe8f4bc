// What of logins a server has to know: the key that they are signed with, and which of them have ended. With --state both outlive it, in
// files for their owner only (0600).
#pragma once

#include "core/base/result.hpp"
#include "server/service/base/entropy.hpp"
#include "server/service/base/unix_time.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace wakesurf::server {

/// Loop thread only.
class KeptLogins {
  public:
    /// So many that have ended are remembered. Then, of the link with the most, the one that was made first is forgotten: whoever
    /// brings that about has the link, and needs no login of others who have it.
    static constexpr std::size_t most_ended = 8192;

    /// Told whether a server that starts again will know it.
    using Done = std::function<void(core::Result<void>)>;

    /// Puts the text of the file with ended logins onto the disk, at once or later. Where several wait, the newest says all.
    using Write = std::function<void(std::string text, Done done)>;

    /// They end with this server.
    explicit KeptLogins(Entropy& entropy, UnixTime unix_time = unix_seconds);

    /// Those of a folder; makes the key where there is none. REQUIRES: this server holds the folder. Error: Io; Corrupt, the key is not
    /// one, or somebody else's file.
    static core::Result<KeptLogins> open(const std::filesystem::path& folder,
                                         Entropy& entropy,
                                         Write write,
                                         UnixTime unix_time = unix_seconds);

    /// Of the file, in the folder.
    static constexpr const char* ended_name = "ended-logins";

    const std::string& key() const { return key_; }

    bool ended(const std::string& grant, const std::string& id) const;

    /// It has ended. @param made  when it was made: a month later no one asks
    void end(const std::string& grant, const std::string& id, std::int64_t made, Done done);

  private:
    using Ended = std::map<std::string, std::int64_t>; ///< when made, by id

    KeptLogins(std::string key, Write write, UnixTime unix_time)
        : key_(std::move(key)), write_(std::move(write)), unix_time_(std::move(unix_time)) {}

    void read(const std::string& text);
    void forget_expired();
    void make_room();
    std::string text() const;

    std::string key_;
    Write write_; ///< nothing: not kept
    UnixTime unix_time_;
    std::map<std::string, Ended> ended_; ///< by grant
};

} // namespace wakesurf::server
