#include "tests/support/server/edit_ledger.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace wakesurf::tests {

using nlohmann::json;

namespace {

constexpr std::size_t few = 4;
constexpr std::size_t many = 12;

} // namespace

EditLedger::Edit EditLedger::note(std::string method, json parameters, Sent sent) {
    const std::size_t number = next_++;
    if (!sent.id.empty()) {
        Record& record = records_[sent.type][sent.id];
        record.edits[number] = sent.mark;
        record.going = record.going || !sent.mark;
    }
    sent_[number] = std::move(sent);
    return {number, std::move(method), std::move(parameters)};
}

EditLedger::Edit EditLedger::set(const std::string& type, const std::string& id) {
    const double here = static_cast<double>(random_() % 1000) / 200;
    json parameters = type == "rake"
                          ? json{{"kind", "line"},
                                 {"points", {{here, -1, 0}, {here, 1, 0.5}}},
                                 {"seeds", 4},
                                 {"name", "edit " + std::to_string(next_)}}
                          : json{{"rake", anchor_}, {"kind", "stream"}, {"dataset", "lamb-oseen"},
                                 {"from", 0},       {"to", 1},          {"maxQuads", 1000 + next_}};
    if (!id.empty())
        parameters[type] = id;
    parameters["session"] = "main";
    const Mark mark =
        type == "rake" ? parameters["name"].get<std::string>() : std::to_string(1000 + next_);
    return note(type + ".set", std::move(parameters), {type, id, mark});
}

EditLedger::Edit EditLedger::erase(const std::string& id) {
    return note("rake.delete", {{"session", "main"}, {"rake", id}}, {"rake", id, std::nullopt});
}

/// Returns a rake to edit; empty if there is none.
std::string EditLedger::choose() {
    std::vector<std::string> alive;
    for (const auto& [id, record] : records_["rake"])
        if (!record.going)
            alive.push_back(id);
    return alive.empty() ? "" : alive[random_() % alive.size()];
}

EditLedger::Edit EditLedger::next() {
    const std::string rake = choose();
    const std::size_t rakes = records_["rake"].size();
    const auto& surfaces = records_["surface"];
    const std::uint64_t dice = random_() % 10;
    if (rakes < few || (dice == 0 && rakes < many))
        return set("rake", {});
    if (dice == 1 && rake != anchor_)
        return erase(rake);
    if (dice <= 3 && !anchor_.empty())
        return set("surface", surfaces.size() < 2 ? "" : surfaces.begin()->first);
    return set("rake", rake);
}

void EditLedger::answered(std::size_t number, const json& message) {
    const Sent sent = sent_.at(number);
    sent_.erase(number);
    if (!message.contains("result")) {
        if (!sent.id.empty())
            records_[sent.type][sent.id].edits.erase(number);
        return;
    }
    ++answers_;
    const std::string id =
        sent.id.empty() ? message["result"][sent.type].get<std::string>() : sent.id;
    if (anchor_.empty())
        anchor_ = id;
    Record& record = records_[sent.type][id];
    record.edits[number] = sent.mark;
    record.answered = number;
    record.edits.erase(record.edits.begin(), record.edits.find(number));
}

void EditLedger::compare(const std::string& type,
                         const std::map<std::string, std::string>& found,
                         std::vector<std::string>& wrong) {
    std::set<std::string> created;
    for (const auto& [number, sent] : sent_)
        if (sent.type == type && sent.id.empty())
            created.insert(*sent.mark);
    std::map<std::string, Record>& records = records_[type];
    for (const auto& [id, record] : records) {
        const auto now = found.find(id);
        const Mark mark = now == found.end() ? Mark{} : now->second;
        const bool allowed = std::any_of(record.edits.begin(), record.edits.end(),
                                         [&](const auto& edit) { return edit.second == mark; });
        if (!allowed)
            wrong.push_back(type + " " + id + " is " + mark.value_or("gone") + ", edit " +
                            std::to_string(record.answered.value_or(0)) + " was answered");
    }
    for (const auto& [id, mark] : found)
        if (!records.contains(id) && !created.contains(mark))
            wrong.push_back(type + " " + id + " is " + mark + ", which no one made");
    records.clear();
    for (const auto& [id, mark] : found)
        records[id] = Record{{{0, mark}}, 0, false};
}

std::vector<std::string> EditLedger::settle(const json& state) {
    std::map<std::string, std::string> rakes;
    for (const json& each : state["rakes"])
        rakes[each["rake"]] = each["name"];
    std::map<std::string, std::string> surfaces;
    for (const json& each : state["surfaces"])
        surfaces[each["surface"]] = std::to_string(each["maxQuads"].get<std::size_t>());
    std::vector<std::string> wrong;
    compare("rake", rakes, wrong);
    compare("surface", surfaces, wrong);
    sent_.clear();
    if (!rakes.contains(anchor_))
        anchor_.clear();
    return wrong;
}

} // namespace wakesurf::tests
