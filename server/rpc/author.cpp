#include "server/rpc/author.hpp"

#include "server/rpc/permission.hpp"

#include <utility>

namespace wakesurf::server {

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

} // namespace wakesurf::server
