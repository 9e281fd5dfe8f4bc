#include "server/app/surface_request.hpp"

#include "core/surface/builder/vertex_attributes.hpp"
#include "protocol/api/base/point_json.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/api/generated/surface_options.hpp"
#include "protocol/files/mesh_file.hpp"
#include "server/app/rake_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

namespace wakesurf::server {

namespace {

using Code = core::Error::Code;

/// Accepts a leading plus sign, which JSON does not.
std::optional<double> number_of(std::string_view text) {
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

core::Result<nlohmann::json> value_of(const protocol::SurfaceOption& option,
                                      const std::string& text) {
    const std::string type = option.type;
    if (type == "number") {
        const auto number = number_of(text);
        if (!number || !std::isfinite(*number))
            return core::fail(Code::InvalidArgument,
                              std::string(option.option) + ": '" + text + "' is not a number");
        return *number;
    }
    if (type == "point")
        return parse_vector(text, option.option).map(protocol::point_json);
    return text;
}

bool given(const SurfaceOptions& options, const char* parameter) {
    const auto found = options.asked.find(parameter);
    return found != options.asked.end() && !found->second.empty();
}

/// Returns the parameters of surface.set. Rakes are parsed elsewhere, and open times are for the dataset.
core::Result<nlohmann::json> asked_json(const SurfaceOptions& options) {
    nlohmann::json asked{{"rake", "--rake"}, {"dataset", "DATASET"}, {"to", 0.0}};
    for (const protocol::SurfaceOption& each : protocol::surface_options) {
        if (!given(options, each.parameter))
            continue;
        auto value = value_of(each, options.asked.at(each.parameter));
        if (!value)
            return value;
        asked[each.parameter] = *std::move(value);
    }
    if (asked.contains("rake2"))
        asked["rake2"] = "--rake2";
    return asked;
}

/// Checks the parameters by the description of surface.set.
core::Result<protocol::SurfaceSetting> read_asked(const SurfaceOptions& options,
                                                  const nlohmann::json& asked) {
    protocol::CheckedJson in(asked);
    protocol::SurfaceSetting setting;
    read(in, setting);
    if (auto sound = in.verdict(); !sound)
        return core::fail(sound.error().code, sound.error().message, "see wakesurf surface --help");
    if (options.rake.empty() &&
        setting.parameters.kind != core::SurfaceKind::Level) // open ones come from the data later
        return setting;
    if (auto sound = protocol::check_kind(setting); !sound)
        return tl::unexpected(sound.error());
    return setting;
}

core::Result<void> check_output(const std::string& output, const char* option, bool mesh) {
    const std::filesystem::path file(output);
    const auto extension = file.extension().string();
    if (mesh && (extension.empty() || !protocol::mesh_format(extension.substr(1))))
        return core::fail(Code::InvalidArgument,
                          std::string(option) + ": '" + output + "' has no known extension",
                          "write " + protocol::mesh_extensions() + ", or .png for a picture");
    std::error_code ignored;
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, ignored))
        return core::fail(Code::NotFound,
                          std::string(option) + ": there is no folder " + folder.string(),
                          "create it first");
    return {};
}

core::Result<std::optional<protocol::LinesWanted>> read_lines(const SurfaceOptions& options,
                                                              core::SurfaceKind kind) {
    if (options.lines.empty() || std::filesystem::path(options.output).extension() == ".png")
        return std::nullopt;
    const auto extension = std::filesystem::path(options.output).extension().string();
    const auto format =
        extension.empty() ? std::nullopt : protocol::mesh_format(extension.substr(1));
    auto lines =
        protocol::read_lines(options.lines, kind, format.value_or(protocol::MeshFormat::Vtp));
    if (!lines)
        return core::fail(Code::InvalidArgument, "--lines: " + lines.error().message,
                          lines.error().hint);
    return *lines;
}

// Returns InvalidArgument for an option that pictures do not take.
core::Result<void> check_picture_options(const SurfaceOptions& options) {
    const std::pair<bool, const char*> others[] = {
        {!options.lines.empty() && options.lines != "points", "--lines"},
        {options.tessellate > 1, "--tessellate"},
        {!options.draco, "--no-draco"},
        {!options.stats.empty(), "--stats"},
        {options.seconds > 0.0, "--seconds"}};
    for (const auto& [given, option] : others)
        if (given)
            return core::fail(core::Error::Code::InvalidArgument,
                              std::string(option) + " is for meshes, and -o names a picture",
                              "leave it out, or write .vtp, .glb, .ply, .obj or .drc");
    return {};
}

} // namespace

core::Result<SurfaceRequest> check_surface_options(const SurfaceOptions& options) {
    auto texts = asked_json(options);
    if (!texts)
        return tl::unexpected(texts.error());
    auto asked = read_asked(options, *texts);
    if (!asked)
        return tl::unexpected(asked.error());
    SurfaceRequest request;
    request.parameters = std::move(asked->parameters);
    request.from = asked->from;
    if (given(options, "to"))
        request.to = request.parameters.to;
    if (!options.rake.empty() && request.parameters.kind == core::SurfaceKind::Level)
        return core::fail(Code::InvalidArgument, "a level surface begins at no rake",
                          "leave --rake out");
    if (options.rake.empty() && !options.rake_kind.empty())
        return core::fail(Code::InvalidArgument, "--rake-kind is of --rake, which is left out",
                          "give both or neither");
    if (!asked->rake2 && !options.rake2_kind.empty())
        return core::fail(Code::InvalidArgument, "--rake2-kind is of --rake2, which is left out",
                          "give both or neither");
    if (!options.rake.empty()) {
        auto rake = parse_rake(options.rake, options.seeds, "--rake", options.rake_kind);
        if (!rake)
            return tl::unexpected(rake.error());
        request.rake = *std::move(rake);
    }
    if (asked->rake2) {
        auto second =
            parse_rake(options.asked.at("rake2"), options.seeds, "--rake2", options.rake2_kind);
        if (!second)
            return tl::unexpected(second.error());
        request.parameters.rake2 = *std::move(second);
    }
    request.picture = std::filesystem::path(options.output).extension() == ".png";
    if (auto checked = check_output(options.output, "-o", !request.picture); !checked)
        return tl::unexpected(checked.error());
    if (request.picture)
        if (auto checked = check_picture_options(options); !checked)
            return tl::unexpected(checked.error());
    for (const char* told_apart : {"rake", "rake2", "dataset"})
        texts->erase(told_apart);
    if (!request.to)
        texts->erase("to");
    request.asked = texts->dump();
    auto lines = read_lines(options, request.parameters.kind);
    if (!lines)
        return tl::unexpected(lines.error());
    request.lines = *lines;
    if (!options.draco && std::filesystem::path(options.output).extension() == ".drc")
        return core::fail(Code::InvalidArgument,
                          "--no-draco cannot be used for .drc, which is always Draco",
                          "write .glb");
    if (!options.stats.empty()) {
        if (auto checked = check_output(options.stats, "--stats", false); !checked)
            return tl::unexpected(checked.error());
    }
    request.parameters.max_quads = options.max_quads;
    request.parameters.deformation = true;
    request.parameters.tangents =
        options.tessellate > 1 || std::ranges::any_of(options.fields, core::is_normal_component);
    return request;
}

} // namespace wakesurf::server
