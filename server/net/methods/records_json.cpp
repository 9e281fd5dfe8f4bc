#include "server/net/methods/records_json.hpp"

#include "core/base/machine_memory.hpp"
#include "protocol/api/base/list_json.hpp"
#include "protocol/api/generated/subscription.hpp"
#include "protocol/api/json_rpc.hpp"
#include "server/net/methods/notifications.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

nlohmann::json error_json(const core::Error& error) {
    const protocol::RpcFault fault = protocol::fault_of(error);
    nlohmann::json out{
        {"code", static_cast<int>(fault.code)},
        {"message", fault.message},
        {"kind", fault.kind.empty() ? std::string(protocol::kind_of(fault.code)) : fault.kind},
        {"hint", fault.hint}};
    if (fault.detail)
        out.update(*fault.detail);
    return out;
}

nlohmann::json ranges_json(const ValueRanges& ranges) {
    return protocol::list_json(ranges, [](const AnnouncedRange& each) {
        nlohmann::json range = protocol::written(each.range);
        range["attribute"] = each.attribute;
        return range;
    });
}

nlohmann::json outcome_json(const SurfaceOutcome& outcome) {
    nlohmann::json out = protocol::written(outcome.statistics);
    out["peakBytes"] = core::peak_resident_memory();
    out["surface"] = outcome.surface;
    out["epoch"] = outcome.epoch;
    out["complete"] = outcome.complete;
    if (outcome.checks_pending)
        out["intervalPending"] = true;
    // A pass on the way is coarser by intent, whatever the quad limit is.
    out["coarsened"] = outcome.complete && outcome.statistics.coarsened();
    out["stateSum"] = outcome.state_sum;
    if (outcome.took)
        out["pass"] = protocol::written(*outcome.took);
    if (outcome.error)
        out["error"] = error_json(*outcome.error);
    return out;
}

using nlohmann::json;

namespace {

json put_json(std::string_view type, const std::string& id, json record) {
    return {{"op", "put"}, {"type", type}, {"id", id}, {"record", std::move(record)}};
}

template <class R>
json patch_json(const R& record) {
    const RecordKey key = key_of(record);
    return put_json(name(key.type), key.id, protocol::written(record));
}

json patch_json(const protocol::ClockRecord& record) {
    return put_json("clock", "clock", protocol::written(record));
}

json patch_json(const SessionName& session) {
    return put_json("session", session.session, session_name_json(session));
}

json patch_json(const DeletedRecord& record) {
    return {{"op", "delete"}, {"type", record.type}, {"id", record.id}};
}

json aside_json(const KeptAside& each) {
    return {{"type", each.type}, {"id", each.id}, {"why", each.why}, {"since", each.since}};
}

} // namespace

json session_name_json(const SessionName& session) {
    json out{{"session", session.session}, {"name", session.name}};
    if (!session.units.empty())
        out["units"] = protocol::units_json(session.units);
    return out;
}

json records_json(const Session& session) {
    json out = session_name_json({session.id(), session.name(), session.units()});
    out.update({{"rakes", all_json<protocol::RakeRecord>(session)},
                {"surfaces", all_json<protocol::SurfaceRecord>(session)},
                {"slices", all_json<protocol::SliceRecord>(session)},
                {"lines", all_json<protocol::LinesRecord>(session)},
                {"bookmarks", all_json<protocol::BookmarkRecord>(session)},
                {"annotations", all_json<protocol::AnnotationRecord>(session)},
                {"clock", protocol::written(session.clock().record())}});
    constexpr std::size_t told = 50;
    if (!session.kept_aside().empty())
        out["keptAside"] = {
            {"count", session.kept_aside().size()},
            {"records", protocol::list_json(newest_aside(session, told), aside_json)}};
    return out;
}

json patches_json(std::span<const Patch> patches) {
    return protocol::list_json(patches, [](const Patch& patch) {
        return std::visit([](const auto& each) { return patch_json(each); }, patch);
    });
}

} // namespace wakesurf::server
