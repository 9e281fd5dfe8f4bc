// presence.update.
#include "protocol/api/messages_presence.hpp"
#include "server/net/methods/caller.hpp"
#include "server/net/methods/method.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

void presence_update(const Call& call, const protocol::PresenceUpdate& update, Reply reply) {
    const auto session = choose_session(call, update.session);
    if (!session)
        return reply.fault(session.error());
    if (call.client->session() != *session)
        return reply.fault(core::Error{core::Error::Code::InvalidArgument,
                                       "presence can only be sent to the session you joined",
                                       "join it first"});
    (*session)->participants().update(*call.client, update);
    reply.result(nlohmann::json::object());
}

} // namespace

std::vector<Method> presence_methods() {
    return {method(presence_update)};
}

} // namespace wakesurf::server
