#include "store/store_layout_json.hpp"

#include "protocol/api/base/json_members.hpp"
#include "protocol/api/dataset_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace wakesurf::protocol {

using core::UniformGrid;
using store::StoredGrid;
using store::StoredScalar;
using store::StoreLayout;

template <>
inline constexpr auto table_of<UniformGrid> = std::tuple(needed("origin", &UniformGrid::origin),
                                                         needed("spacing", &UniformGrid::spacing),
                                                         needed("dimensions",
                                                                &UniformGrid::dimensions));

template <>
inline constexpr auto
    table_of<core::SymmetryAxis> = std::tuple(needed("origin", &core::SymmetryAxis::origin),
                                              needed("direction", &core::SymmetryAxis::direction),
                                              needed("radial", &core::SymmetryAxis::radial));

template <>
inline constexpr auto table_of<StoredGrid> = std::tuple(needed("kind", &StoredGrid::kind),
                                                        some("dimensions", &StoredGrid::dimensions),
                                                        some("points", &StoredGrid::points),
                                                        some("cells", &StoredGrid::cells),
                                                        some("axis", &StoredGrid::axis),
                                                        some("periodic", &StoredGrid::periodic));

template <>
inline constexpr auto table_of<StoredScalar> = std::tuple(needed("name", &StoredScalar::name),
                                                          needed("stem", &StoredScalar::stem));

template <>
inline constexpr auto
    table_of<StoreLayout> = std::tuple(needed("grid", &StoreLayout::grid),
                                       needed("times", &StoreLayout::times),
                                       needed("precision", &StoreLayout::precision),
                                       needed("scalars", &StoreLayout::scalars),
                                       needed("mask", &StoreLayout::mask),
                                       needed("walls", &StoreLayout::walls),
                                       needed("checksums", &StoreLayout::checksums));

} // namespace wakesurf::protocol

namespace wakesurf::store {

using nlohmann::json;

namespace {

// Returns whether a stem may become part of a file name: nothing that leads out of the folder may pass.
bool plain(const std::string& stem) {
    return !stem.empty() && stem.size() <= 64 && stem != velocity_stem &&
           std::all_of(stem.begin(), stem.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
           });
}

void parse_bricks(protocol::JsonMembers& manifest, StoreLayout& layout) {
    if (!manifest.has("bricks"))
        return;
    protocol::JsonMembers members(manifest.object("bricks"));
    layout.brick_cells = members.get<std::uint32_t>("cells");
    layout.checked = !members.has("unchecked");
    if (!layout.checked) {
        protocol::JsonMembers unchecked(members.object("unchecked"));
        layout.may_have_gaps = unchecked.get<bool>("gaps");
        if (!unchecked.verdict())
            members.fault("unchecked", unchecked.verdict().error().message);
    }
    if (!members.verdict())
        manifest.fault("bricks", members.verdict().error().message);
    else if (layout.brick_cells == 0)
        manifest.fault("bricks", "must have cells");
}

} // namespace

json store_layout_json(const StoreLayout& layout) {
    json out = protocol::written<json>(layout);
    if (layout.grid.kind == core::GridKind::Uniform)
        out["grid"].update(protocol::written<json>(layout.grid.uniform));
    if (layout.brick_cells != 0)
        out["bricks"] = {{"cells", layout.brick_cells}};
    if (layout.brick_cells != 0 && !layout.checked)
        out["bricks"]["unchecked"] = {{"gaps", layout.may_have_gaps}};
    return out;
}

core::Result<StoreLayout> parse_store_layout(const json& value) {
    StoreLayout layout;
    std::string wrong = protocol::read_back(value, layout);
    if (wrong.empty() && layout.grid.kind == core::GridKind::Uniform) {
        layout.grid.dimensions = {}; // those of the object are the uniform grid's
        wrong = protocol::read_back(value["grid"], layout.grid.uniform);
    }
    if (!wrong.empty())
        return core::fail(core::Error::Code::Corrupt, wrong);
    protocol::JsonMembers members(value);
    parse_bricks(members, layout);
    std::set<std::string> stems;
    for (const StoredScalar& each : layout.scalars)
        if (!plain(each.stem) || !stems.insert(each.stem).second)
            members.fault("scalars", "must have stems that are plain and differ");
    return members.verdict().map([&] { return std::move(layout); });
}

} // namespace wakesurf::store
