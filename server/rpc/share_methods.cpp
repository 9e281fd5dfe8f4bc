// session.share, session.shares, session.unshare, session.setRole, session.kick: who may be in a session, and as what. For its
// hosts.
#include "protocol/api/checked_json.hpp"
#include "server/limits.hpp"
#include "server/rpc/method_table.hpp"
#include "server/rpc/session_choice.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

Role read_role(protocol::CheckedJson& in) {
    const auto role = role_named(in.text("role"));
    if (!role)
        in.fault("role", "must be viewer, editor or host");
    return role.value_or(Role::Viewer);
}

json grant_json(const Grant& grant, const Grants& grants) {
    json made_by{{"name", grant.maker}};
    if (!grant.lineage.empty())
        made_by["grant"] = grant.lineage.back();
    json out{{"grant", grant.id},
             {"role", name(grant.role)},
             {"madeBy", std::move(made_by)},
             {"children", grants.descendants(grant.session, grant.id).size()}};
    if (grant.expires)
        out["expires"] = *grant.expires;
    if (grant.newcomers() != grant.role)
        out["newcomers"] = name(grant.newcomers());
    return out;
}

json grants_json(const std::vector<Grant>& list, const Grants& grants) {
    json out = json::array();
    for (const Grant& each : list)
        out.push_back(grant_json(each, grants));
    return out;
}

/// Nothing: never. Null says so on purpose; left out it is a week, or as long as the maker's own link.
std::optional<std::chrono::seconds> read_expiry(protocol::CheckedJson& in, const Call& call) {
    using std::chrono::seconds;
    const auto given = in.count_if("expiresIn", 1, limits::grant_seconds);
    if (given)
        return seconds(*given);
    if (call.parameters.contains("expiresIn"))
        return std::nullopt;
    const seconds week(limits::grant_seconds_default);
    return std::min(week, call.context.grants.longest_of(call.identity.grant).value_or(week));
}

/// In words for people: the name in this session, where the caller is in it.
std::string name_of(const Call& call, Session& session) {
    const Participant* const me =
        call.client != nullptr ? session.participants().find(*call.client) : nullptr;
    return me != nullptr ? me->name : std::string();
}

void share(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const Role role = read_role(in);
    const auto expires_in = read_expiry(in, call);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    const auto made = call.context.grants.make((*session)->id(), role, expires_in,
                                               {call.identity.grant, name_of(call, **session)});
    if (!made)
        return reply.fault(made.error());
    (*session)->made_on_purpose();
    json out = grant_json(made->grant, call.context.grants);
    out["key"] = made->key;
    out["link"] = "#session=" + (*session)->id() + "&token=" + made->key;
    reply.result(out);
}

void shares(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    const Grants& grants = call.context.grants;
    reply.result({{"shares", grants_json(grants.of((*session)->id()), grants)}});
}

void unshare(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string grant = in.text("grant");
    const bool children = in.flag_or("children", false);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    Grants& grants = call.context.grants;
    if (const auto done = grants.revoke((*session)->id(), grant, children); !done)
        return reply.fault(done.error());
    reply.result({{"children", grants_json(grants.descendants((*session)->id(), grant), grants)}});
}

/// Whoever has the server's own token is not at the mercy of those who came by a link.
std::optional<protocol::RpcFault> out_of_hand(const Participant& place, const Identity& by) {
    if (by.grant.empty() || !place.grant.empty())
        return std::nullopt;
    return protocol::RpcFault{protocol::RpcCode::NotPermitted,
                              "the participant came with the server's own token, and you by a link",
                              "ask someone with the server's token",
                              {},
                              {}};
}

/// Reads `session`, where the participant is one whom the caller may do something to.
tl::expected<std::shared_ptr<Session>, protocol::RpcFault>
read_session_of(const std::string& participant, protocol::CheckedJson& in, const Call& call) {
    const auto session = read_session(in, call);
    if (!session)
        return tl::unexpected(protocol::fault_of(session.error()));
    const auto place = (*session)->participants().find(participant);
    if (!place)
        return tl::unexpected(protocol::fault_of(place.error()));
    if (const auto fault = out_of_hand(*place, call.identity))
        return tl::unexpected(*fault);
    return *session;
}

void set_role(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string id = in.text("participant");
    const Role role = read_role(in);
    const auto session = read_session_of(id, in, call);
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

void kick(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string id = in.text("participant");
    const auto session = read_session_of(id, in, call);
    if (!session)
        return reply.fault(session.error());
    (*session)->participants().remove(id);
    reply.result(json::object());
}

} // namespace

std::vector<Method> share_methods() {
    const char* text = R"({"type":"string"})";
    const Parameter role{"role", R"({"enum":["viewer","editor","host"]})", true,
                         "viewers look, editors edit, hosts also say who may be here"};
    const Parameter participant{"participant", text, true, "an id from session.state"};
    constexpr MethodTraits host{Role::Host};
    return {
        {"session.share",
         "Makes a link that lets people into this session, in a role, until it expires or is "
         "taken back. The key is told this once.",
         {session_parameter(),
          role,
          {"expiresIn",
           fmt::format(R"({{"type":["integer","null"],"minimum":1,"maximum":{}}})",
                       limits::grant_seconds),
           false,
           "seconds from now; left out: 7 days, or as long as the link you came by; null: until it "
           "is taken back"}},
         "{grant, key, role, expires?, madeBy: {grant?, name}, children, link}: expires in seconds "
         "since 1970, link goes behind the page's address",
         any_host,
         share},
        {"session.shares",
         "The links into this session that are in force, without their keys.",
         {session_parameter()},
         "{shares: [{grant, role, expires?, newcomers?, madeBy: {grant?, name}, children}]}",
         host,
         shares},
        {"session.unshare",
         "Takes a link back; all who came by it are disconnected. Links that were made by it stay, "
         "unless `children` says otherwise.",
         {session_parameter(),
          {"grant", text, true, "an id from session.shares"},
          {"children", R"({"type":"boolean","default":false})", false,
           "also those made by it, and by those it made"}},
         "{children}: the links made by it that are still in force, as in session.shares",
         any_host,
         unshare},
        {"session.setRole",
         "Sets what a participant may do here, from its next message on. A lesser role than that "
         "of the link they came by also holds for their other places, for calls without a place, "
         "and for all others who come by that link from now on.",
         {session_parameter(), participant, role},
         "{participant, role, also, newcomers?}: also are the other places of that person, "
         "newcomers is the role of who comes by that link from now on",
         any_host,
         set_role},
        {"session.kick",
         "Disconnects a participant, whose place is lost. A link it came by stays good: take that "
         "back as well.",
         {session_parameter(), participant},
         "{}",
         any_host,
         kick},
    };
}

} // namespace wakesurf::server
