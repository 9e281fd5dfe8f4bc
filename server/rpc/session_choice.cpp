#include "server/rpc/session_choice.hpp"

namespace wakesurf::server {

core::Result<std::shared_ptr<Session>> read_session(protocol::CheckedJson& in, const Call& call) {
    const std::string id = in.text_or("session", {});
    if (auto verdict = in.verdict(); !verdict)
        return tl::unexpected(verdict.error());
    if (!id.empty())
        return call.context.sessions.find(id);
    if (call.client != nullptr && call.client->session())
        return call.client->session();
    if (!call.identity.session.empty())
        return call.context.sessions.find(call.identity.session);
    return core::fail(core::Error::Code::InvalidArgument, "`session` is missing",
                      "name one from session.list, or join one on a WebSocket first");
}

} // namespace wakesurf::server
