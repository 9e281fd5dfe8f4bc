#include "protocol/api/dataset_json.hpp"

#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/list_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace wakesurf::protocol {

using nlohmann::json;

namespace {

constexpr std::array<std::pair<core::GridKind, std::string_view>, 5> grid_names{{
    {core::GridKind::Uniform, "uniform"},
    {core::GridKind::Rectilinear, "rectilinear"},
    {core::GridKind::Curvilinear, "curvilinear"},
    {core::GridKind::Unstructured, "unstructured"},
    {core::GridKind::Analytic, "analytic"},
}};

json field_json(const core::FieldInfo& field) {
    json out{{"name", field.name},
             {"components", field.components},
             {"source", field.source == core::FieldInfo::Source::Cell ? "cell" : "point"},
             {"range", field.range}};
    if (!field.unit.empty())
        out["unit"] = field.unit;
    if (field.family)
        out["family"] = true;
    if (!field.stored)
        out["stored"] = false;
    return out;
}

/// [null, null], as NaN is written: it is not known.
std::array<double, 2> parse_range(const json& field, JsonMembers& members) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    if (field.is_object() && field.value("range", json()) == json::array({nullptr, nullptr}))
        return {unknown, unknown};
    return members.numbers_of<2>("range");
}

core::Result<core::FieldInfo> parse_field(const json& value) {
    JsonMembers members(value);
    core::FieldInfo field;
    field.name = members.text("name");
    field.components = static_cast<int>(members.count("components", 1'000));
    field.source = members.text("source") == "cell" ? core::FieldInfo::Source::Cell
                                                    : core::FieldInfo::Source::Point;
    field.range = parse_range(value, members);
    if (members.has("unit"))
        field.unit = members.text("unit");
    if (members.has("stored"))
        field.stored = members.flag("stored");
    return members.verdict().map([&] { return field; });
}

core::GridKind parse_grid(JsonMembers& members) {
    const auto kind = grid_kind(members.text("grid"));
    if (!kind)
        members.fault("grid", "is not a kind of grid this version knows");
    return kind.value_or(core::GridKind::Uniform);
}

void parse_uniform_grid(JsonMembers& members, core::DatasetInfo& info) {
    if (members.has("spacing")) {
        const auto spacing = members.numbers_of<3>("spacing");
        info.spacing = {spacing[0], spacing[1], spacing[2]};
    }
    if (!members.has("dimensions"))
        return;
    const auto nodes = members.numbers_of<3>("dimensions");
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (nodes[axis] >= 0 && nodes[axis] <= std::numeric_limits<std::uint32_t>::max())
            info.dimensions[axis] = static_cast<std::uint32_t>(nodes[axis]);
        else
            members.fault("dimensions", "must hold numbers of nodes");
}

} // namespace

std::string_view grid_name(core::GridKind kind) {
    return std::find_if(grid_names.begin(), grid_names.end(),
                        [&](const auto& entry) { return entry.first == kind; })
        ->second;
}

std::optional<core::GridKind> grid_kind(std::string_view name) {
    const auto found = std::find_if(grid_names.begin(), grid_names.end(),
                                    [&](const auto& entry) { return entry.second == name; });
    return found == grid_names.end() ? std::nullopt : std::optional(found->first);
}

json dataset_json(const core::DatasetInfo& info) {
    const auto& [lo, hi] = info.bounds;
    json out{{"dataset", info.dataset},
             {"name", info.name},
             {"reader", info.reader},
             {"grid", grid_name(info.grid)},
             {"bounds", {lo.x, hi.x, lo.y, hi.y, lo.z, hi.z}},
             {"points", info.points},
             {"cells", info.cells},
             {"times", info.times},
             {"steady", info.steady},
             {"fields", list_json(info.fields, field_json)},
             {"velocity", info.velocity},
             {"why", info.why},
             {"obstacle", info.obstacle},
             {"bytesPerStep", info.bytes_per_step},
             {"finestSpacing", info.finest_spacing}};
    if (!info.note.empty())
        out["note"] = info.note;
    if (!info.length_unit.empty())
        out["lengthUnit"] = info.length_unit;
    if (!info.time_unit.empty())
        out["timeUnit"] = info.time_unit;
    if (info.precision == core::Precision::Half)
        out["precision"] = "half";
    if (info.grid == core::GridKind::Uniform || info.grid == core::GridKind::Rectilinear)
        out["dimensions"] = info.dimensions;
    if (info.grid == core::GridKind::Uniform) {
        out["spacing"] = {info.spacing.x, info.spacing.y, info.spacing.z};
    }
    return out;
}

core::Result<core::DatasetInfo> parse_dataset_info(const json& value) {
    JsonMembers members(value);
    core::DatasetInfo info;
    info.dataset = members.text("dataset");
    info.name = members.text("name");
    info.reader = members.text("reader");
    info.grid = parse_grid(members);
    const auto bounds = members.numbers_of<6>("bounds");
    info.bounds = {{bounds[0], bounds[2], bounds[4]}, {bounds[1], bounds[3], bounds[5]}};
    info.points = members.count("points");
    info.cells = members.count("cells");
    info.times = members.numbers("times");
    info.steady = members.flag("steady");
    for (const json& entry : members.list("fields")) {
        auto field = parse_field(entry);
        if (!field)
            return tl::unexpected(field.error());
        info.fields.push_back(std::move(*field));
    }
    info.velocity = members.text("velocity");
    info.why = members.text("why");
    info.obstacle = members.flag("obstacle");
    info.bytes_per_step = members.count("bytesPerStep");
    if (members.has("finestSpacing"))
        info.finest_spacing = members.number("finestSpacing");
    if (members.has("note"))
        info.note = members.text("note");
    if (members.has("lengthUnit"))
        info.length_unit = members.text("lengthUnit");
    if (members.has("timeUnit"))
        info.time_unit = members.text("timeUnit");
    if (members.has("precision")) {
        if (members.text("precision") != "half")
            members.fault("precision", "is not one this version knows");
        info.precision = core::Precision::Half;
    }
    parse_uniform_grid(members, info);
    return members.verdict().map([&] { return info; });
}

} // namespace wakesurf::protocol
