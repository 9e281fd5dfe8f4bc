#include "server/rpc/client.hpp"

#include "protocol/json_rpc.hpp"
#include "server/rpc/outcome_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json patch_json(const protocol::RakeRecord& record) {
    return {{"op", "put"},
            {"type", "rake"},
            {"id", record.rake},
            {"record", protocol::rake_json(record)}};
}

json patch_json(const protocol::SurfaceRecord& record) {
    return {{"op", "put"},
            {"type", "surface"},
            {"id", record.surface},
            {"record", protocol::surface_json(record)}};
}

json patch_json(const protocol::BookmarkRecord& record) {
    return {{"op", "put"},
            {"type", "bookmark"},
            {"id", record.bookmark},
            {"record", protocol::bookmark_json(record)}};
}

json patch_json(const protocol::AnnotationRecord& record) {
    return {{"op", "put"},
            {"type", "annotation"},
            {"id", record.annotation},
            {"record", protocol::annotation_json(record)}};
}

json patch_json(const DeletedRecord& record) {
    return {{"op", "delete"}, {"type", record.type}, {"id", record.id}};
}

} // namespace

Client::Client(Wire& wire, Identity identity, Grants& grants)
    : wire_(wire), identity_(std::move(identity)), grants_(grants) {
    if (identity_.grant.empty())
        return;
    grants_.attend(identity_.grant, *this);
    if (!grants_.identity(identity_.grant)) // ended between the gate and the handshake
        grant_ended("the share link has ended");
}

Client::~Client() {
    grants_.leave(*this);
    for (const auto& [number, surface] : subscriptions_)
        if (const auto live = surface.lock())
            live->unsubscribe(*this);
    leave();
}

core::Result<Participant>
Client::join(std::shared_ptr<Session> session, std::string name, const std::string& resume_token) {
    if (session != session_)
        leave();
    auto place = session->participants().join(std::move(name), resume_token, *this);
    if (place) {
        session_ = std::move(session);
        participant_ = place->id;
    }
    return place;
}

Role Client::role_in(const std::string&) const {
    return identity_.role;
}

std::string Client::participant() const {
    if (session_)
        for (const Participant& each : session_->participants().present())
            if (each.observer == this)
                return each.id;
    return {};
}

void Client::leave() {
    if (session_) {
        session_->participants().leave(*this);
        session_->end_leases(participant_);
    }
    session_.reset();
}

void Client::subscribe(const std::shared_ptr<LiveSurface>& surface) {
    surface->subscribe(*this);
    subscriptions_[surface->number()] = surface;
    if (const auto state = surface->state())
        wire_.send(surface->number(), state);
}

bool Client::unsubscribe(std::uint32_t number) {
    const auto found = subscriptions_.find(number);
    if (found == subscriptions_.end())
        return false;
    if (const auto live = found->second.lock())
        live->unsubscribe(*this);
    subscriptions_.erase(found);
    wire_.drop_frames(number, ~std::uint32_t{0});
    return true;
}

void Client::patched(const std::string& session,
                     std::uint64_t seq,
                     std::span<const Patch> patches) {
    json list = json::array();
    for (const Patch& patch : patches)
        list.push_back(std::visit([](const auto& each) { return patch_json(each); }, patch));
    wire_.send(protocol::rpc_notification(
        "session.patched", {{"session", session}, {"seq", seq}, {"patches", std::move(list)}}));
}

void Client::progress(const std::string& surface, std::uint32_t epoch, bool final) {
    wire_.send(protocol::rpc_notification(
        "surface.progress",
        {{"surface", surface}, {"epoch", epoch}, {"phase", final ? "final" : "coarse"}}));
}

void Client::done(const SurfaceOutcome& outcome) {
    json parameters{{"surface", outcome.surface}, {"epoch", outcome.epoch}};
    if (outcome.error)
        parameters["error"] = error_json(*outcome.error);
    else
        parameters["stats"] = outcome_json(outcome);
    wire_.send(protocol::rpc_notification("surface.done", parameters));
}

void Client::frames(std::uint32_t number, const std::shared_ptr<const SurfaceState>& state) {
    wire_.send(number, state);
}

void Client::superseded(std::uint32_t number, std::uint32_t epoch) {
    wire_.drop_frames(number, epoch);
}

void Client::grant_ended(const std::string& reason) {
    wire_.close(Goodbye::LinkEnded, reason);
}

} // namespace wakesurf::server
