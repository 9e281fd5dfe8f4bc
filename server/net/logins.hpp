// Logins, which browsers get for the token or the key of a share link: a text that only pages of the same
// origin can read, shown with every request. It is signed, so that valid logins need no storage, whatever
// their number: no login can displace another. Kept are the key that signs them, and those that have ended:
// with --state both survive restarts, in files readable by their owner only (0600).
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
#include <string_view>
#include <utility>

namespace wakesurf::server {

struct Login {
    std::string id;           ///< 32 hexadecimal digits; no secret without the signature
    std::int64_t made = 0;    ///< seconds since 1970
    std::int64_t renewed = 0; ///< likewise; the newest use that is known
    std::string grant;        ///< the share link; empty: the server's own token
};

/// Makes and checks logins. Loop thread only. A login ends with logout, with its token or link, a week after
/// its last renewal, or a month after it was made.
class Logins {
  public:
    /// The number of ended logins that are remembered. Beyond it the oldest of the link with the most is
    /// forgotten: only a holder of the link can cause that, and does not need the logins of its other
    /// holders.
    static constexpr std::size_t most_ended = 8192;

    /// The name of the file of ended logins.
    static constexpr const char* ended_name = "ended-logins";

    /// Receives whether a restarted server will know it.
    using Done = std::function<void(core::Result<void>)>;

    /// What becomes of a text that is written.
    enum class To : std::uint8_t { Replace, Append };

    /// Writes to the file with ended logins, at once or later, in the order of the calls.
    using Write = std::function<void(To, std::string text, Done done)>;

    /// Returns the secret of the token (empty grant) or of a share link; empty once that has ended.
    using Secrets = std::function<std::optional<SecretDigest>(const std::string& grant)>;

    /// Keeps them in memory: they end with this server. REQUIRES: the entropy outlives this.
    explicit Logins(Entropy& entropy, UnixTime unix_time = unix_seconds);

    /// Reads those of a folder; makes the key if it is missing. REQUIRES: this server has locked the folder;
    /// the entropy outlives the logins. Error: Io; Corrupt if the key is invalid or the file is another
    /// user's.
    static core::Result<Logins> open(const std::filesystem::path& folder,
                                     Entropy& entropy,
                                     Write write,
                                     UnixTime unix_time = unix_seconds);

    /// Makes a login for a token or link with this secret.
    std::string make(const std::string& grant, const SecretDigest& secret);

    /// Returns the text of the same login for another week.
    std::string renew(Login login, const SecretDigest& secret) const;

    /// Returns the login of a text; empty if it is not valid. Takes the same time for every wrong signature.
    std::optional<Login> find(std::string_view text, const Secrets& secrets) const;

    /// Ends a login, with all texts of it, and returns it if it was one. `kept` is called once a restarted
    /// server will know it.
    std::optional<Login> end(std::string_view text, const Secrets& secrets, Done kept);

    void end(const Login& login, Done kept);

    bool ended(const std::string& grant, const std::string& id) const;

  private:
    /// The ended logins of a link.
    struct Ended {
        std::map<std::string, std::int64_t> made;                ///< by id
        std::set<std::pair<std::int64_t, std::string>> by_age{}; ///< the same, the oldest first

        void forget_oldest();
    };

    Logins(Entropy& entropy, std::string key, Write write, UnixTime unix_time)
        : entropy_(entropy), key_(std::move(key)), write_(std::move(write)),
          unix_time_(std::move(unix_time)) {}

    std::string signed_text(const Login& login, const SecretDigest& secret) const;
    std::optional<Login> sound(std::string_view text, const Secrets& secrets) const;
    void read(const std::string& text);
    void add(const std::string& grant, const std::string& id, std::int64_t made);
    void forget_expired();
    void make_room();
    std::string text() const;

    Entropy& entropy_;
    std::string key_;
    Write write_; ///< null: those that have ended are not written
    UnixTime unix_time_;
    std::map<std::string, Ended> ended_; ///< by grant
    std::size_t count_ = 0;              ///< of all
    /// Lines of the file, also of logins that are forgotten. Empty: it has to be replaced as a whole, which
    /// may end in half a line, or lack what could not be written.
    std::optional<std::size_t> lines_{};
};

} // namespace wakesurf::server
