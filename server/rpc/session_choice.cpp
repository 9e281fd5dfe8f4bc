#include "server/rpc/session_choice.hpp"

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

core::Result<std::shared_ptr<Session>> choose_session(const Call& call,
                                                      const std::optional<std::string>& named) {
    auto session = chosen(call, named);
    if (session)
        (*session)->attendance().seen();
    return session;
}

} // namespace wakesurf::server
