#include "server/rpc/author.hpp"

namespace wakesurf::server {

Author author_of(const Call& call, Session& session) {
    if (call.client != nullptr)
        for (const Participant& each : session.participants().present())
            if (each.observer == call.client)
                return {each.id, each.name};
    const std::string& grant = call.identity.grant;
    return {grant.empty() ? "script" : "script:" + grant, "a script"};
}

bool is_host(const Call& call, const Session& session) {
    const Role role =
        call.client != nullptr ? call.client->role_in(session.id()) : call.identity.role;
    return role == Role::Host;
}

} // namespace wakesurf::server
