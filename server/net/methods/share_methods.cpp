// session.share, session.shares, session.unshare, session.setRole, session.kick: who may be in a session, and
// as what. For its hosts.
#include "protocol/api/base/list_json.hpp"
#include "protocol/api/generated/share.hpp"
#include "server/base/limits.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/method.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

json grant_json(const Grant& grant, const Grants& grants) {
    json made_by{{"name", grant.maker}};
    if (!grant.lineage.empty())
        made_by["grant"] = grant.lineage.back();
    json out{{"grant", grant.id},
             {"role", name(grant.role)},
             {"madeBy", std::move(made_by)},
             {"children", grants.descendants(grant.id).size()}};
    if (!grant.copier.empty())
        out["copy"] = grant.session;
    if (grant.expires)
        out["expires"] = *grant.expires;
    if (grant.newcomers() != grant.role)
        out["newcomers"] = name(grant.newcomers());
    return out;
}

json grants_json(const std::vector<Grant>& list, const Grants& grants) {
    return protocol::list_json(list, [&](const Grant& each) { return grant_json(each, grants); });
}

/// Returns nothing for never. Null says so on purpose; left out it is a week, or as long as the maker's own
/// link.
std::optional<std::chrono::seconds> lifetime(const protocol::SessionShare& of, const Call& call) {
    using std::chrono::seconds;
    if (of.expires_in.value)
        return seconds(*of.expires_in.value);
    if (of.expires_in.given)
        return std::nullopt;
    const seconds week(limits::grant_seconds_default);
    return std::min(week, call.context.grants.longest_of(call.identity.grant).value_or(week));
}

void session_share(const Call& call, const protocol::SessionShare& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    const auto made = call.context.grants.make((*session)->id(), *role_named(of.role),
                                               lifetime(of, call), maker_of(call, **session));
    if (!made)
        return reply.fault(made.error());
    (*session)->made_on_purpose();
    json out = grant_json(made->grant, call.context.grants);
    out["key"] = made->key;
    out["link"] = link_to((*session)->id(), made->key);
    reply.result(out);
}

void session_shares(const Call& call, const protocol::SessionShares& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    const Grants& grants = call.context.grants;
    reply.result({{"shares", grants_json(grants.of((*session)->id()), grants)}});
}

void session_unshare(const Call& call, const protocol::SessionUnshare& of, Reply reply) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return reply.fault(session.error());
    Grants& grants = call.context.grants;
    if (const auto done = grants.revoke((*session)->id(), of.grant, of.children); !done)
        return reply.fault(done.error());
    reply.result({{"children", grants_json(grants.descendants(of.grant), grants)}});
}

/// Returns an error where a caller by a link would act on a participant with the server's own token.
std::optional<protocol::RpcFault> out_of_hand(const Participant& place, const Identity& by) {
    if (by.grant.empty() || !place.grant.empty())
        return std::nullopt;
    return protocol::RpcFault{protocol::RpcCode::NotPermitted,
                              "the participant came with the server's own token, and you by a link",
                              "ask someone with the server's token",
                              {},
                              {}};
}

/// Returns the session, where the participant is one whom the caller may do something to.
template <class Parameters>
tl::expected<std::shared_ptr<Session>, protocol::RpcFault> session_of(const Parameters& of,
                                                                      const Call& call) {
    const auto session = choose_session(call, of.session);
    if (!session)
        return tl::unexpected(protocol::fault_of(session.error()));
    const auto place = (*session)->participants().find(of.participant);
    if (!place)
        return tl::unexpected(protocol::fault_of(place.error()));
    if (const auto fault = out_of_hand(*place, call.identity))
        return tl::unexpected(*fault);
    return *session;
}

void session_set_role(const Call& call, const protocol::SessionSetRole& to, Reply reply) {
    const std::string& id = to.participant;
    const Role role = *role_named(to.role);
    const auto session = session_of(to, call);
    if (!session)
        return reply.fault(session.error());
    Participants& people = (*session)->participants();
    Grants& grants = call.context.grants;
    const Participant place = *people.find(id);
    people.set_role(id, role);
    grants.set_role(place.grant, id, role);
    json out{{"participant", id}, {"role", name(role)}, {"also", json::array()}};
    const Grant* const link = grants.grant(place.grant);
    if (link != nullptr && role < link->role)
        for (const std::string& other : grants.others_of(place.grant, id))
            if (people.find(other)) {
                people.set_role(other, role);
                out["also"].push_back(other);
            }
    if (link != nullptr && link->newcomers() != link->role)
        out["newcomers"] = name(link->newcomers());
    reply.result(out);
}

void session_kick(const Call& call, const protocol::SessionKick& of, Reply reply) {
    const auto session = session_of(of, call);
    if (!session)
        return reply.fault(session.error());
    (*session)->participants().remove(of.participant);
    reply.result(json::object());
}

} // namespace

std::vector<Method> share_methods() {
    return {method(session_share), method(session_shares), method(session_unshare),
            method(session_set_role), method(session_kick)};
}

} // namespace wakesurf::server
