#include "server/net/methods/dataset_answers.hpp"

#include "protocol/api/base/json_text.hpp"
#include "protocol/api/dataset_json.hpp"
#include "server/data/surface_fields.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/notifications.hpp"
#include "server/net/methods/records_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>
#include <utility>

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
    if (!status.means.empty())
        out["means"] = status.means;
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
    return {{"origin", protocol::written(lattice.origin)},
            {"step", lattice.step},
            {"bits", lattice.bits}};
}

namespace {

/// All of a dataset but its times, which are many.
std::string words_of(core::DatasetInfo info) {
    info.times.clear();
    return protocol::json_text(protocol::written(info));
}

nlohmann::json description_json(const OpenDataset& open) {
    nlohmann::json out = protocol::written(open.info);
    out["lattice"] = lattice_json(open.lattice);
    out["smooth"] = open.flow->has_smooth();
    out["surfaceFields"] = field_names(open);
    if (!open.scalars)
        return out;
    for (const core::FamilyRecord& each : open.scalars->families())
        out["families"].push_back(protocol::written(each));
    for (const core::MeanRecord& each : open.scalars->means())
        out["means"].push_back(protocol::written(each));
    return out;
}

/// Writes text at once: as values, those of 100,000 time-steps take a tenth of a second.
std::string steps_text(const std::vector<core::StepHeld>& steps) {
    std::string names, held;
    const auto comma = [](const std::string& text) { return text.empty() ? "" : ","; };
    for (const core::StepHeld& step : steps) {
        fmt::format_to(std::back_inserter(names), "{}\"{}\"", comma(names), name_of(step.state()));
        fmt::format_to(std::back_inserter(held), "{}[{},{}]", comma(held), step.resident,
                       step.loading);
    }
    return fmt::format("\"steps\":[{}],\"held\":[{}]", names, held);
}

} // namespace

const std::string& DatasetAnswers::description(const std::string& dataset,
                                               const OpenDataset& open) {
    Described& made = described_[dataset];
    std::string words = words_of(open.info);
    if (made.text.empty() || made.flow.lock() != open.flow || made.scalars.lock() != open.scalars ||
        made.times != open.info.times || made.words != words)
        made = {open.flow, open.scalars, open.info.times, std::move(words),
                protocol::json_text(description_json(open))};
    return made.text;
}

std::string DatasetAnswers::cache(const std::string& dataset,
                                  const core::TimeStepCache::Status& status) {
    Steps& made = steps_[dataset];
    if (made.text.empty() || made.steps != status.steps)
        made = {status.steps, steps_text(status.steps)};
    return fmt::format("{{\"dataset\":{},{},\"bytesPerStep\":{},\"bytes\":{},\"budget\":{}}}",
                       protocol::json_text(dataset), made.text, status.step_bytes, status.bytes,
                       status.budget);
}

std::shared_ptr<DatasetAnswers> new_dataset_answers() {
    return std::make_shared<DatasetAnswers>();
}

} // namespace wakesurf::server
