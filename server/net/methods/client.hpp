// One WebSocket client: the session it has joined and the notifications that follow from that, the surfaces
// it has subscribed to. When it goes, nothing of it stays.
#pragma once

#include "server/base/visitor.hpp"
#include "server/net/methods/pending_calls.hpp"
#include "server/net/methods/wire.hpp"
#include "server/sessions/people/grants.hpp"
#include "server/sessions/records/observer.hpp"
#include "server/sessions/session.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace wakesurf::server {

/// Loop thread only.
class Client final : public Observer, public GrantHolder {
  public:
    /// `identity` is what the connection was let in with. The grants outlive the client.
    Client(Wire& wire, Visitor identity, Grants& grants);

    ~Client() override;
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    const Visitor& identity() const { return identity_; }

    /// Returns the role of its place in a session; nothing where it has none.
    std::optional<Role> role_in(const std::string& session) const;

    /// Returns its id in the session joined, or empty.
    std::string participant() const;

    /// Returns the session joined, or nothing.
    const std::shared_ptr<Session>& session() const { return session_; }

    /// Leaves the session joined before; arrives with the client's own identity. Error: OverLimit.
    core::Result<Joined> join(std::shared_ptr<Session> session, Arrival arrival);
    void leave();

    /// Says where a subscription to `surface` begins: after the state the client has from before, or with a
    /// keyframe.
    /// @param metrics  counts what is left out; may be null, else outlives the subscription
    FrameCursor cursor(const std::string& surface,
                       const LiveSurface& live,
                       std::optional<UpdatePosition> from,
                       Metrics* metrics);

    /// Says whether there is room for a further subscription.
    bool may_subscribe(std::uint32_t number) const { return wire_.may_follow(number); }

    /// Sends the updates of a surface, from where the cursor stands. REQUIRES: may_subscribe.
    void subscribe(FrameCursor cursor, const std::shared_ptr<LiveSurface>& live);

    /// The client does not show the surface any more. False when there was no such subscription.
    bool unsubscribe(std::uint32_t number);

    /// Does as Wire::acknowledge.
    bool acknowledge(std::uint32_t number, std::optional<std::uint32_t> epoch, std::uint32_t seq) {
        return wire_.acknowledge(number, epoch, seq);
    }

    /// Returns those not answered yet.
    PendingCalls& calls() { return calls_; }

    /// Sends a notification that belongs to no session.
    void notify(const std::string& message) { wire_.send(message); }

    void patched(const std::string& session,
                 std::uint64_t seq,
                 std::span<const Patch> patches,
                 Telling& telling) override;
    void progress(const SurfaceProgress& progress, Telling& telling) override;
    void ranges(const SurfaceRanges& ranges, Telling& telling) override;
    void done(const SurfaceOutcome& outcome, Telling& telling) override;
    void presence(const std::string& message) override;
    void sent_away(Farewell why) override;
    void grant_ended(const std::string& reason) override;
    void logged_out();

  private:
    template <class Words>
    void tell(Telling& telling, Words words);
    void part(void (Session::*how)(const Observer&));
    void say_goodbye(Goodbye goodbye, const char* kind, const std::string& reason);

    Wire& wire_;
    Visitor identity_;
    Grants& grants_;
    PendingCalls calls_;
    std::shared_ptr<Session> session_;
    std::string participant_;                                   ///< of that session
    std::map<std::uint32_t, std::weak_ptr<LiveSurface>> shown_; ///< by number
};

} // namespace wakesurf::server
