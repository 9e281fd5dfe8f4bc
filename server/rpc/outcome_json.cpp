#include "server/rpc/outcome_json.hpp"

#include "core/base/machine_memory.hpp"
#include "protocol/api/json_rpc.hpp"
#include "protocol/api/statistics_json.hpp"

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

nlohmann::json pass_json(const PassSeconds& took) {
    return {{"queue", took.queue},
            {"load", took.load},
            {"compute", took.compute},
            {"encode", took.encode}};
}

nlohmann::json ranges_json(const ValueRanges& ranges) {
    nlohmann::json out = nlohmann::json::array();
    for (const auto& [attribute, range] : ranges)
        out.push_back({{"attribute", attribute},
                       {"low", range.low},
                       {"high", range.high},
                       {"least", range.least},
                       {"greatest", range.greatest}});
    return out;
}

nlohmann::json outcome_json(const SurfaceOutcome& outcome) {
    nlohmann::json out =
        protocol::statistics_json(outcome.statistics, core::peak_resident_memory());
    out["surface"] = outcome.surface;
    out["epoch"] = outcome.epoch;
    out["complete"] = outcome.complete;
    // A pass on the way is coarser by intent, whatever the quad limit is.
    out["coarsened"] = outcome.complete && outcome.statistics.coarsened();
    out["stateSum"] = outcome.state_sum;
    if (outcome.took)
        out["pass"] = pass_json(*outcome.took);
    if (outcome.error)
        out["error"] = error_json(*outcome.error);
    return out;
}

} // namespace wakesurf::server
