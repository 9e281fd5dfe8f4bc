#include "server/rpc/durability_notice.hpp"

#include "protocol/api/json_rpc.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

std::string durability_notice(const core::Result<void>& turn) {
    const std::string text = turn ? "edits are kept again, and so are all made meanwhile"
                                  : "edits are not kept for now: " + turn.error().message;
    return protocol::rpc_notification("server.notice",
                                      {{"kind", turn ? "durableAgain" : "notDurable"},
                                       {"level", turn ? "info" : "warning"},
                                       {"text", text}});
}

} // namespace wakesurf::server
