#include "server/net/methods/caller.hpp"

#include "server/net/methods/permission.hpp"

#include <utility>

namespace wakesurf::server {

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
