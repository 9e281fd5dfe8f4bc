// session.share, session.shares, session.unshare, session.setRole, session.kick: who may be in a session, and as what. For its
// hosts.
#include "protocol/checked_json.hpp"
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

json grant_json(const Grant& grant) {
    json out{{"grant", grant.id}, {"role", name(grant.role)}};
    if (grant.expires)
        out["expires"] = *grant.expires;
    return out;
}

void share(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const Role role = read_role(in);
    const auto seconds = in.count_if("expiresIn", 1, limits::grant_seconds);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    const auto expires_in = seconds ? std::optional(std::chrono::seconds(*seconds)) : std::nullopt;
    const auto made = call.context.grants.make((*session)->id(), role, expires_in);
    if (!made)
        return reply.fault(made.error());
    (*session)->made_on_purpose();
    json out = grant_json(made->grant);
    out["key"] = made->key;
    out["link"] = "#session=" + (*session)->id() + "&token=" + made->key;
    reply.result(out);
}

void shares(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    json list = json::array();
    for (const Grant& each : call.context.grants.of((*session)->id()))
        list.push_back(grant_json(each));
    reply.result({{"shares", std::move(list)}});
}

void unshare(const Call& call, Reply reply) {
    protocol::CheckedJson in(call.parameters);
    const std::string grant = in.text("grant");
    const auto session = read_session(in, call);
    if (!session)
        return reply.fault(session.error());
    if (const auto done = call.context.grants.revoke((*session)->id(), grant); !done)
        return reply.fault(done.error());
    reply.result(json::object());
}

/// Whoever has the server's own token is not at the mercy of those who came by a link.
std::optional<protocol::RpcFault> out_of_hand(const Participant& place, const Identity& by) {
    if (by.grant.empty() || !place.grant.empty())
        return std::nullopt;
    return protocol::RpcFault{protocol::RpcCode::NotPermitted,
                              "the participant came with the server's own token, and you by a link",
                              "ask somebody with the server's token",
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
    (*session)->participants().set_role(id, role);
    reply.result({{"participant", id}, {"role", name(role)}});
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
           fmt::format(R"({{"type":"integer","minimum":1,"maximum":{}}})", limits::grant_seconds),
           false, "seconds from now; left out: until it is taken back"}},
         "{grant, key, role, expires?, link}: expires in seconds since 1970, link goes behind the "
         "page's address",
         any_host,
         share},
        {"session.shares",
         "The links into this session that are in force, without their keys.",
         {session_parameter()},
         "{shares: [{grant, role, expires?}]}",
         host,
         shares},
        {"session.unshare",
         "Takes a link back; whoever came by it is disconnected.",
         {session_parameter(), {"grant", text, true, "an id from session.shares"}},
         "{}",
         any_host,
         unshare},
        {"session.setRole",
         "Sets what a participant may do here, from its next message on.",
         {session_parameter(), participant, role},
         "{participant, role}",
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
