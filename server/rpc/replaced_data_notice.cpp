#include "server/rpc/replaced_data_notice.hpp"

#include "protocol/api/json_rpc.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

std::string notice_of(const std::string& text) {
    return protocol::rpc_notification(
        "server.notice", {{"kind", "dataReplaced"}, {"level", "warning"}, {"text", text}});
}

} // namespace

std::string replaced_data_notice(const std::set<std::string>& names) {
    return notice_of(
        fmt::format("the data of {} have been replaced: its surfaces are computed again "
                    "from the new data",
                    fmt::join(names, ", ")));
}

std::string replaced_data_meanwhile_notice(const std::set<std::string>& names) {
    return notice_of(
        fmt::format("the data of {} have been replaced since this session was last used: "
                    "its surfaces are computed from the new data",
                    fmt::join(names, ", ")));
}

} // namespace wakesurf::server
