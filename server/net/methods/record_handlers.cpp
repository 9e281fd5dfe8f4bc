#include "server/net/methods/record_handlers.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

void reply_with_seq(Reply reply, const Session& session) {
    reply.result({{"seq", session.seq()}});
}

std::optional<protocol::RpcFault> stale_revision(std::optional<std::uint64_t> expected,
                                                 std::uint64_t rev,
                                                 const nlohmann::json& record) {
    if (!expected || *expected == rev)
        return std::nullopt;
    return protocol::RpcFault{
        protocol::RpcCode::Stale,
        "the record is at revision " + std::to_string(rev) + ", not " + std::to_string(*expected),
        "apply the edit to data.current and send it again",
        {},
        std::make_shared<const nlohmann::json>(nlohmann::json{{"current", record}})};
}

} // namespace wakesurf::server
