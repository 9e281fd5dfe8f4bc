#include "store/store_manifest.hpp"

#include "core/base/plain_text.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/dataset_json.hpp"
#include "protocol/api/generated/limits.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace wakesurf::protocol {

using core::UniformGrid;
using store::SourceFile;
using store::StoredGrid;
using store::StoredScalar;
using store::StoreLayout;
using store::StoreManifest;
using store::StoreSource;

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

template <>
inline constexpr auto table_of<SourceFile> = std::tuple(needed("name", &SourceFile::name),
                                                        needed("size", &SourceFile::size),
                                                        needed("mtime", &SourceFile::mtime));

template <>
inline constexpr auto table_of<StoreSource> = std::tuple(needed("files", &StoreSource::files),
                                                         needed("steps", &StoreSource::steps),
                                                         needed("selection",
                                                                &StoreSource::selection));

template <>
inline constexpr auto
    table_of<StoreManifest> = std::tuple(needed("complete", &StoreManifest::complete),
                                         needed("source", &StoreManifest::source),
                                         some("withoutVelocity", &StoreManifest::without_velocity),
                                         needed("velocityRange", &StoreManifest::velocity_range));

} // namespace wakesurf::protocol

namespace wakesurf::store {

using core::Error;
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

namespace {

constexpr std::string_view format_name = "wakesurf-store";
constexpr protocol::JsonLimits limits{std::size_t{64} << 20, 16};

// Files of others may say anything, and clients are told all of it again and again.
constexpr std::size_t longest_note = 4096;
constexpr std::size_t longest_name = 256;

/// Makes all words harmless, and short. Names of fields stay as different as they were: what acts or cannot be
/// seen in them is written out.
void make_plain(core::DatasetInfo& info, StoreLayout& layout) {
    for (std::string* unit : {&info.length_unit, &info.time_unit})
        *unit = core::display_name(*unit, protocol::limits::unit_bytes);
    for (std::string* text : {&info.note, &info.why})
        *text = core::display_lines(*text, longest_note);
    for (std::string* name : {&info.name, &info.reader})
        *name = core::display_name(*name, longest_name);
    info.velocity = core::printable_line(info.velocity);
    for (StoredScalar& scalar : layout.scalars)
        scalar.name = core::printable_line(scalar.name);
    for (core::FieldInfo& field : info.fields) {
        field.name = core::printable_line(field.name);
        field.unit = core::display_name(field.unit, protocol::limits::unit_bytes);
    }
    std::erase_if(info.fields, [&](const core::FieldInfo& field) { // a name cut short names another
        return field.name.size() > longest_name && field.name != info.velocity;
    });
}

core::Result<void> check_agreement(const StoreManifest& manifest) {
    const StoreLayout& layout = manifest.layout;
    if (auto sound = check_layout(layout); !sound)
        return core::fail(Error::Code::Corrupt, sound.error().message);
    const auto disagree = [](std::string_view what) {
        return core::fail(Error::Code::Corrupt, "its " + std::string(what) + " disagree");
    };
    const core::DatasetInfo& info = manifest.info;
    if (info.times != layout.times)
        return disagree("times");
    if (!manifest.source.steps.empty() && manifest.source.steps.size() < layout.times.size())
        return disagree("times and files");
    const auto& uniform = layout.grid.uniform;
    const bool is_uniform = layout.grid.kind == core::GridKind::Uniform;
    if (info.grid != layout.grid.kind || info.points != layout.grid.nodes() ||
        info.bytes_per_step != step_file_size(layout.grid.nodes(), 3, core::Precision::Single) ||
        (is_uniform && info.dimensions != uniform.dimensions))
        return disagree("numbers of points");
    if (info.periodic != layout.grid.periodic)
        return disagree("periodic axes");
    if (is_uniform &&
        (info.bounds.lo != uniform.bounds().lo || info.bounds.hi != uniform.bounds().hi))
        return disagree("bounds");
    return {};
}

core::Result<StoreManifest> parse(const json& value) {
    protocol::JsonMembers members(value);
    if (members.text("format") != format_name)
        return core::fail(Error::Code::Corrupt, "it is not the manifest of a wakesurf store");
    const auto version = members.get<std::uint64_t>("version");
    if (version != store_format_version && version != brick_format_version)
        return core::fail(Error::Code::Unsupported,
                          "it is of another version than " + std::to_string(store_format_version) +
                              " and " + std::to_string(brick_format_version) +
                              ", which this wakesurf reads",
                          "import the dataset again");
    auto manifest = protocol::parse_table<StoreManifest>(value);
    auto info = protocol::parse_dataset_info(members.object("info"));
    auto layout = parse_store_layout(value);
    for (const Error* wrong : {manifest ? nullptr : &manifest.error(),
                               info ? nullptr : &info.error(), layout ? nullptr : &layout.error()})
        if (wrong != nullptr)
            return tl::unexpected(*wrong);
    manifest->info = std::move(*info);
    manifest->layout = std::move(*layout);
    make_plain(manifest->info, manifest->layout);
    if (members.has("bricks") != (version == brick_format_version))
        members.fault("bricks", "must be there in version 3, and only there");
    if (auto sound = members.verdict(); !sound)
        return tl::unexpected(sound.error());
    return check_agreement(*manifest).map([&] {
        mark_stored(manifest->layout, manifest->info);
        return std::move(*manifest);
    });
}

} // namespace

std::string store_manifest_text(const StoreManifest& manifest) {
    json out = protocol::written<json>(manifest);
    out.update(store_layout_json(manifest.layout));
    out["format"] = format_name;
    out["version"] = manifest.layout.brick_cells == 0 ? store_format_version : brick_format_version;
    out["info"] = protocol::dataset_json(manifest.info);
    return protocol::json_text(out, 1);
}

core::Result<StoreManifest> parse_store_manifest(std::string_view text) {
    auto parsed =
        protocol::parse_json(text, limits).and_then([](const json& value) { return parse(value); });
    if (!parsed)
        return core::fail(parsed.error().code,
                          std::string(manifest_file_name) + ": " + parsed.error().message,
                          "import the dataset again");
    return parsed;
}

core::Result<StoreManifest> read_store_manifest(const std::filesystem::path& folder,
                                                const core::Disk& disk) {
    const auto file = folder / manifest_file_name;
    const auto size = disk.size(file);
    if (!size)
        return tl::unexpected(size.error());
    if (*size > limits.bytes)
        return core::fail(Error::Code::OverLimit, std::string(manifest_file_name) + " is too long");
    std::string text(static_cast<std::size_t>(*size), '\0');
    if (auto read = disk.read(file, 0, std::as_writable_bytes(std::span(text))); !read)
        return tl::unexpected(read.error());
    return parse_store_manifest(text);
}

StoreLayout store_layout(const StoreManifest& manifest, std::filesystem::path folder) {
    StoreLayout layout = manifest.layout;
    layout.folder = std::move(folder);
    return layout;
}

} // namespace wakesurf::store
