#include "protocol/api/session_file.hpp"

#include "protocol/api/base/json_text.hpp"
#include "protocol/api/plural.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace wakesurf::protocol {

using core::Error;
using core::fail;
using nlohmann::json;

namespace {

constexpr std::array<std::pair<const char*, const char*>, 6> groups{{
    {"rakes", "rake"},
    {"surfaces", "surface"},
    {"slices", "slice"},
    {"lines", "lines"},
    {"bookmarks", "bookmark"},
    {"annotations", "annotation"},
}};

tl::unexpected<Error> not_a_session_file(const std::string& what) {
    return fail(Error::Code::Corrupt, "this is not a session file: " + what,
                "use a file that `session.export` or session.json wrote");
}

json mark_json(const DatasetMark& mark) {
    json out{{"dataset", mark.dataset}};
    if (mark.fingerprint.empty())
        return out;
    out["name"] = mark.name;
    out["fingerprint"] = mark.fingerprint;
    if (!mark.values.empty())
        out["values"] = mark.values;
    out["times"] = {{"count", mark.steps}, {"first", mark.first}, {"last", mark.last}};
    if (mark.bounds) {
        const auto& [lo, hi] = *mark.bounds;
        out["bounds"] = {lo.x, hi.x, lo.y, hi.y, lo.z, hi.z};
    }
    return out;
}

std::string text_of(const json& value, const char* name) {
    const auto found = value.find(name);
    return found != value.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Only what notes are made of: bounds are for people.
DatasetMark read_mark(const json& value) {
    DatasetMark mark;
    mark.dataset = text_of(value, "dataset");
    mark.name = text_of(value, "name");
    mark.fingerprint = text_of(value, "fingerprint");
    mark.values = text_of(value, "values");
    if (const auto times = value.find("times"); times != value.end() && times->is_object()) {
        const auto count = times->find("count");
        if (count != times->end() && count->is_number_unsigned())
            mark.steps = count->get<std::uint64_t>();
    }
    return mark;
}

core::Result<void> read_group(const json& records,
                              const char* group,
                              const char* type,
                              std::vector<FileRecord>& into) {
    const auto found = records.find(group);
    const bool newer = std::string_view(type) == "slice" || std::string_view(type) == "lines";
    if (found == records.end() && newer)
        return {}; // of a version that had none
    if (found == records.end() || !found->is_array())
        return not_a_session_file(std::string("`records` lacks the list `") + group + "`");
    std::set<std::string> ids;
    for (const json& each : *found) {
        const std::string id = each.is_object() ? text_of(each, type) : std::string();
        if (id.empty())
            return not_a_session_file(std::string("one of the ") + group + " lacks its id `" +
                                      type + "`");
        if (!ids.insert(id).second)
            return not_a_session_file(std::string("there are two of the ") + type + " " +
                                      id.substr(0, 64));
        json record = each;
        record["rev"] = 1;
        if (std::string_view(type) == "surface")
            record["epoch"] = 0;
        into.push_back({type, id, json_text(record)});
    }
    return {};
}

} // namespace

json session_file_json(const SessionFile& file) {
    json records = json::object();
    for (const auto& [group, type] : groups)
        records[group] = json::array();
    for (const FileRecord& each : file.records) {
        json record = json::parse(each.text, nullptr, false);
        record.erase("rev");
        record.erase("epoch");
        if (each.type == "clock")
            records["clock"] = std::move(record);
        else
            records[plural_of(each.type)].push_back(std::move(record));
    }
    json datasets = json::array();
    for (const DatasetMark& each : file.datasets)
        datasets.push_back(mark_json(each));
    json out{{"wakesurfSession", session_file_version},
             {"name", file.name},
             {"exported", file.exported},
             {"wakesurf", file.wakesurf},
             {"records", std::move(records)},
             {"datasets", std::move(datasets)}};
    if (!file.units.empty())
        out["units"] = units_json(file.units);
    return out;
}

core::Result<SessionFile> read_session_file(std::string_view text, std::size_t most_bytes) {
    constexpr std::size_t depth = 40;
    const auto parsed = parse_json(text, {most_bytes, depth});
    if (!parsed)
        return tl::unexpected(parsed.error());
    const json& value = *parsed;
    if (!value.is_object() || !value.contains("wakesurfSession") ||
        !value["wakesurfSession"].is_number_integer())
        return not_a_session_file("`wakesurfSession` is missing");
    if (value["wakesurfSession"] != session_file_version)
        return fail(Error::Code::Unsupported,
                    "the session file is of version " + value["wakesurfSession"].dump() +
                        ", this wakesurf reads " + std::to_string(session_file_version),
                    "import it with the wakesurf that wrote it, or a newer one");
    const auto records = value.find("records");
    if (records == value.end() || !records->is_object())
        return not_a_session_file("`records` is missing");
    SessionFile file;
    file.name = text_of(value, "name");
    file.exported = text_of(value, "exported");
    file.wakesurf = text_of(value, "wakesurf");
    if (const auto units = value.find("units"); units != value.end() && units->is_object())
        file.units = {text_of(*units, "length"), text_of(*units, "time")};
    for (const auto& [group, type] : groups)
        if (auto read = read_group(*records, group, type, file.records); !read)
            return tl::unexpected(read.error());
    if (const auto clock = records->find("clock"); clock != records->end())
        file.records.push_back({"clock", "", json_text(*clock)});
    if (const auto datasets = value.find("datasets");
        datasets != value.end() && datasets->is_array())
        for (const json& each : *datasets)
            if (each.is_object())
                file.datasets.push_back(read_mark(each));
    return file;
}

} // namespace wakesurf::protocol
