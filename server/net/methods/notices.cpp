#include "server/net/methods/notices.hpp"

#include "protocol/api/json_rpc.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

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

/// Bounds how many records a sentence names; `keptAside` of session.join has more.
constexpr std::size_t most_named = 3;

} // namespace

std::string notice(std::string_view kind, std::string_view level, const std::string& text) {
    return protocol::rpc_notification("server.notice",
                                      {{"kind", kind}, {"level", level}, {"text", text}});
}

std::string durability_notice(const core::Result<void>& turn) {
    if (turn)
        return notice("durableAgain", "info",
                      "edits are kept again, and so are all made meanwhile");
    return notice("notDurable", "warning", "edits are not kept for now: " + turn.error().message);
}

core::Error withheld(unsigned died) {
    return {core::Error::Code::Cancelled, reason(died), cure};
}

std::string careful_notice(unsigned died) {
    return notice("carefulStart", "warning", reason(died) + ": " + cure);
}

std::string replaced_data_notice(const std::set<std::string>& names) {
    return notice("dataReplaced", "warning",
                  fmt::format("the data of {} have been replaced: its surfaces are computed again "
                              "from the new data",
                              fmt::join(names, ", ")));
}

std::string replaced_data_meanwhile_notice(const std::set<std::string>& names) {
    return notice("dataReplaced", "warning",
                  fmt::format("the data of {} have been replaced since this session was last used: "
                              "its surfaces are computed from the new data",
                              fmt::join(names, ", ")));
}

std::span<const KeptAside> newest_aside(const Session& session, std::size_t most) {
    const std::span all(session.kept_aside());
    return all.last(std::min(most, all.size()));
}

std::optional<std::string> kept_aside_notice(const Session& session) {
    const std::size_t count = session.newly_aside();
    if (count == 0)
        return std::nullopt;
    std::string whys;
    for (const KeptAside& each : newest_aside(session, std::min(count, most_named)))
        whys += (whys.empty() ? "" : "; ") + each.why;
    return notice(
        "recordsKeptAside", "warning",
        fmt::format(
            "{} of this session could not be used when the server started and {} kept "
            "aside: {}{}. Nothing was deleted: `wakesurf state aside STATE_DIR` prints {} as "
            "JSON, to be corrected and set again",
            count == 1 ? "a record" : fmt::format("{} records", count), count == 1 ? "is" : "are",
            whys, count > most_named ? "; ..." : "", count == 1 ? "it" : "them"));
}

} // namespace wakesurf::server
