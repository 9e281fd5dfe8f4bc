// One WebSocket client: the session it has joined and the notifications that follow from that, the surfaces
// it has subscribed to. When it goes, nothing of it stays.
#pragma once

#include "protocol/api/json_rpc.hpp"
#include "server/base/identity.hpp"
#include "server/live/frame_cursor.hpp"
#include "server/sessions/people/grants.hpp"
#include "server/sessions/records/observer.hpp"
#include "server/sessions/session.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace wakesurf::server {

/// Why a connection ends, as the code of its close frame. Coming back by oneself would not help.
enum class Goodbye : std::uint16_t {
    Displaced = 4001, ///< a newer connection has taken its participant's place
    Removed = 4002,   ///< a host sent the participant away
    LinkEnded = 4003, ///< the share link expired or was taken back
    LoggedOut = 4004  ///< the browser it came from has logged out
};

/// Loop thread only. Nothing here blocks or calls back.
class Wire {
  public:
    virtual ~Wire() = default;
    virtual void send(std::string message) = 0;

    /// Sends the same text to many.
    virtual void send_shared(const std::shared_ptr<const std::string>& message) { send(*message); }

    /// Says whether a further surface may be followed.
    virtual bool may_follow(std::uint32_t surface) = 0;

    /// Sends a surface's updates from where the cursor stands, until unfollow() or the ring's end; one cursor
    /// a surface.
    virtual void follow(FrameCursor cursor) = 0;

    /// False when the surface was not followed.
    virtual bool unfollow(std::uint32_t surface) = 0;

    /// Is told that the client has folded update `seq`; without an epoch, of the newest. False when the
    /// surface is not followed.
    virtual bool
    acknowledge(std::uint32_t surface, std::optional<std::uint32_t> epoch, std::uint32_t seq) = 0;

    /// Ends the connection soon; `reason` has at most 120 bytes. The client is gone after this call has
    /// returned.
    virtual void close(Goodbye goodbye, const std::string& reason) = 0;
};

/// Loop thread only.
class PendingCall {
  public:
    using Answer = std::function<void(std::string)>;

    PendingCall(protocol::RpcId id, Answer answer)
        : id_(std::move(id)), answer_(std::move(answer)) {}

    /// The first answer counts.
    void answer(std::string text);

    /// Answers with -32800 and stops the work; nothing once there is an answer.
    void cancel();

    /// Stops the work, whose answer no client can receive any more.
    void abandon();

    std::stop_token stop() const { return stop_.get_token(); }

    /// Fires before stop() does, and only where the caller asked for it.
    std::stop_token cancelled() const { return cancelled_.get_token(); }

    bool answered() const { return answer_ == nullptr; }

  private:
    protocol::RpcId id_;
    Answer answer_;
    std::stop_source stop_;
    std::stop_source cancelled_;
};

/// The calls of one WebSocket that are not answered yet, so that `$/cancelRequest` can name one: it is answered as cancelled at once, its
/// work is asked to stop, and what the work still answers goes nowhere.
/// Loop thread only.
class PendingCalls {
  public:
    PendingCalls() = default;

    ~PendingCalls() { abandon(); }

    PendingCalls(const PendingCalls&) = delete;
    PendingCalls& operator=(const PendingCalls&) = delete;

    /// Nothing when as many are open as may be. Two with one id are cancelled together.
    std::shared_ptr<PendingCall> open(const protocol::RpcId& id, PendingCall::Answer answer);

    /// An id that is not open is ignored: its answer may be on the way.
    void cancel(const protocol::RpcId& id);

    /// Stops the work of all; none is answered.
    void abandon();

    std::size_t size();

  private:
    void forget_answered();

    std::multimap<protocol::RpcId, std::shared_ptr<PendingCall>> calls_;
};

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
