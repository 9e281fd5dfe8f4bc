#include "server/net/methods/dataset_entry.hpp"

#include "protocol/api/base/point_json.hpp"
#include "server/net/methods/outcome_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

nlohmann::json dataset_entry(const DatasetStatus& status) {
    nlohmann::json out{{"dataset", status.dataset},
                       {"name", status.name},
                       {"state", dataset_state_names.at(static_cast<std::size_t>(status.state))},
                       {"steps", {{"ready", status.steps_ready}, {"total", status.steps_total}}}};
    if (!status.values.empty())
        out["values"] = status.values;
    if (!status.families.empty())
        out["families"] = status.families;
    if (status.state == DatasetState::Importing) {
        out["progress"] = status.progress;
        if (status.remaining)
            out["remaining"] = *status.remaining;
    }
    if (!status.velocities.empty())
        out["velocities"] = status.velocities;
    if (status.error)
        out["error"] = error_json(*status.error);
    return out;
}

nlohmann::json lattice_json(const protocol::Lattice& lattice) {
    return {{"origin", protocol::point_json(lattice.origin)},
            {"step", lattice.step},
            {"bits", lattice.bits}};
}

} // namespace wakesurf::server
