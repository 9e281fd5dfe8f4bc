#include "server/app/twin_runs.hpp"

#include "core/base/work_memory.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/time_direction.hpp"
#include "protocol/api/generated/surface.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/output_files.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/rake_text.hpp"
#include "server/base/split.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

namespace wakesurf::server {

namespace {

using Code = core::Error::Code;

/// Reads `between=flow accuracy=exact offset=0,0.1,0`, by the description of surface.twin.
core::Result<core::TwinSettings> read_settings(const std::string& text) {
    nlohmann::json twin = nlohmann::json::object();
    for (const std::string_view word : split(text, ' ')) {
        if (word.empty())
            continue;
        const auto parts = split(word, '=');
        const std::string name(parts[0]), value(parts.size() > 1 ? parts[1] : "");
        if (parts.size() != 2 || value.empty() || name == "dataset")
            return core::fail(Code::InvalidArgument,
                              fmt::format("--with: '{}' is not SETTING=VALUE", word),
                              "settings are accuracy, interpolation, between and offset");
        if (name != "offset") {
            twin[name] = value;
            continue;
        }
        const auto offset = parse_vector(value, "--with: offset");
        if (!offset)
            return tl::unexpected(offset.error());
        twin[name] = protocol::written<core::Vec3>(*offset);
    }
    return protocol::parse_call<protocol::SurfaceTwin>({{"surface", "s"}, {"twin", twin}})
        .map([](const protocol::SurfaceTwin& read) { return read.twin->settings; })
        .map_error([](core::Error error) {
            error.message = "--with: " + error.message;
            error.hint = "settings are accuracy, interpolation, between and offset=x,y,z";
            return error;
        });
}

std::string percent(double share) {
    return fmt::format("{:.{}f} %", std::floor(1000.0 * share) / 10.0, share < 1.0 ? 1 : 0);
}

std::string csv_field(std::string text) {
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '"');
    return '"' + text + '"';
}

std::string csv_rows(const TwinRun& run, const core::StatedTwin& stated) {
    std::string out;
    for (const core::TwinDistance& at : stated.ages)
        out += fmt::format("{},{},{},{},{},{},{}\n", csv_field(run.name), at.age, at.compared,
                           at.p50, at.p90, at.p99, at.lag50);
    return out;
}

} // namespace

core::Result<void> check_twin_options(const SurfaceOptions& options) {
    if (options.twins.empty() && options.with.empty())
        return core::fail(Code::InvalidArgument, "there is nothing to compare with",
                          "name other data, or settings: --with \"between=flow\"");
    const std::pair<bool, const char*> others[] = {
        {!options.lines.empty(), "--lines"},
        {options.tessellate > 1, "--tessellate"},
        {!options.times.empty(), "--times"},
        {options.seconds > 0.0, "--seconds"},
        {std::filesystem::path(options.output).extension() == ".png", "a picture"},
        {std::filesystem::path(options.output).extension() == ".html", "an animation"},
        {std::filesystem::path(options.output).extension() == ".csv", "a table of numbers"}};
    for (const auto& [given, option] : others)
        if (given)
            return core::fail(Code::InvalidArgument,
                              std::string(option) + " cannot be combined with twins",
                              "write one mesh: .vtp, .glb, .ply, .obj or .drc");
    for (const std::string& text : options.with)
        if (auto settings = read_settings(text); !settings)
            return tl::unexpected(settings.error());
    return {};
}

core::Result<std::vector<TwinRun>> open_twins(const SurfaceOptions& options,
                                              const LoadedDataset& dataset,
                                              const core::MemoryAccount& account,
                                              const std::stop_token& stop) {
    std::vector<TwinRun> out;
    for (const std::string& name : options.twins) {
        auto open = open_for_command(name, options.store, options.taken, account, stop);
        if (!open)
            return tl::unexpected(open.error());
        out.push_back({name, true, {}, *std::move(open)});
    }
    for (const std::string& text : options.with) {
        const auto settings = read_settings(text);
        if (!settings)
            return tl::unexpected(settings.error());
        out.push_back({text, false, *settings, dataset});
    }
    return out;
}

core::Result<void> keep_common_times(core::SurfaceParameters& p,
                                     const std::vector<TwinRun>& twins) {
    if (p.kind == core::SurfaceKind::Stream)
        return {};
    for (const TwinRun& run : twins) {
        const auto bounds = run.dataset.flow->time_bounds();
        if (!bounds)
            continue;
        const double from = std::clamp(p.from, (*bounds)[0], (*bounds)[1]);
        const double to = std::clamp(p.to, (*bounds)[0], (*bounds)[1]);
        const std::string theirs =
            core::time_text((*bounds)[0]) + " to " + core::time_text((*bounds)[1]);
        if (from == to)
            return core::fail(
                Code::OutOfTime,
                fmt::format("{} has no times in common with the surface: it goes from {}", run.name,
                            theirs),
                "compare runs of the same times");
        if (from != p.from || to != p.to)
            tell(stderr, "wakesurf: compared from {} to {}: {} goes from {}\n",
                 core::time_text(from), core::time_text(to), run.name, theirs);
        p.from = from;
        p.to = to;
    }
    return {};
}

core::Result<protocol::MeshScalars> compare_twins(const SurfaceOptions& options,
                                                  const std::vector<TwinRun>& twins,
                                                  const core::SurfacePlan& plan,
                                                  core::Surface& surface,
                                                  const core::MemoryAccount& account,
                                                  const std::stop_token& stop) {
    const ElapsedLine progress("tracing the twins");
    tbb::task_arena arena(options.threads > 0
                              ? options.threads
                              : static_cast<int>(std::thread::hardware_concurrency()));
    core::WorkMemory memory(account, stop, std::chrono::seconds(1), "the twins of this surface");
    std::vector<core::TwinComparison> found;
    std::string csv = "twin,age,compared,p50,p90,p99,lag50\n";
    for (const TwinRun& run : twins) {
        auto compared =
            core::plan_twin(plan, run.dataset.flow, run.settings).and_then([&](const auto& twin) {
                return arena.execute([&] {
                    return core::compare_twin(plan, surface, twin, stop, {nullptr, &memory});
                });
            });
        if (!compared) {
            core::Error error = compared.error();
            error.message = run.name + ": " + error.message;
            return tl::unexpected(error);
        }
        const core::TwinDistance& all = compared->stated.all;
        tell("{}: {} of the particles are there in both; half of these are within {:.3g}, 90 % "
             "within {:.3g}, 99 % within {:.3g}{}\n",
             run.name, percent(all.compared), all.p50, all.p90, all.p99,
             all.lag50 == 0.0
                 ? ""
                 : fmt::format("; it comes {:.2g} {} at the median", std::abs(all.lag50),
                               all.lag50 < 0.0 ? "earlier" : "later"));
        csv += csv_rows(run, compared->stated);
        found.push_back(*std::move(compared));
    }
    if (!options.csv.empty())
        if (auto written = write_whole_file(options.csv, csv); !written)
            return tl::unexpected(written.error());
    if (found.size() == 1) {
        surface.statistics.twin = found[0].stated;
        return protocol::MeshScalars{
            {std::string(core::twin_distance_name), std::move(found[0].distance)},
            {std::string(core::twin_lag_name), std::move(found[0].lag)}};
    }
    core::TwinBand band = core::band_of(surface, found);
    surface.mesh.position = std::move(band.mean);
    return protocol::MeshScalars{{"twin_spread", std::move(band.spread)},
                                 {"twin_runs", std::move(band.arrived)}};
}

void note_twins(protocol::Recipe& recipe, const std::vector<TwinRun>& twins) {
    if (twins.size() > 1)
        recipe.unrepeatable = "it is the mean of several runs";
    else if (!twins.empty() && twins[0].name_is_data)
        recipe.unrepeatable = "it was compared with other data, " + twins[0].name;
    else if (!twins.empty()) {
        recipe.twin = twins[0].settings;
        recipe.fields.emplace_back(core::twin_distance_name);
        recipe.fields.emplace_back(core::twin_lag_name);
    }
}

} // namespace wakesurf::server
