#include "store/store_layout_json.hpp"

#include "protocol/api/base/json_members.hpp"
#include "protocol/api/dataset_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace wakesurf::store {

using nlohmann::json;

namespace {

json grid_json(const StoredGrid& grid) {
    json out{{"kind", protocol::grid_name(grid.kind)}};
    const auto& uniform = grid.uniform;
    switch (grid.kind) {
    case core::GridKind::Uniform:
        out["origin"] = {uniform.origin.x, uniform.origin.y, uniform.origin.z};
        out["spacing"] = {uniform.spacing.x, uniform.spacing.y, uniform.spacing.z};
        out["dimensions"] = uniform.dimensions;
        break;
    case core::GridKind::Rectilinear:
        out["dimensions"] = grid.dimensions;
        break;
    default:
        out["points"] = grid.points;
        out["cells"] = grid.cells;
    }
    return out;
}

std::array<std::uint32_t, 3> parse_dimensions(protocol::JsonMembers& members) {
    std::array<std::uint32_t, 3> dimensions{2, 2, 2};
    std::size_t axis = 0;
    for (const double nodes : members.numbers_of<3>("dimensions")) {
        if (nodes < 2 || nodes > std::numeric_limits<std::uint32_t>::max())
            members.fault("dimensions", "must be at least 2 nodes per axis");
        else
            dimensions[axis] = static_cast<std::uint32_t>(nodes);
        ++axis;
    }
    return dimensions;
}

StoredGrid parse_grid(protocol::JsonMembers& manifest) {
    StoredGrid grid;
    protocol::JsonMembers members(manifest.object("grid"));
    const auto kind = protocol::grid_kind(members.text("kind"));
    if (!kind)
        members.fault("kind", "is not a kind of grid this version knows");
    grid.kind = kind.value_or(core::GridKind::Uniform);
    if (grid.kind == core::GridKind::Uniform) {
        const auto origin = members.numbers_of<3>("origin");
        const auto spacing = members.numbers_of<3>("spacing");
        grid.uniform = {{origin[0], origin[1], origin[2]},
                        {spacing[0], spacing[1], spacing[2]},
                        parse_dimensions(members)};
    } else if (grid.kind == core::GridKind::Rectilinear) {
        grid.dimensions = parse_dimensions(members);
    } else {
        grid.points = members.count("points");
        grid.cells = members.count("cells");
    }
    if (!members.verdict())
        manifest.fault("grid", members.verdict().error().message);
    return grid;
}

json scalars_json(const std::vector<StoredScalar>& scalars) {
    json out = json::array();
    for (const auto& scalar : scalars)
        out.push_back({{"name", scalar.name}, {"stem", scalar.stem}});
    return out;
}

// Returns whether a stem may become part of a file name: nothing that leads out of the folder may pass.
bool plain(const std::string& stem) {
    return !stem.empty() && stem.size() <= 64 && stem != velocity_stem &&
           std::all_of(stem.begin(), stem.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
           });
}

std::vector<StoredScalar> parse_scalars(protocol::JsonMembers& manifest) {
    std::vector<StoredScalar> scalars;
    for (const json& entry : manifest.list("scalars")) {
        protocol::JsonMembers members(entry);
        scalars.push_back({members.text("name"), members.text("stem")});
        if (!members.verdict() || !plain(scalars.back().stem))
            manifest.fault("scalars", "must hold names and stems");
        const auto same = [&](const auto& s) { return s.stem == scalars.back().stem; };
        if (std::any_of(scalars.begin(), scalars.end() - 1, same))
            manifest.fault("scalars", "must differ in their stems");
    }
    return scalars;
}

void parse_bricks(protocol::JsonMembers& manifest, StoreLayout& layout) {
    if (!manifest.has("bricks"))
        return;
    protocol::JsonMembers members(manifest.object("bricks"));
    const auto cells = static_cast<std::uint32_t>(
        members.count("cells", std::numeric_limits<std::uint32_t>::max()));
    layout.brick_cells = cells;
    layout.checked = !members.has("unchecked");
    if (!layout.checked) {
        protocol::JsonMembers unchecked(members.object("unchecked"));
        layout.may_have_gaps = unchecked.flag("gaps");
        if (!unchecked.verdict())
            members.fault("unchecked", unchecked.verdict().error().message);
    }
    if (!members.verdict())
        manifest.fault("bricks", members.verdict().error().message);
    else if (cells == 0)
        manifest.fault("bricks", "must have cells");
}

std::map<std::string, std::uint32_t> parse_checksums(protocol::JsonMembers& manifest) {
    std::map<std::string, std::uint32_t> checksums;
    const json& entries = manifest.object("checksums");
    protocol::JsonMembers members(entries);
    for (const auto& [name, ignored] : entries.items())
        checksums[name] = static_cast<std::uint32_t>(
            members.count(name, std::numeric_limits<std::uint32_t>::max()));
    if (!members.verdict())
        manifest.fault("checksums", members.verdict().error().message);
    return checksums;
}

} // namespace

json store_layout_json(const StoreLayout& layout) {
    json out{{"grid", grid_json(layout.grid)},
             {"times", layout.times},
             {"precision", layout.precision == core::Precision::Half ? "half" : "single"},
             {"scalars", scalars_json(layout.scalars)},
             {"mask", layout.mask},
             {"walls", layout.walls},
             {"checksums", layout.checksums}};
    if (layout.brick_cells != 0)
        out["bricks"] = {{"cells", layout.brick_cells}};
    if (layout.brick_cells != 0 && !layout.checked)
        out["bricks"]["unchecked"] = {{"gaps", layout.may_have_gaps}};
    return out;
}

StoreLayout parse_store_layout(protocol::JsonMembers& members) {
    StoreLayout layout;
    layout.grid = parse_grid(members);
    layout.times = members.numbers("times");
    const std::string precision = members.text("precision");
    if (precision != "single" && precision != "half")
        members.fault("precision", "is neither single nor half");
    layout.precision = precision == "half" ? core::Precision::Half : core::Precision::Single;
    layout.scalars = parse_scalars(members);
    parse_bricks(members, layout);
    layout.mask = members.flag("mask");
    layout.walls = members.flag("walls");
    layout.checksums = parse_checksums(members);
    return layout;
}

} // namespace wakesurf::store
