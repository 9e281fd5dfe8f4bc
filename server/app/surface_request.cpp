#include "server/app/surface_request.hpp"

#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/rake.hpp"
#include "protocol/api/generated/names.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/api/generated/surface_options.hpp"
#include "protocol/files/mesh_file.hpp"
#include "server/app/command_output.hpp"
#include "server/app/rake_text.hpp"
#include "server/data/dataset_suggestion.hpp"
#include "server/data/region_text.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

namespace {

/// Uses the suggestion of the data for a rake and all open options, and prints it to standard error.
core::Result<void> begin_with_suggestion(SurfaceRequest& request,
                                         const SurfaceOptions& options,
                                         const LoadedDataset& dataset,
                                         std::stop_token stop) {
    const auto scene =
        suggest_for(dataset.info, *dataset.flow, dataset.store.get(), std::move(stop));
    if (!scene)
        return tl::unexpected(scene.error());
    core::SurfaceParameters& parameters = request.parameters;
    request.rake = scene->rake;
    request.rake.seeds = options.seeds;
    std::string points;
    for (const core::Vec3& p : scene->rake.points)
        points += fmt::format("{}{:g},{:g},{:g}", points.empty() ? "" : " ", p.x, p.y, p.z);
    tell(stderr, "wakesurf: without --rake: {} It is --rake \"{}\"{}\n", scene->why, points,
         scene->rake.kind == core::Rake::Kind::Circle ? " --rake-kind circle" : "");
    const auto same =
        std::ranges::find(scene->surfaces, parameters.kind, &core::SurfaceParameters::kind);
    if (same == scene->surfaces.end())
        return {};
    if (!request.from && !request.to && !parameters.direction) {
        request.from = same->from;
        request.to = same->to;
    }
    if (parameters.separation == 0.0)
        parameters.separation = same->separation;
    if (!parameters.sweep && !parameters.rake2)
        parameters.sweep = same->sweep;
    return {};
}

/// Chooses the field of a stream surface whose time is open: of a steady solver's iterations the last, else the first
/// stored one in which the fluid moves along the rake; the very first if it moves in none. Looks at 16 at most.
core::Result<void> choose_field_time(SurfaceRequest& request,
                                     const LoadedDataset& dataset,
                                     const std::stop_token& stop) {
    constexpr std::size_t most_looks = 16;
    const auto& times = dataset.info.times;
    if (request.from || request.parameters.kind != core::SurfaceKind::Stream ||
        request.parameters.direction == core::Direction::Backward || times.size() < 2)
        return {};
    if (dataset.info.time_unit == core::iterations) {
        request.from = times.back();
        tell(stderr, "wakesurf: without --from: the last iteration, {:g}\n", times.back());
        return {};
    }
    const core::SeedingCurve rake(request.rake);
    std::vector<core::Vec3> points;
    for (int i = 0; i <= 16; ++i)
        points.push_back(rake.at(i / 16.0));
    std::vector<core::Vec3> velocities(points.size());
    const std::size_t apart = (times.size() + most_looks - 1) / most_looks;
    for (std::size_t k = 0; k < times.size(); k += apart) {
        const std::vector<double> when(points.size(), times[k]);
        if (auto sampled = dataset.flow->sample(points, when, velocities, stop); !sampled)
            return sampled;
        if (std::ranges::all_of(velocities,
                                [](const core::Vec3& v) { return !(glm::length(v) > 0.0); }))
            continue;
        if (k > 0) {
            request.from = times[k];
            tell(stderr, "wakesurf: without --from: {:g}, because the fluid is at rest before\n",
                 times[k]);
        }
        return {};
    }
    return {};
}

/// Says that one stored time is a flow that stands still, and chooses how long particles are followed if that is
/// open: as long as the surface of a suggested rake would be.
core::Result<void> let_it_stand_still(SurfaceRequest& request,
                                      const LoadedDataset& dataset,
                                      const std::stop_token& stop) {
    const auto& times = dataset.info.times;
    const core::SurfaceKind kind = request.parameters.kind;
    if (dataset.store == nullptr || times.size() != 1 || kind == core::SurfaceKind::Stream ||
        kind == core::SurfaceKind::Level)
        return {};
    tell(stderr, "wakesurf: the data have a single time, {:g}: the flow is treated as steady\n",
         times.front());
    if (request.to)
        return {};
    const auto scene = suggest_for(dataset.info, *dataset.flow, dataset.store.get(), stop);
    if (!scene)
        return tl::unexpected(scene.error());
    const auto same = std::ranges::find(scene->surfaces, kind, &core::SurfaceParameters::kind);
    if (same == scene->surfaces.end())
        return {};
    const bool backward = request.parameters.direction == core::Direction::Backward;
    const double long_enough = same->to - same->from;
    request.to = request.from.value_or(times.front()) + (backward ? -long_enough : long_enough);
    tell(stderr, "wakesurf: without --to: {:g}, long enough for a typical rake\n", *request.to);
    return {};
}

} // namespace

core::Result<void> choose_open_options(SurfaceRequest& request,
                                       const SurfaceOptions& options,
                                       const LoadedDataset& dataset,
                                       const std::stop_token& stop) {
    if (options.rake.empty() && request.parameters.kind != core::SurfaceKind::Level)
        if (auto begun = begin_with_suggestion(request, options, dataset, stop); !begun)
            return begun;
    if (auto chosen = choose_field_time(request, dataset, stop); !chosen)
        return chosen;
    if (auto still = let_it_stand_still(request, dataset, stop); !still)
        return still;
    choose_times(request, dataset.info.times);
    if (dataset.info.time_unit == core::iterations && dataset.info.times.size() > 1 &&
        request.parameters.kind != core::SurfaceKind::Stream)
        tell(stderr,
             "wakesurf: the times are iterations of a steady solver: a {} surface through them has "
             "no physical meaning; use --kind stream, or make a store of the last one alone with "
             "wakesurf import --times {:g}:{:g}\n",
             protocol::name(request.parameters.kind), dataset.info.times.back(),
             dataset.info.times.back());
    return {};
}

void choose_times(SurfaceRequest& request, const std::vector<double>& times) {
    core::SurfaceParameters& parameters = request.parameters;
    const bool backward = parameters.direction == core::Direction::Backward;
    const double first = times.empty() ? 0.0 : backward ? times.back() : times.front();
    const double last = times.empty() ? 0.0 : backward ? times.front() : times.back();
    parameters.from = request.from.value_or(first);
    const bool there = backward ? last < parameters.from : last > parameters.from;
    const double usual = there ? last : parameters.from + (backward ? -10 : 10);
    parameters.to = request.to.value_or(usual);
}

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
        return parse_vector(text, option.option).map(protocol::written<core::Vec3>);
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
    auto setting = protocol::parse_call<protocol::SurfaceSetting>(asked);
    if (!setting)
        return core::fail(setting.error().code, setting.error().message,
                          "see wakesurf surface --help");
    if (options.rake.empty() &&
        setting->parameters.kind != core::SurfaceKind::Level) // open ones come from the data later
        return setting;
    if (auto sound = protocol::check_kind(*setting); !sound)
        return tl::unexpected(sound.error());
    return setting;
}

core::Result<void> check_output(const std::string& output, const char* option, bool mesh) {
    const std::filesystem::path file(output);
    const auto extension = file.extension().string();
    if (mesh && (extension.empty() || !protocol::mesh_format(extension.substr(1))))
        return core::fail(Code::InvalidArgument,
                          std::string(option) + ": '" + output + "' has no known extension",
                          "write " + protocol::mesh_extensions() +
                              ", .html for an animation, .csv for numbers, or .png for a picture");
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

/// Returns InvalidArgument for an option that a series does not take.
core::Result<void> check_series_options(const SurfaceOptions& options, const Series& series) {
    const bool files = series.form == Series::Form::Files;
    const std::pair<bool, const char*> others[] = {{!files && !options.lines.empty(), "--lines"},
                                                   {options.tessellate > 1, "--tessellate"},
                                                   {!files && !options.draco, "--no-draco"},
                                                   {!options.stats.empty(), "--stats"},
                                                   {options.seconds > 0.0, "--seconds"}};
    for (const auto& [given, option] : others)
        if (given)
            return core::fail(core::Error::Code::InvalidArgument,
                              std::string(option) + " cannot be combined with " +
                                  (files                                    ? "--times"
                                   : series.form == Series::Form::Animation ? "an animation"
                                                                            : "numbers"),
                              "leave it out, or write one mesh");
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
        return core::fail(Code::InvalidArgument, "a level surface has no rake", "leave --rake out");
    if (options.rake.empty() && !options.rake_kind.empty())
        return core::fail(Code::InvalidArgument, "--rake-kind needs --rake, which is missing",
                          "give both or neither");
    if (!asked->rake2 && !options.rake2_kind.empty())
        return core::fail(Code::InvalidArgument, "--rake2-kind needs --rake2, which is missing",
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
    auto series = read_series(options.output, options.times);
    if (!series)
        return tl::unexpected(series.error());
    request.series = *series;
    if (request.series)
        if (auto checked = check_series_options(options, *request.series); !checked)
            return tl::unexpected(checked.error());
    const bool mesh =
        !request.picture && (!request.series || request.series->form == Series::Form::Files);
    if (auto checked = check_output(options.output, "-o", mesh); !checked)
        return tl::unexpected(checked.error());
    if (!options.through.empty()) {
        if (!request.series || request.series->form != Series::Form::Numbers)
            return core::fail(Code::InvalidArgument, "--through is for numbers",
                              "leave it out, or write .csv");
        auto region = parse_region(options.through, "--through");
        if (!region)
            return tl::unexpected(region.error());
        request.through = *region;
    }
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
