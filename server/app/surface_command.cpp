#include "core/base/machine_memory.hpp"
#include "core/surface/budget_search.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/level/level_surface.hpp"
#include "core/surface/patches/tessellation.hpp"
#include "core/surface/surface.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/generated/names.hpp"
#include "protocol/api/generated/subscription.hpp"
#include "protocol/api/generated/surface_options.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/name_mapping.hpp"
#include "server/app/other_programs.hpp"
#include "server/app/output_files.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/app/surface_output.hpp"
#include "server/app/surface_passes.hpp"
#include "server/app/surface_request.hpp"
#include "server/app/surface_series.hpp"
#include "server/app/twin_runs.hpp"
#include "server/base/process_account.hpp"
#include "server/data/surface_scalars.hpp"
#include "server/live/surface_file.hpp"
#include "store/command/memory_size.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::server {

// `wakesurf surface DATA -o a.png`: the surface as the page draws it, with the same colours, scalar bar, axes
// and shading, by the same code. So a picture needs Chromium, without a window, and a server meanwhile; the
// client for Python starts both (python/wakesurf/draw.py).

/// Returns only if Python cannot be started, with the exit status.
int draw_surface(const SurfaceOptions& options, const SurfaceRequest& request);

namespace {

nlohmann::json rake_json(const core::Rake& rake) {
    return {{"kind", protocol::name(rake.kind)},
            {"points", protocol::written(rake.points)},
            {"seeds", rake.seeds}};
}

/// Returns the options of the server that draws it.
std::vector<std::string> server_words(const SurfaceOptions& options) {
    std::vector<std::string> words = arguments_of(options.taken);
    if (!options.store.empty())
        words.push_back("--store=" + options.store);
    if (options.memory > 0)
        words.push_back("--memory=" + std::to_string(options.memory));
    if (options.threads > 0)
        words.push_back("--threads=" + std::to_string(options.threads));
    return words;
}

} // namespace

int draw_surface(const SurfaceOptions& options, const SurfaceRequest& request) {
    nlohmann::json job{{"size", options.size},
                       {"seeds", options.seeds},
                       {"surface", nlohmann::json::parse(request.asked)}};
    job["surface"]["maxQuads"] = options.max_quads;
    job["surface"]["fields"] = options.fields;
    job["points"] = !options.lines.empty();
    if (!options.rake.empty())
        job["rake"] = rake_json(request.rake);
    if (request.parameters.rake2)
        job["rake2"] = rake_json(*request.parameters.rake2);
    // Paths are separate words: they need not be UTF-8, but JSON is.
    std::vector<std::string> words{
        job.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), options.dataset,
        options.output};
    for (const std::string& word : server_words(options))
        words.push_back(word);
    return become_python("draw", words);
}

core::Result<LoadedDataset> open_for_command(const std::string& dataset,
                                             const std::string& store,
                                             const command::SourceOptions& taken,
                                             const core::MemoryAccount& account,
                                             std::stop_token stop) {
    const auto argument = resolve_dataset(dataset);
    if (!argument)
        return tl::unexpected(argument.error());
    OpenOptions open;
    open.store_root = store.empty() ? default_store_root() : std::filesystem::path(store);
    open.cache.account = account;
    open.taken = taken;
    const auto show = [](const store::ImportProgress& progress) {
        store::show_progress(progress, stderr);
    };
    return open_dataset(*argument, open, show, std::move(stop));
}

namespace {

/// The memory for putting a file together, in bytes a vertex, scalars included.
constexpr std::size_t file_bytes = 300;

/// Builds one pass. @param dataset  its name
core::Result<BuiltSurface> build(const std::string& dataset,
                                 const core::SurfacePlan& plan,
                                 int threads,
                                 const core::MemoryAccount& account,
                                 const std::stop_token& stop) {
    core::WorkDone work;
    const ElapsedLine progress("building a " + std::string(protocol::name(plan.parameters.kind)) +
                                   " surface of " + dataset,
                               &work, plan.parameters.to);
    const int used = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    // The global limit lets an arena be larger than the machine, as `--threads 8` on two cores.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(used));
    tbb::task_arena arena(used);
    auto memory = std::make_shared<core::WorkMemory>(
        account, stop, std::chrono::seconds(1),
        fmt::format("a surface of at most {} quads", plan.parameters.max_quads));
    return arena
        .execute([&] {
            return core::build_surface(plan, stop, core::SteadyClock{}, {&work, memory.get()});
        })
        .map([&](core::Surface&& surface) {
            return BuiltSurface{std::move(surface), memory};
        });
}

core::Result<void> write(const SurfaceOptions& options,
                         const core::SurfacePlan& plan,
                         const LoadedDataset& dataset,
                         const core::Surface& surface,
                         const protocol::MeshScalars& scalars,
                         const std::vector<TwinRun>& twins,
                         double processor_seconds,
                         bool cut_short,
                         std::uint64_t flat_cells) {
    protocol::Recipe recipe = recipe_for(options.output, options, plan, dataset);
    note_twins(recipe, twins);
    if (cut_short)
        recipe.unrepeatable = surface.statistics.stopped;
    auto written = surface_file(std::move(recipe), surface.mesh, surface.statistics, scalars)
                       .and_then([&](const SurfaceFile& file) {
                           return write_whole_file(options.output, file.bytes);
                       });
    if (!written || options.stats.empty())
        return written;
    auto statistics = protocol::written(surface.statistics);
    statistics["peakBytes"] = core::peak_resident_memory();
    statistics["seconds"]["processor"] = processor_seconds;
    if (cut_short)
        statistics["reason"] = "timeLimit";
    if (options.tessellate > 1)
        statistics["tessellation"] = {{"pieces", options.tessellate},
                                      {"quads", surface.mesh.cells.size()},
                                      {"vertices", surface.mesh.vertices()},
                                      {"flatCells", flat_cells}};
    return write_whole_file(options.stats, protocol::json_text(statistics, 2) + "\n");
}

/// Completes the options from the data, and makes the checks that need the data.
core::Result<core::SurfacePlan> planned(SurfaceRequest request,
                                        const SurfaceOptions& options,
                                        const LoadedDataset& dataset,
                                        const std::vector<TwinRun>& twins,
                                        const std::stop_token& stop) {
    if (auto chosen = choose_open_options(request, options, dataset, stop); !chosen)
        return tl::unexpected(chosen.error());
    if (auto common = keep_common_times(request.parameters, twins); !common)
        return tl::unexpected(common.error());
    auto plan = core::plan_surface(dataset.flow, request.rake, std::move(request.parameters));
    if (!plan)
        return tl::unexpected(plan.error());
    if (auto there = core::take_levels(*plan, dataset.levels); !there)
        return tl::unexpected(there.error());
    if (plan->clipped)
        tell(stderr, "wakesurf: part of the rake is outside the domain and was cut away\n");
    if (auto known = check_fields(dataset, options.fields); !known)
        return tl::unexpected(known.error());
    return plan;
}

/// Cuts the surface's cells if asked to; its error is then that of the cut cells. Returns the number of cells
/// with a side that stayed flat.
core::Result<std::uint64_t> cut_cells(core::Surface& surface,
                                      std::vector<double>& times,
                                      const SurfaceOptions& options,
                                      const core::SurfacePlan& plan,
                                      const std::stop_token& stop,
                                      core::WorkMemory& memory) {
    if (options.tessellate <= 1)
        return 0;
    auto cut =
        core::tessellate(plan, surface.mesh, times, options.tessellate, stop, {nullptr, &memory});
    if (!cut)
        return tl::unexpected(cut.error());
    surface.mesh = std::move(cut->mesh);
    surface.statistics.error = core::stated_error(surface.mesh, surface.statistics.separation);
    return cut->flat_cells;
}

core::Error nothing_yet(const core::Error& error, const TimeLimit& limit) {
    return limit.over() ? nothing_within(limit) : error;
}

/// Opens the data, builds and writes. @param limit  of opening and building; writing has none
core::Result<void> make(const SurfaceOptions& options,
                        SurfaceRequest request,
                        const TimeLimit& limit,
                        const std::stop_token& stop) {
    const bool lines = request.lines.has_value();
    const auto series = request.series;
    const auto through = request.through;
    const ProcessAccount process(options.memory);
    const auto dataset = open_for_command(options.dataset, options.store, options.taken,
                                          process.account(), limit.token());
    if (!dataset)
        return tl::unexpected(nothing_yet(dataset.error(), limit));
    const auto twins = open_twins(options, *dataset, process.account(), limit.token());
    if (!twins)
        return tl::unexpected(twins.error());
    const auto plan = planned(std::move(request), options, *dataset, *twins, limit.token());
    if (!plan)
        return tl::unexpected(nothing_yet(plan.error(), limit));
    if (series)
        return write_series(options, *series, through, *plan, *dataset, process.account(), stop);
    const std::clock_t began = std::clock();
    auto built =
        build_within(limit, plan->parameters, core::coarsest_separation(dataset->flow->domain()),
                     [&](const auto& parameters) {
                         core::SurfacePlan pass = *plan;
                         pass.parameters = parameters;
                         return build(dataset->info.name, pass, options.threads, process.account(),
                                      limit.token());
                     });
    if (!built)
        return tl::unexpected(built.error());
    if (stop.stop_requested())
        return core::fail(core::Error::Code::Cancelled, "stopped, nothing was written");
    core::Surface& surface = built->surface;
    const double processor_seconds =
        static_cast<double>(std::clock() - began) / static_cast<double>(CLOCKS_PER_SEC);
    if (built->cut_short)
        surface.statistics.interval_left_out = "the time limit was over";
    else
        state_interval_errors(surface, *plan, options.threads, process.account(), limit.token());
    if (auto shown = tell_statistics(surface.statistics, built->cut_short); !shown)
        return shown;
    core::WorkMemory memory(process.account(), stop, std::chrono::seconds(1), "the surface's file");
    auto times = core::vertex_times(surface, plan->parameters);
    const auto flat = cut_cells(surface, times, options, *plan, stop, memory);
    if (!flat)
        return tl::unexpected(flat.error());
    if (!memory.grow(surface.mesh.vertices() * file_bytes))
        return tl::unexpected(memory.refusal());
    auto scalars = surface_scalars(*dataset, surface.mesh, times, options.fields, stop);
    if (!scalars)
        return tl::unexpected(scalars.error());
    if (!twins->empty()) {
        auto compared = compare_twins(options, *twins, *plan, surface, process.account(), stop);
        if (!compared)
            return tl::unexpected(compared.error());
        scalars->merge(*compared);
    }
    if (auto written = write(options, *plan, *dataset, surface, *scalars, *twins, processor_seconds,
                             built->cut_short, *flat);
        !written)
        return written;
    const auto& statistics = surface.statistics;
    tell("{}: {}{} quads, {} vertices, {:.2f} s{}{}\n", options.output,
         lines ? options.lines + " of a surface of " : "", statistics.quads, statistics.vertices,
         statistics.seconds.total,
         options.tessellate > 1 ? fmt::format(", cut into {} quads, {} cells with flat sides",
                                              surface.mesh.cells.size(), *flat)
                                : "",
         built->cut_short ? ", not finished" : "");
    return {};
}

} // namespace

void add_surface_options(CLI::App& command, SurfaceOptions& options) {
    command
        .add_option("DATASET", options.dataset,
                    "A file or folder of simulation results, a store or a Zarr or the https:// "
                    "address of one, or flow:NAME[?k=v,...]")
        ->required();
    command.add_option(
        "--rake", options.rake,
        "\"x,y,z x,y,z ...\": a line, or a polyline; or a file of its points: .csv, .txt, .vtp, "
        ".vtk or .obj (default: chosen by the data, with the times and the separation)");
    command.add_option(
        "--rake-kind", options.rake_kind,
        "What the points of --rake are: line: 2; polyline and points: 2 or more; circle: the "
        "centre and two points on the rim (default: line or polyline, by their number)");
    command.add_option("--rake2-kind", options.rake2_kind, "The same of --rake2");
    command.add_option("--seeds", options.seeds, "Initial number of seeds on the rake")
        ->check(CLI::Range(protocol::limits::seeds_least, protocol::limits::seeds_most))
        ->capture_default_str();
    for (const protocol::SurfaceOption& each : protocol::surface_options) {
        CLI::Option* const option =
            command.add_option(each.option, options.asked[each.parameter], each.words);
        option->required(each.required);
        if (*each.usual != '\0')
            option->default_str(each.usual);
    }
    command
        .add_option(
            "--fields", options.fields,
            "Scalar fields to write at the vertices, a,b; vorticity and q_criterion are derived; "
            "with -o NAME.csv their means")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--max-quads", options.max_quads, "Maximum number of quads")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000}))
        ->capture_default_str();
    command
        .add_option(
            "--memory", options.memory,
            "Memory for the process (default: 60 % of the memory of the machine or control group)")
        ->transform(command::as_memory_size());
    command.add_option("--threads", options.threads, "Number of threads (default: one per core)")
        ->check(CLI::Range(1, 1024));
    command
        .add_option("--seconds", options.seconds,
                    "Time limit by the clock: the finest surface there is by then is written, and "
                    "marked as not finished")
        ->check([](const std::string& text) -> std::string {
            double seconds = 0.0;
            return CLI::detail::lexical_cast(text, seconds) && seconds > 0.0
                       ? std::string()
                       : text + " is not a number of seconds above 0";
        });
    command.add_option("--store", options.store,
                       "Folder for imported data (default: ~/.cache/wakesurf)");
    command::add_source_options(command, options.taken);
    command
        .add_option("-o,--output", options.output,
                    "File to write: .vtp, .glb, .ply, .obj or .drc; NAME_%03d.EXT for a file a "
                    "time, see --times; .html for an animation that a browser opens from the disk, "
                    "without a server; .csv for numbers: area, flux, ages and times, each with its "
                    "errors; or "
                    ".png for a picture, which needs Python with numpy, and Chromium")
        ->required();
    command.add_option(
        "--times", options.times,
        "FIRST:LAST:EVERY: times of an animation, of numbers, or of a file each; between "
        "--from and --to, of a stream surface --from plus the age (default: of an "
        "animation 200 from --from to --to, of numbers --to)");
    command.add_option("--through", options.through,
                       "Numbers: plane:x,y,z:nx,ny,nz, a point and the normal, or "
                       "box:x,y,z:x,y,z, two corners: where the surface meets it, at which ages, "
                       "and what is inside");
    command.add_option("--size", options.size, "WIDTHxHEIGHT of a picture, in pixels")
        ->capture_default_str()
        ->check([](const std::string& text) -> std::string {
            unsigned width = 0;
            unsigned height = 0;
            char more = 0;
            const bool two = std::sscanf(text.c_str(), "%5ux%5u%c", &width, &height, &more) == 2;
            const auto fits = [](unsigned pixels) { return pixels >= 64 && pixels <= 8192; };
            return two && fits(width) && fits(height)
                       ? std::string()
                       : text + " is not WIDTHxHEIGHT, each from 64 to 8192";
        });
    command.add_flag(
        "--draco,!--no-draco", options.draco,
        "Compress .glb files with Draco; --no-draco is for readers without it, such as ParaView");
    command
        .add_option("--tessellate", options.tessellate,
                    "Cut each cell into N by N quads on a curved patch through its vertices, which "
                    "is as exact as they are")
        ->check(CLI::Range(1U, core::most_tessellated))
        ->capture_default_str();
    command.add_option(
        "--lines", options.lines,
        "Write lines instead of the mesh: timelines:N, or streamlines:N, pathlines:N or "
        "streaklines:N, which the kind of surface consists of; for N also every=D, the distance "
        "between them. timeribbons:N,width=W and so on: ribbons of that width in the surface; "
        "arrows:every=D,width=W: arrows along the flow. Not as .drc. points: the vertices, with "
        "normal and radius, as .ply, or drawn in a picture");
    command.add_option("--stats", options.stats, "JSON file to write statistics to");
}

void add_twin_options(CLI::App& command, SurfaceOptions& options) {
    add_surface_options(command, options);
    command.add_option("OTHER", options.twins, "Other data to compare with, as DATASET");
    command.add_option("--with", options.with,
                       "Settings to compare with: \"accuracy=exact\", \"between=flow\", "
                       "\"interpolation=smooth\", \"offset=x,y,z\" of the rake, or several "
                       "\"between=cubic accuracy=exact\"; may be repeated");
    command.add_option("--csv", options.csv, "CSV file to write the distances by age to");
}

int run_twin(const SurfaceOptions& options) {
    if (const auto sound = check_twin_options(options); !sound) {
        report_failure(sound.error());
        return wrong_usage;
    }
    return run_surface(options);
}

int run_surface(const SurfaceOptions& options) {
    auto request = check_surface_options(options).map_error(with_options);
    if (!request)
        return report_refusal(request.error());
    if (request->picture)
        return draw_surface(options, *request);
    const StopOnSignal signals;
    const TimeLimit limit(options.seconds, signals.token());
    const auto made =
        make(options, *std::move(request), limit, signals.token()).map_error(with_options);
    if (made)
        return 0;
    // Only the dataset decides which times are valid.
    const bool usage = made.error().code == core::Error::Code::InvalidArgument &&
                       made.error().message.starts_with("--");
    const int status = report_failure(made.error());
    return usage ? wrong_usage : status;
}

} // namespace wakesurf::server
