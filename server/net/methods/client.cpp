#include "server/net/methods/client.hpp"

#include "protocol/api/json_rpc.hpp"
#include "server/base/limits.hpp"
#include "server/base/metrics.hpp"
#include "server/net/methods/notifications.hpp"
#include "server/net/methods/records_json.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <utility>
#include <vector>

namespace wakesurf::server {

void PendingCall::answer(std::string text) {
    if (const Answer send = std::exchange(answer_, nullptr))
        send(std::move(text));
}

void PendingCall::cancel() {
    if (answered())
        return;
    answer(protocol::rpc_error(id_, {protocol::RpcCode::Cancelled,
                                     "the call was cancelled by `$/cancelRequest`",
                                     "call again for an answer",
                                     {},
                                     {}}));
    cancelled_.request_stop();
    stop_.request_stop();
}

void PendingCall::abandon() {
    answer_ = nullptr;
    stop_.request_stop();
}

void PendingCalls::abandon() {
    for (const auto& [id, call] : std::exchange(calls_, {}))
        call->abandon();
}

std::shared_ptr<PendingCall> PendingCalls::open(const protocol::RpcId& id,
                                                PendingCall::Answer answer) {
    forget_answered();
    if (calls_.size() >= limits::pending_calls)
        return nullptr;
    auto call = std::make_shared<PendingCall>(id, std::move(answer));
    calls_.emplace(id, call);
    return call;
}

void PendingCalls::cancel(const protocol::RpcId& id) {
    std::vector<std::shared_ptr<PendingCall>> named;
    const auto [begin, end] = calls_.equal_range(id);
    for (auto each = begin; each != end; ++each)
        named.push_back(each->second);
    calls_.erase(begin, end);
    for (const auto& call : named)
        call->cancel();
}

std::size_t PendingCalls::size() {
    forget_answered();
    return calls_.size();
}

void PendingCalls::forget_answered() {
    std::erase_if(calls_, [](const auto& entry) { return entry.second->answered(); });
}

using nlohmann::json;

Client::Client(Wire& wire, Visitor identity, Grants& grants)
    : wire_(wire), identity_(std::move(identity)), grants_(grants) {
    if (identity_.grant.empty())
        return;
    grants_.attend(identity_.grant, *this);
    if (!grants_.identity(identity_.grant)) // ended between the gate and the handshake
        grant_ended("the share link has ended");
}

Client::~Client() {
    calls_.abandon(); // first: what is under way may want to tell this client something
    grants_.leave(identity_.grant, *this);
    part(&Session::lose);
}

void Client::subscribe(FrameCursor cursor, const std::shared_ptr<LiveSurface>& live) {
    std::erase_if(shown_, [](const auto& each) { return each.second.expired(); });
    shown_[live->number()] = live;
    wire_.follow(std::move(cursor));
}

bool Client::unsubscribe(std::uint32_t number) {
    if (!wire_.unfollow(number))
        return false;
    if (const auto live = shown_.extract(number))
        if (const auto surface = live.mapped().lock())
            surface->turned_away();
    return true;
}

core::Result<Joined> Client::join(std::shared_ptr<Session> session, Arrival arrival) {
    if (session != session_)
        leave();
    arrival.identity = identity_;
    if (const auto now = grants_.identity(identity_.grant))
        arrival.identity.role = now->role; // which a host may have lessened for newcomers
    auto joined = session->join(arrival, *this);
    if (!joined)
        return joined;
    session_ = std::move(session);
    participant_ = joined->you.id;
    grants_.seat(identity_.grant, participant_, identity_.person);
    const auto least = grants_.least_of(identity_.grant, identity_.person);
    if (least && *least < joined->you.role) { // set for another place of the same person
        session_->participants().set_role(participant_, *least);
        joined->you.role = *least;
    }
    return joined;
}

std::optional<Role> Client::role_in(const std::string& session) const {
    if (session_ && session_->id() == session)
        if (const Participant* me = session_->participants().find(*this))
            return me->role;
    return std::nullopt;
}

std::string Client::participant() const {
    const Participant* me = session_ ? session_->participants().find(*this) : nullptr;
    return me != nullptr ? me->id : std::string{};
}

void Client::leave() {
    part(&Session::leave);
}

void Client::part(void (Session::*how)(const Observer&)) {
    if (session_) {
        ((*session_).*how)(*this);
        session_->end_leases(participant_);
    }
    session_.reset();
}

FrameCursor Client::cursor(const std::string& surface,
                           const LiveSurface& live,
                           std::optional<UpdatePosition> from,
                           Metrics* metrics) {
    auto notice = [&wire = wire_, surface, number = live.number(), metrics](bool behind) {
        if (behind && metrics != nullptr)
            metrics->catching_up();
        wire.send(protocol::rpc_notification("server.notice",
                                             {{"kind", behind ? "catchingUp" : "caughtUp"},
                                              {"surface", surface},
                                              {"subscription", number}}));
    };
    auto left_out = [metrics](std::uint64_t frames) {
        if (metrics != nullptr)
            metrics->frames_dropped(frames);
    };
    return FrameCursor(live.ring(), from, std::move(notice), std::move(left_out));
}

/// @param words  returns the notification, once for all clients that are told
template <class Words>
void Client::tell(Telling& telling, Words words) {
    if (!telling.text)
        telling.text = std::make_shared<const std::string>(words());
    wire_.send_shared(telling.text);
}

void Client::patched(const std::string& session,
                     std::uint64_t seq,
                     std::span<const Patch> patches,
                     Telling& telling) {
    tell(telling, [&] {
        return protocol::rpc_notification(
            "session.patched",
            {{"session", session}, {"seq", seq}, {"patches", patches_json(patches)}});
    });
}

void Client::progress(const SurfaceProgress& progress, Telling& telling) {
    constexpr std::array names{"coarse", "refined", "final", "live"};
    tell(telling, [&] {
        return protocol::rpc_notification(
            "surface.progress", {{"surface", progress.surface},
                                 {"epoch", progress.epoch},
                                 {"phase", names[static_cast<std::size_t>(progress.phase)]},
                                 {"seconds", protocol::written(progress.took)}});
    });
}

void Client::ranges(const SurfaceRanges& ranges, Telling& telling) {
    tell(telling, [&] {
        return protocol::rpc_notification("surface.ranges",
                                          {{"surface", ranges.surface},
                                           {"epoch", ranges.epoch},
                                           {"ranges", ranges_json(ranges.ranges)}});
    });
}

void Client::done(const SurfaceOutcome& outcome, Telling& telling) {
    tell(telling, [&] {
        json parameters{{"surface", outcome.surface}, {"epoch", outcome.epoch}};
        if (outcome.error)
            parameters["error"] = error_json(*outcome.error);
        else
            parameters["stats"] = outcome_json(outcome);
        return protocol::rpc_notification("surface.done", parameters);
    });
}

void Client::presence(const std::string& message) {
    wire_.send(message);
}

void Client::sent_away(Farewell why) {
    if (why == Farewell::Removed)
        session_->end_leases(participant_);
    session_.reset();
    if (why == Farewell::Deleted) // the connection stays, for another session
        wire_.send(server::notice("sessionDeleted", "warning",
                                  "the session was deleted; a host can restore it for 30 days"));
    else if (why == Farewell::Displaced)
        say_goodbye(Goodbye::Displaced, "displaced", "a newer connection has taken this place");
    else
        say_goodbye(Goodbye::Removed, "removed", "a host removed you from this session");
}

void Client::grant_ended(const std::string& reason) {
    leave();
    say_goodbye(Goodbye::LinkEnded, "linkEnded", reason);
}

void Client::logged_out() {
    leave();
    say_goodbye(Goodbye::LoggedOut, "loggedOut", "you have logged out");
}

void Client::say_goodbye(Goodbye goodbye, const char* kind, const std::string& reason) {
    wire_.send(server::notice(kind, "warning", reason));
    wire_.close(goodbye, reason);
}

} // namespace wakesurf::server
