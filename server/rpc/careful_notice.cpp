#include "server/rpc/careful_notice.hpp"

#include "protocol/api/json_rpc.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

constexpr const char* cure =
    "a surface is computed again when it is edited or its rake is moved, or by Compute it on the "
    "page; begin with those that need little; the server's log and its memory may tell why it died";

std::string reason(unsigned died) {
    return fmt::format(
        "the server died {} times in a row shortly after it had started, so existing "
        "surfaces are not rebuilt automatically",
        died);
}

} // namespace

core::Error withheld(unsigned died) {
    return {core::Error::Code::Cancelled, reason(died), cure};
}

std::string careful_notice(unsigned died) {
    return protocol::rpc_notification(
        "server.notice",
        {{"kind", "carefulStart"}, {"level", "warning"}, {"text", reason(died) + ": " + cure}});
}

} // namespace wakesurf::server
