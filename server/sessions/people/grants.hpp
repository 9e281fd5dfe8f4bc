// Share links: keys that let people into one session, in one role, until they expire or are taken back. A
// key is told once, to the client that asked for it; kept is only its digest, here and in the journal.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "protocol/api/record_text.hpp"
#include "server/base/identity.hpp"
#include "server/base/journal.hpp"
#include "server/base/loop.hpp"
#include "server/base/secret.hpp"
#include "server/base/unix_time.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Says who makes a link.
struct LinkMaker {
    std::string grant; ///< the link that the maker came by; empty: the server's own token
    std::string name;  ///< of the participant; empty: a script
};

struct Grant {
    std::string id;
    std::string session;
    Role role = Role::Viewer;
    std::optional<std::int64_t> expires = {}; ///< seconds since 1970
    std::string maker = {};                   ///< name of the participant; empty: a script
    std::vector<std::string> lineage = {};    ///< links it descends from; the last is its maker's
    std::map<std::string, Role> lowered = {}; ///< participants to whom a host gave a lesser role
    std::string copier = {}; ///< link of the maker of its session, a copy; empty: no copy

    /// Returns the role of a participant without a place: at most that of each participant it was lowered
    /// for.
    Role newcomers() const;
};

/// Returns what to append to the address of the page, with the key of a link into that session.
inline std::string link_to(const std::string& session, const std::string& key) {
    return "#session=" + session + "&token=" + key;
}

/// A client that came in by a share link and is to go when it ends.
class GrantHolder {
  public:
    virtual ~GrantHolder() = default;
    /// Must not attend or leave grants before it returns.
    virtual void grant_ended(const std::string& reason) = 0;
};

struct GrantServices {
    Loop& loop;
    const core::Clock& clock;
    Entropy& entropy;
    UnixTime wall_clock;
    Journal* journal = nullptr; ///< nothing: not kept
};

/// Loop thread only. While it runs, links expire by `clock`, which should go on while the machine sleeps:
/// setting the wall clock neither prolongs nor ends them.
class Grants {
  public:
    explicit Grants(GrantServices services);
    Grants(const Grants&) = delete;
    Grants& operator=(const Grants&) = delete;

    struct Made {
        Grant grant;
        std::string key;
    };

    /// Error: OverLimit; InvalidArgument where it would outlive the link of its maker.
    /// @param expires_in  nothing: never
    core::Result<Made> make(const std::string& session,
                            Role role,
                            std::optional<std::chrono::seconds> expires_in,
                            const LinkMaker& maker = {});

    /// Returns how long a link that `grant` makes may last; nothing: for ever.
    std::optional<std::chrono::seconds> longest_of(const std::string& grant) const;

    /// Lists those in force, oldest first.
    std::vector<Grant> of(const std::string& session) const;

    /// Makes an editor's link into a copy, for the holder of the link `by` who has made that. It ends with
    /// that link at the latest. Error: OverLimit.
    core::Result<Made> make_for_copy(const std::string& copy, const LinkMaker& by);

    /// Lists those in force into copies that holders of the link have made, or of all links where it is
    /// empty; oldest first.
    std::vector<Grant> copies(const std::string& id = {}) const;

    /// Lists those in force that were made by a link, or by one that it made, into copies as well; oldest
    /// first.
    std::vector<Grant> descendants(const std::string& id) const;

    /// Ends a link of this session, and those into copies that its holders made; with `children` all its
    /// descendants. Their holders are told. Error: NotFound.
    core::Result<void>
    revoke(const std::string& session, const std::string& id, bool children = false);

    /// Ends all links of all sessions; returns how many there were. Those of sessions in the trash as well.
    std::size_t end_all(const std::string& reason);

    /// Notes that a participant came by this link as that person: see Visitor. Not kept beyond the server's
    /// life.
    void seat(const std::string& id, const std::string& participant, const std::string& person);

    /// Lists other participants who came by the link as the same person.
    std::vector<std::string> others_of(const std::string& id, const std::string& participant) const;

    /// Returns the least role that was set for a participant who is that person; nothing: none less than the
    /// link's.
    std::optional<Role> least_of(const std::string& id, const std::string& person) const;

    /// Notes that a host has set the role of a participant who came by a link. A role less than the link's
    /// holds for all who come by the link and have no place yet, until that participant gets the link's role
    /// back. Nothing happens for links that have ended.
    void set_role(const std::string& id, const std::string& participant, Role role);

    /// Returns what a key is good for; takes the same time whichever key it is, and whether it is one.
    std::optional<Identity> find(std::string_view key) const;

    /// Returns what a link is good for now, for a client without a place; nothing once it has ended.
    std::optional<Identity> identity(const std::string& id) const;

    /// Returns the digest of its key; empty once it has ended.
    std::optional<SecretDigest> digest(const std::string& id) const;

    /// Nothing once it has ended.
    const Grant* grant(const std::string& id) const;

    /// Holders are told of the end of their link until they leave.
    void attend(const std::string& id, GrantHolder& holder);
    void leave(const std::string& id, GrantHolder& holder);

    /// A link out of the journal. One that has expired meanwhile is struck from the journal. Error: Corrupt.
    core::Result<void>
    restore(const std::string& session, const std::string& id, std::string_view record);

    /// The session is gone for good.
    void forget(const std::string& session);

    /// The session is in the trash: its links admit no participant until it is back; holders are told that
    /// theirs has ended.
    void suspend(const std::string& session);
    void resume(const std::string& session);

  private:
    using Time = std::chrono::steady_clock::time_point;

    struct Entry {
        Grant grant;
        SecretDigest digest{};
        std::optional<Time> end; ///< of `expires`
        std::uint64_t number = 0;
        std::set<GrantHolder*> holders;
        std::map<std::string, std::string> people = {}; ///< of participants, as far as is known
    };

    template <class Fits>
    std::vector<Grant> those(Fits fits) const;
    core::Result<Made>
    add(Grant link, std::optional<std::chrono::seconds> expires_in, const LinkMaker& maker);
    bool expired(const Entry& entry) const;
    bool in_force(const Entry& entry) const;
    void end(const std::string& id, const std::string& reason);
    void end_expired();
    void schedule();
    void keep(const Entry& entry);

    GrantServices services_;
    std::map<std::string, Entry> entries_;
    std::set<std::string> suspended_; ///< sessions
    std::uint64_t next_ = 1;
    std::shared_ptr<void> timer_;
};

} // namespace wakesurf::server
