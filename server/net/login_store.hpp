// The state of logins: the key that they are signed with, and those that have ended. With --state both
// survive restarts, in files readable by their owner only (0600).
#pragma once

#include "core/base/result.hpp"
#include "server/base/secret.hpp"
#include "server/base/unix_time.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace wakesurf::server {

/// Keeps logins. Loop thread only.
class LoginStore {
  public:
    /// The number of ended logins that are remembered. Beyond it the oldest of the link with the most is
    /// forgotten: only a holder of the link can cause that, and does not need the logins of its other
    /// holders.
    static constexpr std::size_t most_ended = 8192;

    /// Receives whether a restarted server will know it.
    using Done = std::function<void(core::Result<void>)>;

    /// What becomes of a text that is written.
    enum class To : std::uint8_t { Replace, Append };

    /// Writes to the file with ended logins, at once or later, in the order of the calls.
    using Write = std::function<void(To, std::string text, Done done)>;

    /// Keeps them in memory: they end with this server.
    explicit LoginStore(Entropy& entropy, UnixTime unix_time = unix_seconds);

    /// Reads those of a folder; makes the key if it is missing. REQUIRES: this server has locked the folder.
    /// Error: Io; Corrupt if the key is invalid or the file is another user's.
    static core::Result<LoginStore> open(const std::filesystem::path& folder,
                                         Entropy& entropy,
                                         Write write,
                                         UnixTime unix_time = unix_seconds);

    /// The name of the file of ended logins.
    static constexpr const char* ended_name = "ended-logins";

    const std::string& key() const { return key_; }

    bool ended(const std::string& grant, const std::string& id) const;

    /// Ends a login. @param made  its time, in s since 1970: a month later the entry is obsolete
    void end(const std::string& grant, const std::string& id, std::int64_t made, Done done);

  private:
    /// The ended logins of a link.
    struct Ended {
        std::map<std::string, std::int64_t> made;                ///< by id
        std::set<std::pair<std::int64_t, std::string>> by_age{}; ///< the same, the oldest first

        void forget_oldest();
    };

    LoginStore(std::string key, Write write, UnixTime unix_time)
        : key_(std::move(key)), write_(std::move(write)), unix_time_(std::move(unix_time)) {}

    void read(const std::string& text);
    void add(const std::string& grant, const std::string& id, std::int64_t made);
    void forget_expired();
    void make_room();
    std::string text() const;

    std::string key_;
    Write write_; ///< null: they are not written
    UnixTime unix_time_;
    std::map<std::string, Ended> ended_; ///< by grant
    std::size_t count_ = 0;              ///< of all
    /// Lines of the file, also of logins that are forgotten. Empty: it has to be replaced as a whole, which
    /// may end in half a line, or lack what could not be written.
    std::optional<std::size_t> lines_{};
};

} // namespace wakesurf::server
