#include "server/rpc/cache_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

using nlohmann::json;

namespace {

const char* name_of(core::StepState state) {
    switch (state) {
    case core::StepState::Resident:
        return "resident";
    case core::StepState::Loading:
        return "loading";
    case core::StepState::Cold:
        break;
    }
    return "cold";
}

} // namespace

json cache_json(const std::string& dataset, const core::TimeStepCache::Status& status) {
    json steps = json::array();
    for (const core::StepState state : status.steps)
        steps.push_back(name_of(state));
    return {{"dataset", dataset},
            {"steps", std::move(steps)},
            {"bytes", status.bytes},
            {"budget", status.budget}};
}

json cache_changes_json(const std::string& dataset,
                        const std::vector<core::StepState>& before,
                        const core::TimeStepCache::Status& status) {
    json changes = json::array();
    for (std::size_t i = 0; i < status.steps.size(); ++i)
        if (i >= before.size() || before[i] != status.steps[i])
            changes.push_back(json::array({i, name_of(status.steps[i])}));
    return {{"dataset", dataset},
            {"changes", std::move(changes)},
            {"bytes", status.bytes},
            {"budget", status.budget}};
}

} // namespace wakesurf::server
