#include "server/net/methods/caller.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace wakesurf::server {

using protocol::RpcCode;
using protocol::RpcFault;

namespace {

RpcFault not_permitted(std::string message, std::string hint) {
    return {RpcCode::NotPermitted, std::move(message), std::move(hint), {}, {}};
}

} // namespace

std::string session_of(const Method& method, const Call& call) {
    if (!method.takes("session"))
        return {};
    if (const auto named = call.parameters.find("session");
        named != call.parameters.end() && named->is_string() && *named != "")
        return named->get<std::string>();
    if (call.client != nullptr && call.client->session())
        return call.client->session()->id();
    return call.identity.session;
}

Role role_in(const std::string& session, const Call& call) {
    if (const auto place = call.client != nullptr ? call.client->role_in(session) : std::nullopt)
        return *place;
    const auto now = call.context.grants.identity(call.identity.grant);
    return call.identity.grant.empty() ? call.identity.role : now ? now->role : Role::Viewer;
}

Role role_of(const Call& call) {
    if (const std::string& came_by = call.identity.copier; !came_by.empty()) {
        const auto link = call.context.grants.identity(came_by);
        return link ? link->role : Role::Viewer;
    }
    const bool joined = call.client != nullptr && call.client->session();
    return role_in(joined ? call.client->session()->id() : call.identity.session, call);
}

std::optional<RpcFault> refused(const Method& method, const Call& call) {
    const Identity& identity = call.identity;
    if (!identity.grant.empty() && !call.context.grants.identity(identity.grant))
        return RpcFault{
            RpcCode::Unauthenticated, "the share link has ended", "ask for a new one", {}, {}};
    if (!identity.session.empty() && method.traits.whole_server)
        return not_permitted("a share link is not enough for " + method.name,
                             "use the token wakesurf printed when it was started");
    const std::string session = session_of(method, call);
    if (!identity.session.empty() && !session.empty() && session != identity.session)
        return not_permitted("the share link is for another session",
                             "use `" + identity.session + "`, or ask for a link to this one");
    const Role role = method.traits.shared ? role_of(call) : role_in(session, call);
    const bool own_copy = method.traits.copier && is_copier_of(session, identity);
    if (role < method.traits.least && !own_copy)
        return not_permitted(
            method.name + " needs the role " + std::string(name(method.traits.least)) +
                ", and you are " + std::string(name(role)),
            "ask a host of the session to make you " + std::string(name(method.traits.least)));
    return std::nullopt;
}

namespace {

core::Result<std::shared_ptr<Session>> chosen(const Call& call,
                                              const std::optional<std::string>& named) {
    if (named && !named->empty())
        return call.context.sessions.find(*named);
    if (call.client != nullptr && call.client->session())
        return call.client->session();
    if (!call.identity.session.empty())
        return call.context.sessions.find(call.identity.session);
    return core::fail(core::Error::Code::InvalidArgument, "`session` is missing",
                      "name one from `session.list`, or join one on a WebSocket first");
}

} // namespace

Author author_of(const Call& call, Session& session, std::optional<std::string> gesture) {
    if (call.client != nullptr)
        for (const Participant& each : session.participants().present())
            if (each.observer == call.client)
                return {each.id, each.name, gesture.value_or("")};
    const std::string& grant = call.identity.grant;
    return {grant.empty() ? "script" : "script:" + grant, "a script", gesture.value_or("")};
}

LinkMaker maker_of(const Call& call, Session& session) {
    const Participant* const me =
        call.client != nullptr ? session.participants().find(*call.client) : nullptr;
    return {call.identity.grant, me != nullptr ? me->name : std::string()};
}

bool is_host(const Call& call, const Session& session) {
    return role_in(session.id(), call) == Role::Host;
}

core::Result<std::shared_ptr<Session>> choose_session(const Call& call,
                                                      const std::optional<std::string>& named) {
    auto session = chosen(call, named);
    if (session)
        (*session)->attendance().seen();
    return session;
}

} // namespace wakesurf::server
