#include "server/cli/surface_command.hpp"

#include "core/surface/surface_builder.hpp"
#include "protocol/json_text.hpp"
#include "protocol/mesh_vtp.hpp"
#include "protocol/statistics_json.hpp"
#include "protocol/surface_names.hpp"
#include "server/catalogue/open_dataset.hpp"
#include "server/cli/elapsed_line.hpp"
#include "server/cli/failure.hpp"
#include "server/cli/stop_on_signal.hpp"
#include "server/cli/surface_request.hpp"
#include "server/cli/whole_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <thread>

namespace wakesurf::server {

namespace {

core::Result<LoadedDataset> open(const SurfaceOptions& options, std::stop_token stop) {
    const auto argument = resolve_dataset(options.dataset);
    if (!argument)
        return tl::unexpected(argument.error());
    OpenOptions open;
    open.store_root =
        options.store.empty() ? default_store_root() : std::filesystem::path(options.store);
    open.cache.budget_bytes = options.memory;
    const auto show = [](const ImportProgress& progress) { show_progress(progress, stderr); };
    return open_dataset(*argument, open, show, stop);
}

core::Result<core::Surface> build(const LoadedDataset& dataset,
                                  const SurfaceRequest& request,
                                  int threads,
                                  std::stop_token stop) {
    const ElapsedLine progress("building a " +
                               std::string(protocol::name(request.parameters.kind)) +
                               " surface of " + dataset.info.name);
    const int used = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    // The global limit is what lets an arena be larger than the machine, as `--threads 8` on two cores.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(used));
    tbb::task_arena arena(used);
    return arena.execute(
        [&] { return core::build_surface(*dataset.flow, request.rake, request.parameters, stop); });
}

core::Result<void> write(const SurfaceOptions& options,
                         const SurfaceRequest& request,
                         const core::DatasetInfo& info,
                         const core::Surface& surface) {
    const protocol::VtpMetadata metadata{.kind = request.parameters.kind,
                                         .rake = request.rake.points,
                                         .from = request.parameters.from,
                                         .to = request.parameters.to,
                                         .separation = surface.statistics.separation,
                                         .dataset = info.dataset,
                                         .version = WAKESURF_VERSION};
    auto written = write_whole_file(options.output, protocol::mesh_vtp(surface.mesh, metadata));
    if (!written || options.stats.empty())
        return written;
    const auto statistics = protocol::statistics_json(surface.statistics);
    return write_whole_file(options.stats, protocol::json_text(statistics, 2) + "\n");
}

core::Result<void>
make(const SurfaceOptions& options, SurfaceRequest request, std::stop_token stop) {
    const auto dataset = open(options, stop);
    if (!dataset)
        return tl::unexpected(dataset.error());
    if (auto chosen = choose_times(request.parameters, options, dataset->info.times); !chosen)
        return chosen;
    if (request.parameters.separation == 0.0)
        request.parameters.separation = dataset->info.finest_spacing;
    auto clipped = core::clip_rake(request.rake, dataset->flow->domain());
    if (!clipped)
        return tl::unexpected(clipped.error());
    if (clipped->clipped)
        fmt::print(stderr, "wakesurf: part of the rake is outside the domain and was cut away\n");
    request.rake = std::move(clipped->rake);
    const auto surface = build(*dataset, request, options.threads, stop);
    if (!surface)
        return tl::unexpected(surface.error());
    if (stop.stop_requested())
        return core::fail(core::Error::Code::Cancelled, "stopped, nothing was written");
    if (auto written = write(options, request, dataset->info, *surface); !written)
        return written;
    const auto& statistics = surface->statistics;
    fmt::print("{}: {} quads, {} vertices, {:.2f} s\n", options.output, statistics.quads,
               statistics.vertices, statistics.seconds.total);
    return {};
}

} // namespace

void add_surface_options(CLI::App& command, SurfaceOptions& options) {
    command
        .add_option("DATASET", options.dataset,
                    "A .pvd or .vti file, a store, or flow:NAME[?k=v,...]")
        ->required();
    command.add_option("--kind", options.kind, "stream, path, streak or time")->required();
    command.add_option("--rake", options.rake, "\"x,y,z x,y,z ...\": a line, or a polyline")
        ->required();
    command.add_option("--seeds", options.seeds, "Seeds on the rake to begin with")
        ->check(CLI::Range(2, 4096))
        ->capture_default_str();
    command.add_option("--from", options.from, "Time frozen at (stream) or of release (path)");
    command.add_option("--to", options.to, "Shown until; --to less --from is the integration time");
    command.add_option("--separation", options.separation,
                       "Longest edge (default: the finest spacing)");
    command.add_option("--accuracy", options.accuracy, "fast, balanced or exact")
        ->capture_default_str();
    command.add_option("--direction", options.direction, "forward, backward or both")
        ->capture_default_str();
    command.add_option("--release-until", options.release_until, "Streak: release stops here");
    command.add_option("--rake2", options.rake2, "Time: the second curve of the patch");
    command.add_option("--sweep", options.sweep, "Time: x,y,z the curve is swept along");
    command.add_option("--fields", options.fields, "Scalar fields to write at the vertices, a,b");
    command.add_option("--max-quads", options.max_quads, "Most quads to build")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000}))
        ->capture_default_str();
    command.add_option("--memory", options.memory, "Budget of the time-step cache (default: 4GiB)")
        ->transform(CLI::AsSizeValue(true));
    command.add_option("--threads", options.threads, "Threads (default: one a core)")
        ->check(CLI::Range(1, 1024));
    command.add_option("--store", options.store,
                       "Folder for imported data (default: ~/.cache/wakesurf)");
    command.add_option("-o,--output", options.output, "FILE.vtp to write")->required();
    command.add_option("--stats", options.stats, "FILE.json to write statistics to");
}

int run_surface(const SurfaceOptions& options) {
    auto request = check_surface_options(options);
    if (!request) {
        const int status = report_failure(request.error());
        return request.error().code == core::Error::Code::InvalidArgument ? 2 : status;
    }
    const StopOnSignal signals;
    const auto made = make(options, *std::move(request), signals.token());
    return made ? 0 : report_failure(made.error());
}

} // namespace wakesurf::server
