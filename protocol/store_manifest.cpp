#include "protocol/store_manifest.hpp"

#include "protocol/dataset_json.hpp"
#include "protocol/json_members.hpp"
#include "protocol/json_text.hpp"

#include <nlohmann/json.hpp>

#include <limits>

namespace wakesurf::protocol {

using core::Error;
using nlohmann::json;

namespace {

constexpr std::string_view format_name = "wakesurf-store";
constexpr std::uint64_t format_version = 1;
constexpr JsonLimits limits{std::size_t{64} << 20, 16};

json source_json(const StoreSource& source) {
    json files = json::array();
    for (const auto& file : source.files)
        files.push_back({{"name", file.name}, {"size", file.size}, {"mtime", file.mtime}});
    return {{"files", std::move(files)}, {"selection", source.selection}};
}

StoreSource parse_source(JsonMembers& manifest) {
    StoreSource source;
    JsonMembers members(manifest.object("source"));
    source.selection = members.text("selection");
    for (const json& entry : members.list("files")) {
        JsonMembers file(entry);
        source.files.push_back({file.text("name"), file.count("size"), file.integer("mtime")});
        if (!file.verdict())
            manifest.fault("source.files", file.verdict().error().message);
    }
    if (!members.verdict())
        manifest.fault("source", members.verdict().error().message);
    return source;
}

core::UniformGrid parse_grid(JsonMembers& manifest) {
    core::UniformGrid grid;
    JsonMembers members(manifest.object("grid"));
    const auto origin = members.numbers_of<3>("origin");
    const auto spacing = members.numbers_of<3>("spacing");
    grid.origin = {origin[0], origin[1], origin[2]};
    grid.spacing = {spacing[0], spacing[1], spacing[2]};
    std::size_t axis = 0;
    for (const double nodes : members.numbers_of<3>("dimensions")) {
        if (nodes < 2 || nodes > std::numeric_limits<std::uint32_t>::max())
            members.fault("dimensions", "must be at least 2 nodes per axis");
        else
            grid.dimensions[axis] = static_cast<std::uint32_t>(nodes);
        ++axis;
    }
    if (!members.verdict())
        manifest.fault("grid", members.verdict().error().message);
    return grid;
}

core::Result<void> check_agreement(const StoreManifest& manifest) {
    const auto bytes = core::velocity_file_size(manifest.grid);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const auto disagree = [](std::string_view what) {
        return core::fail(Error::Code::Corrupt, "its " + std::string(what) + " disagree");
    };
    if (manifest.times.empty() || manifest.info.times != manifest.times)
        return disagree("times");
    if (manifest.info.points != manifest.grid.nodes() || manifest.info.bytes_per_step != *bytes ||
        manifest.info.dimensions != manifest.grid.dimensions)
        return disagree("numbers of points");
    if (manifest.info.bounds.lo != manifest.grid.bounds().lo ||
        manifest.info.bounds.hi != manifest.grid.bounds().hi)
        return disagree("bounds");
    if (!manifest.mask.empty() && manifest.mask != mask_file_name)
        return core::fail(Error::Code::Corrupt, "its mask is not " + std::string(mask_file_name));
    return {};
}

core::Result<StoreManifest> parse(const json& value) {
    JsonMembers members(value);
    if (members.text("format") != format_name)
        return core::fail(Error::Code::Corrupt, "it is not the manifest of a wakesurf store");
    if (members.count("version") != format_version)
        return core::fail(Error::Code::Unsupported, "its version is not one this program knows",
                          "import the dataset again");
    StoreManifest manifest;
    manifest.complete = members.flag("complete");
    manifest.source = parse_source(members);
    auto info = parse_dataset_info(members.object("info"));
    if (!info)
        return tl::unexpected(info.error());
    manifest.info = std::move(*info);
    manifest.grid = parse_grid(members);
    manifest.times = members.numbers("times");
    manifest.mask = members.has("mask") ? members.text("mask") : std::string();
    manifest.velocity_range = members.numbers_of<2>("velocityRange");
    if (auto sound = members.verdict(); !sound)
        return tl::unexpected(sound.error());
    return check_agreement(manifest).map([&] { return std::move(manifest); });
}

} // namespace

std::string store_manifest_text(const StoreManifest& manifest) {
    const auto& grid = manifest.grid;
    return json_text({{"format", format_name},
                      {"version", format_version},
                      {"complete", manifest.complete},
                      {"source", source_json(manifest.source)},
                      {"info", dataset_json(manifest.info)},
                      {"grid",
                       {{"origin", {grid.origin.x, grid.origin.y, grid.origin.z}},
                        {"spacing", {grid.spacing.x, grid.spacing.y, grid.spacing.z}},
                        {"dimensions", grid.dimensions}}},
                      {"times", manifest.times},
                      {"mask", manifest.mask.empty() ? json(nullptr) : json(manifest.mask)},
                      {"velocityRange", manifest.velocity_range}},
                     1);
}

core::Result<StoreManifest> parse_store_manifest(std::string_view text) {
    auto parsed = parse_json(text, limits).and_then([](const json& value) { return parse(value); });
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

core::StoreLayout store_layout(const StoreManifest& manifest, std::filesystem::path folder) {
    return {std::move(folder), manifest.grid, manifest.times, manifest.mask};
}

} // namespace wakesurf::protocol
