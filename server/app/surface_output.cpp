#include "server/app/surface_output.hpp"

#include "core/base/work_memory.hpp"
#include "core/surface/builder/interval_errors.hpp"
#include "server/app/command_output.hpp"
#include "server/app/name_mapping.hpp"
#include "server/app/progress_line.hpp"
#include "server/live/surface_file.hpp"

#include <tbb/task_arena.h>

#include <chrono>
#include <thread>

namespace wakesurf::server {

void state_interval_errors(core::Surface& surface,
                           const core::SurfacePlan& plan,
                           int threads,
                           const core::MemoryAccount& account,
                           const std::stop_token& stop) {
    std::string& left_out = surface.statistics.interval_left_out;
    left_out = core::no_interval_errors(plan);
    if (!left_out.empty())
        return;
    const ElapsedLine progress("estimating the error between stored times");
    tbb::task_arena arena(threads > 0 ? threads
                                      : static_cast<int>(std::thread::hardware_concurrency()));
    core::WorkMemory memory(account, stop, std::chrono::seconds(1),
                            "the error between stored times");
    const auto stated = arena.execute([&] {
        return core::state_interval_errors(plan, surface, stop, {nullptr, &memory});
    });
    if (!stated)
        left_out = stop.stop_requested() ? "it was stopped" : stated.error().message;
}

protocol::Recipe recipe_for(const std::filesystem::path& name,
                            const SurfaceOptions& options,
                            const core::SurfacePlan& plan,
                            const LoadedDataset& dataset) {
    protocol::Recipe recipe = recipe_of(plan, dataset);
    recipe.fields = options.fields;
    recipe.format = name.extension().string().substr(1);
    recipe.draco = options.draco;
    recipe.tessellate = options.tessellate;
    recipe.lines = options.lines;
    return recipe;
}

core::Result<void> tell_statistics(const core::SurfaceStatistics& statistics, bool cut_short) {
    if (statistics.empty && !statistics.empty->natural())
        return core::fail(core::Error::Code::InvalidArgument, statistics.empty->message,
                          statistics.empty->hint);
    if (statistics.empty)
        tell(stderr, "wakesurf: the surface is empty: {}; {}\n", statistics.empty->message,
             with_options({{}, {}, statistics.empty->hint}).hint);
    if (cut_short) { // the reason why it is coarser, or lacks particles
        tell(stderr, "wakesurf: not finished: {}; raise --seconds\n", statistics.stopped);
        return {};
    }
    if (statistics.coarsened())
        tell(stderr,
             "wakesurf: coarsened: a separation of {:.4g} needs more quads than allowed, so it is "
             "{:.4g}; raise --max-quads\n",
             statistics.requested_separation, statistics.separation);
    if (statistics.terminated.budget > 0)
        tell(stderr,
             "wakesurf: {} particles were not followed to the end: they take too many steps; "
             "raise --max-quads, or shorten the time\n",
             statistics.terminated.budget);
    if (statistics.error && statistics.error->uncertain > 0)
        tell(stderr,
             "wakesurf: {} of {} vertices are uncertain: the surface may be more than the "
             "separation away from them; --accuracy exact places them better\n",
             statistics.error->uncertain, statistics.vertices);
    if (statistics.interval_error && statistics.interval_error->error99 > statistics.separation)
        tell(stderr,
             "wakesurf: between stored times: 99 % of the vertices that are resolved are within "
             "{:.2g}, more than the separation{}\n",
             statistics.interval_error->error99,
             statistics.advised_interval
                 ? fmt::format("; data every {:.2g} would bring it to {:.2g}",
                               *statistics.advised_interval, statistics.separation)
                 : "");
    if (statistics.interval_error && statistics.interval_error->unresolved >= 0.1)
        tell(stderr,
             "wakesurf: {:.0f} % of the vertices are not resolved: the stored times are too far "
             "apart "
             "for them\n",
             100.0 * statistics.interval_error->unresolved);
    if (!statistics.stopped.empty())
        tell(stderr, "wakesurf: the surface ends early: {}\n", statistics.stopped);
    if (statistics.data_end)
        tell(stderr,
             "wakesurf: the surface goes back only to {}, where the data begin, so it is shorter "
             "backward than forward\n",
             *statistics.data_end);
    return {};
}

} // namespace wakesurf::server
