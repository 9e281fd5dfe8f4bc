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
    json held = json::array();
    for (const core::StepHeld& step : status.steps) {
        steps.push_back(name_of(step.state()));
        held.push_back(json::array({step.resident, step.loading}));
    }
    return {{"dataset", dataset},      {"steps", std::move(steps)},
            {"held", std::move(held)}, {"bytesPerStep", status.step_bytes},
            {"bytes", status.bytes},   {"budget", status.budget}};
}

json cache_changes_json(const std::string& dataset,
                        const std::vector<core::StepHeld>& before,
                        const core::TimeStepCache::Status& status) {
    json changes = json::array();
    json held = json::array();
    for (std::size_t i = 0; i < status.steps.size(); ++i) {
        const core::StepHeld& now = status.steps[i];
        if (i >= before.size() || before[i].state() != now.state())
            changes.push_back(json::array({i, name_of(now.state())}));
        if (i >= before.size() || before[i] != now)
            held.push_back(json::array({i, now.resident, now.loading}));
    }
    return {{"dataset", dataset},
            {"changes", std::move(changes)},
            {"held", std::move(held)},
            {"bytes", status.bytes},
            {"budget", status.budget}};
}

} // namespace wakesurf::server
