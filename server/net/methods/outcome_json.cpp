#include "server/net/methods/outcome_json.hpp"

#include "core/base/machine_memory.hpp"
#include "protocol/api/base/list_json.hpp"
#include "protocol/api/generated/subscription.hpp"
#include "protocol/api/json_rpc.hpp"

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
    return protocol::list_json(ranges, [](const ToldRange& each) {
        nlohmann::json range = protocol::value_range_json(each.range);
        range["attribute"] = each.attribute;
        return range;
    });
}

nlohmann::json outcome_json(const SurfaceOutcome& outcome) {
    nlohmann::json out = protocol::statistics_json(outcome.statistics);
    out["peakBytes"] = core::peak_resident_memory();
    out["surface"] = outcome.surface;
    out["epoch"] = outcome.epoch;
    out["complete"] = outcome.complete;
    // A pass on the way is coarser by intent, whatever the quad limit is.
    out["coarsened"] = outcome.complete && outcome.statistics.coarsened();
    out["stateSum"] = outcome.state_sum;
    if (outcome.took)
        out["pass"] = protocol::pass_seconds_json(*outcome.took);
    if (outcome.error)
        out["error"] = error_json(*outcome.error);
    return out;
}

} // namespace wakesurf::server
