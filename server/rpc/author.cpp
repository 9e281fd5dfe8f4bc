#include "server/rpc/author.hpp"

#include "server/limits.hpp"
#include "server/rpc/permission.hpp"

#include <utility>

namespace wakesurf::server {

Author author_of(const Call& call, Session& session, std::string gesture) {
    if (call.client != nullptr)
        for (const Participant& each : session.participants().present())
            if (each.observer == call.client)
                return {each.id, each.name, std::move(gesture)};
    const std::string& grant = call.identity.grant;
    return {grant.empty() ? "script" : "script:" + grant, "a script", std::move(gesture)};
}

std::string read_gesture(protocol::CheckedJson& in) {
    if (!in.has("gesture"))
        return {};
    std::string gesture = in.text("gesture", limits::gesture_bytes);
    if (gesture.empty())
        in.fault("gesture", "must not be empty: leave it out");
    return gesture;
}

bool is_host(const Call& call, const Session& session) {
    return role_in(session.id(), call) == Role::Host;
}

} // namespace wakesurf::server
