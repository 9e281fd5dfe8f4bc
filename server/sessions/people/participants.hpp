// The participants of a session: name, colour, role and presence. A lost connection is shown for ten
// seconds more, so that a quick return is no news; with its resume token it keeps its membership for a
// week, also beyond the end of the server.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/messages_presence.hpp"
#include "server/base/identity.hpp"
#include "server/base/journal.hpp"
#include "server/base/loop.hpp"
#include "server/base/secret.hpp"
#include "server/base/unix_time.hpp"
#include "server/sessions/people/presence_events.hpp"
#include "server/sessions/records/observer.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Returns `name`, or `name 2`, `name 3`, ...: the first that is not `taken`; at most `longest` bytes.
std::string free_name(const std::string& name,
                      std::size_t longest,
                      const std::function<bool(const std::string&)>& taken);

struct Participant {
    std::string id;
    std::string name;
    std::string colour;
    Role role = Role::Viewer;
    std::string grant;     ///< the share link it came by; empty: the server's own token
    bool role_set = false; ///< by a host, and so not the link's
    SecretDigest token{};  ///< of its resume token
    /// Belongs to the token before, from an earlier life of the server, as long as the answer with the new
    /// one may have been lost.
    std::optional<SecretDigest> former;
    bool restored = false;        ///< not come back to since the server started
    Observer* observer = nullptr; ///< nothing: its connection is lost
    protocol::Presence presence;
};

/// Holds what a newcomer asks for.
struct Arrival {
    std::string name;         ///< empty: one is found
    std::string colour;       ///< #rrggbb; empty: one is found
    std::string resume_token; ///< of an earlier stay, or empty
    Identity identity;
};

struct Joined {
    Participant you;
    std::string resume_token;
    bool returned = false; ///< to a place of an earlier stay
    /// True if what the client saw came from this server since it started: it can go on from there. Else
    /// its token is another one now.
    bool same_life = false;
};

/// Loop thread only. Observers leave before they end; the loop outlives the participants.
class Participants {
  public:
    Participants(std::string session,
                 Loop& loop,
                 Entropy& entropy,
                 Journal* journal = nullptr,
                 UnixTime unix_time = unix_seconds);
    Participants(const Participants&) = delete;
    Participants& operator=(const Participants&) = delete;

    /// With the token of an earlier stay the participant gets that place again; a connection that still
    /// holds it is sent away. Error: OverLimit.
    core::Result<Joined> join(const Arrival& arrival, Observer& observer);

    /// Says goodbye: the others are told at once.
    void leave(const Observer& observer);

    /// Notes that the connection is lost: the participant is shown for a while longer.
    void lose(const Observer& observer);

    /// Sets new presence, and tells the others. Does nothing where the participant is not in here.
    void update(const Observer& observer, const protocol::PresenceUpdate& update);

    /// Sets the role of a participant, which stays with the membership. REQUIRES: find(id).
    void set_role(const std::string& id, Role role);

    /// Sends a participant away for good and ends the membership. REQUIRES: find(id).
    void remove(const std::string& id);

    /// Ends a deleted session: all participants are sent away, and nothing is kept any more.
    void end();

    /// Returns the places as the journal has them.
    std::vector<JournalEntry> entries() const;

    /// Restores a place from the journal. One that was not come back to for too long is struck from it.
    /// Error: Corrupt.
    core::Result<void> restore(const std::string& id, std::string_view record);

    /// Lists those connected.
    const std::vector<Participant>& present() const { return present_; }

    /// Returns null where the participant is not connected here.
    const Participant* find(const Observer& observer) const;

    /// Finds a participant who is here, or may come back. Error: NotFound.
    core::Result<Participant> find(const std::string& id) const;

    /// Lists them as others see them: those lost a moment ago, then those connected; who came last comes
    /// last.
    std::vector<protocol::ParticipantRecord> shown() const;

  private:
    struct Absent {
        Participant place;
        std::int64_t left;           ///< seconds since 1970
        std::shared_ptr<void> shown; ///< runs while it is shown; nothing: not shown any more
    };

    Participant take_place(const SecretDigest& token);
    std::string renew_token(Participant& place, const SecretDigest& shown);
    std::optional<Participant> take_out(const Observer& observer);
    bool taken(const std::string& name) const;
    std::string free_colour() const;
    Participant* known(const std::string& id);
    const Participant* visible(const std::string& id) const;
    void put_away(Participant place, std::int64_t left, bool show);
    void hide(const std::string& id);
    void trim();
    void forget(std::deque<Absent>::iterator going);
    std::size_t tell(const PresenceEvents::Batch& batch) const;
    static JournalEntry entry_of(const Participant& place, std::optional<std::int64_t> left);
    void keep(const Participant& place, std::optional<std::int64_t> left = {});
    void strike(const Participant& place);

    std::string session_;
    Loop& loop_;
    Entropy& entropy_;
    Journal* journal_;
    UnixTime unix_time_;
    std::vector<Participant> present_;
    std::deque<Absent> absent_; ///< who left last comes last
    std::size_t next_ = 1;
    PresenceEvents events_;
};

} // namespace wakesurf::server
