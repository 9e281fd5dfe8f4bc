#include "server/rpc/aside_json.hpp"

#include "protocol/api/json_rpc.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <span>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr std::size_t told = 50;
constexpr std::size_t most_named = 3; ///< in the sentence; all that are told are in `keptAside`

std::span<const KeptAside> newest(const Session& session, std::size_t most) {
    const std::span all(session.kept_aside());
    return all.last(std::min(most, all.size()));
}

} // namespace

json kept_aside_json(const Session& session) {
    json records = json::array();
    for (const KeptAside& each : newest(session, told))
        records.push_back(
            {{"type", each.type}, {"id", each.id}, {"why", each.why}, {"since", each.since}});
    return {{"count", session.kept_aside().size()}, {"records", std::move(records)}};
}

std::optional<std::string> kept_aside_notice(const Session& session) {
    const std::size_t count = session.newly_aside();
    if (count == 0)
        return std::nullopt;
    std::string whys;
    for (const KeptAside& each : newest(session, std::min(count, most_named)))
        whys += (whys.empty() ? "" : "; ") + each.why;
    const std::string text = fmt::format(
        "{} of this session could not be used when the server started and {} kept "
        "aside: {}{}. Nothing was deleted: `wakesurf state aside STATE_DIR` prints {} as "
        "JSON, to be corrected and set again",
        count == 1 ? "a record" : fmt::format("{} records", count), count == 1 ? "is" : "are", whys,
        count > most_named ? "; ..." : "", count == 1 ? "it" : "them");
    return protocol::rpc_notification(
        "server.notice", {{"kind", "recordsKeptAside"}, {"level", "warning"}, {"text", text}});
}

} // namespace wakesurf::server
