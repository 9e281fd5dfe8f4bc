#include "store/store_manifest.hpp"

#include "core/base/plain_text.hpp"
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

template <class Io>
void members(Io& io, Of<Io, UniformGrid>& of) {
    io.needed("origin", of.origin);
    io.needed("spacing", of.spacing);
    io.needed("dimensions", of.dimensions);
}

template <class Io>
void members(Io& io, Of<Io, core::SymmetryAxis>& of) {
    io.needed("origin", of.origin);
    io.needed("direction", of.direction);
    io.needed("radial", of.radial);
}

template <class Io>
void members(Io& io, Of<Io, StoredGrid>& of) {
    io.needed("kind", of.kind);
    if (of.kind == core::GridKind::Uniform)
        members(io, of.uniform);
    else
        io.some("dimensions", of.dimensions);
    io.some("points", of.points);
    io.some("cells", of.cells);
    io.some("axis", of.axis);
    io.some("periodic", of.periodic);
}

template <class Io>
void members(Io& io, Of<Io, StoredScalar>& of) {
    io.needed("name", of.name);
    io.needed("stem", of.stem);
}

namespace {

struct Unchecked {
    bool gaps = false;
};

struct KeptBricks {
    std::uint32_t cells = 0;
    std::optional<Unchecked> unchecked;
};

// Returns whether a stem may become part of a file name: nothing that leads out of the folder may pass.
bool plain(const std::string& stem) {
    return !stem.empty() && stem.size() <= 64 && stem != store::velocity_stem &&
           std::all_of(stem.begin(), stem.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
           });
}

template <class Io>
void members(Io& io, Of<Io, Unchecked>& of) {
    io.needed("gaps", of.gaps);
}

template <class Io>
void members(Io& io, Of<Io, KeptBricks>& of) {
    io.needed("cells", of.cells, {.lo = 1});
    io.some("unchecked", of.unchecked);
}

} // namespace

template <class Io>
void members(Io& io, Of<Io, StoreLayout>& of) {
    io.needed("grid", of.grid);
    io.needed("times", of.times);
    io.needed("precision", of.precision);
    io.needed("scalars", of.scalars);
    io.needed("mask", of.mask);
    io.needed("walls", of.walls);
    io.needed("checksums", of.checksums);
    std::optional<KeptBricks> bricks;
    if (of.brick_cells != 0)
        bricks = {of.brick_cells,
                  of.checked ? std::nullopt : std::optional(Unchecked{of.may_have_gaps})};
    io.some("bricks", bricks);
    if constexpr (Io::reads)
        if (bricks) {
            of.brick_cells = bricks->cells;
            of.checked = !bricks->unchecked;
            of.may_have_gaps = bricks->unchecked && bricks->unchecked->gaps;
        }
    std::set<std::string> stems;
    for (const StoredScalar& each : of.scalars)
        if (!plain(each.stem) || !stems.insert(each.stem).second)
            io.check("scalars", "must have stems that are plain and differ");
}

template void members(JsonReader&, StoreLayout&);
template void members(JsonWriter&, const StoreLayout&);

template <class Io>
void members(Io& io, Of<Io, SourceFile>& of) {
    io.needed("name", of.name);
    io.needed("size", of.size);
    io.needed("mtime", of.mtime);
}

template <class Io>
void members(Io& io, Of<Io, StoreSource>& of) {
    io.needed("files", of.files);
    io.needed("steps", of.steps);
    io.needed("selection", of.selection);
}

template <class Io>
void members(Io& io, Of<Io, StoreManifest>& of) {
    io.needed("complete", of.complete);
    io.needed("source", of.source);
    io.needed("info", of.info);
    members(io, of.layout);
    io.some("withoutVelocity", of.without_velocity);
    io.needed("velocityRange", of.velocity_range);
}

} // namespace wakesurf::protocol

namespace wakesurf::store {

using core::Error;
using nlohmann::json;

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
    for (core::BoundaryPatch& patch : info.patches)
        patch.name = core::display_name(patch.name, longest_name);
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
    protocol::JsonReader in(value);
    std::string format;
    std::uint64_t version = 0;
    in.needed("format", format);
    in.newer("version", version);
    if (format != format_name)
        return core::fail(Error::Code::Corrupt, "it is not the manifest of a wakesurf store");
    if (version != store_format_version && version != brick_format_version)
        return core::fail(Error::Code::Unsupported,
                          "it is of another version than " + std::to_string(store_format_version) +
                              " and " + std::to_string(brick_format_version) +
                              ", which this wakesurf reads",
                          "import the dataset again");
    StoreManifest manifest;
    members(in, manifest);
    make_plain(manifest.info, manifest.layout);
    if ((manifest.layout.brick_cells != 0) != (version == brick_format_version))
        in.check("bricks", "must be there in version 3, and only there");
    if (auto sound = in.verdict(); !sound)
        return tl::unexpected(sound.error());
    manifest.layout.patches = manifest.info.patches;
    return check_agreement(manifest).map([&] {
        mark_stored(manifest.layout, manifest.info);
        return std::move(manifest);
    });
}

} // namespace

std::string store_manifest_text(const StoreManifest& manifest) {
    json out = protocol::written(manifest);
    out["format"] = format_name;
    out["version"] = manifest.layout.brick_cells == 0 ? store_format_version : brick_format_version;
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
