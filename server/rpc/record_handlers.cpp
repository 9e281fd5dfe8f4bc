#include "server/rpc/record_handlers.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

void reply_with_seq(Reply reply, const Session& session) {
    reply.result({{"seq", session.seq()}});
}

void list_records(const Call& call,
                  const std::optional<std::string>& named,
                  Reply reply,
                  const char* name,
                  nlohmann::json (*all)(const Session& session)) {
    const auto session = choose_session(call, named);
    if (!session)
        return reply.fault(session.error());
    reply.result({{name, all(**session)}});
}

} // namespace wakesurf::server
