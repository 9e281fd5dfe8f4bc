#include "server/app/surface_series.hpp"

#include "core/base/clock.hpp"
#include "core/base/work_done.hpp"
#include "core/base/work_memory.hpp"
#include "core/surface/measures/numbers_over_time.hpp"
#include "core/surface/playback/evolution.hpp"
#include "protocol/api/generated/names.hpp"
#include "protocol/files/numbers_csv.hpp"
#include "server/app/command_output.hpp"
#include "server/app/output_files.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/surface_output.hpp"
#include "server/data/surface_scalars.hpp"
#include "server/live/animation_file.hpp"
#include "server/live/surface_file.hpp"
#include "server/net/static_files.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace wakesurf::server {

namespace {

core::Result<void> write_animation(const SurfaceOptions& options,
                                   const core::SurfacePlan& plan,
                                   const std::vector<double>& times,
                                   const LoadedDataset& dataset,
                                   const core::MemoryAccount& account,
                                   core::WorkDone& done,
                                   const std::stop_token& stop) {
    const auto begun = std::chrono::steady_clock::now();
    const auto viewer = read_animation_viewer();
    if (!viewer)
        return tl::unexpected(viewer.error());
    protocol::Recipe recipe = recipe_for(options.output, options, plan, dataset);
    recipe.times = times;
    auto share = account.open(core::MemoryUse::Downloads);
    const auto made = make_animation_file(std::move(recipe), plan, dataset, *viewer, stop,
                                          {&account, &share, std::chrono::seconds(1)}, {}, &done);
    if (!made)
        return tl::unexpected(made.error());
    if (auto shown = tell_statistics(made->statistics, false); !shown)
        return shown;
    if (!made->without_body.empty())
        tell(stderr, "wakesurf: {}\n", made->without_body);
    const std::string& page = made->file.bytes;
    if (auto written = write_whole_file(options.output, page); !written)
        return written;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    tell("{}: {} steps, up to {} vertices, {:.1f} MB, {:.2f} bytes a vertex and step, {:.1f} s\n",
         options.output, times.size(), made->most_vertices, static_cast<double>(page.size()) / 1e6,
         static_cast<double>(made->frame_bytes) /
             static_cast<double>(std::max<std::uint64_t>(1, made->all_vertices)),
         took.count());
    return {};
}

core::Result<void> write_files(const SurfaceOptions& options,
                               const core::SurfacePlan& plan,
                               const std::vector<double>& times,
                               const LoadedDataset& dataset,
                               const core::WorkPart& work,
                               const std::stop_token& stop) {
    core::SteadyClock clock;
    auto evolution = core::Evolution::start(plan, clock, stop, work);
    if (!evolution)
        return tl::unexpected(evolution.error());
    for (std::size_t k = 0; k < times.size(); ++k) {
        const auto state = evolution->at(times[k], stop, work);
        if (!state)
            return tl::unexpected(state.error());
        const core::QuadComplex& mesh = state->mesh.mesh;
        const auto scalars = surface_scalars(dataset, mesh, state->times, options.fields, stop);
        if (!scalars)
            return tl::unexpected(scalars.error());
        const auto name = name_in(options.output, k);
        protocol::Recipe recipe = recipe_for(name, options, plan, dataset);
        recipe.time = times[k];
        recipe.step = true;
        auto written = surface_file(std::move(recipe), mesh, state->statistics, *scalars)
                           .and_then([&](const SurfaceFile& file) {
                               return write_whole_file(name, file.bytes);
                           });
        if (!written)
            return written;
        if (k + 1 == times.size())
            if (auto shown = tell_statistics(state->statistics, false); !shown)
                return shown;
    }
    tell("{} to {}: {} files\n", name_in(options.output, 0).string(),
         name_in(options.output, times.size() - 1).string(), times.size());
    return {};
}

core::Result<void> write_numbers(const SurfaceOptions& options,
                                 const core::SurfacePlan& plan,
                                 const std::vector<double>& times,
                                 const std::optional<core::Region>& through,
                                 const LoadedDataset& dataset,
                                 const core::WorkPart& work,
                                 const std::stop_token& stop) {
    const auto fields = averaged_fields(dataset, options.fields, "--fields");
    if (!fields)
        return tl::unexpected(fields.error());
    const auto table =
        core::numbers_over_time(plan, times, through, *fields, core::SteadyClock{}, stop, work);
    if (!table)
        return tl::unexpected(table.error());
    if (auto shown = tell_statistics(table->statistics, false); !shown)
        return shown;
    const std::string text =
        protocol::numbers_csv(*table, dataset.info.length_unit, dataset.info.time_unit);
    if (auto written = write_whole_file(options.output, text); !written)
        return written;
    tell("{}: {} {} of {} numbers\n", options.output, times.size(),
         times.size() == 1 ? "time" : "times", table->columns.size());
    return {};
}

} // namespace

core::Result<void> write_series(const SurfaceOptions& options,
                                const Series& series,
                                const std::optional<core::Region>& through,
                                core::SurfacePlan plan,
                                const LoadedDataset& dataset,
                                const core::MemoryAccount& account,
                                const std::stop_token& stop) {
    const auto times = times_of(series, plan.parameters);
    if (!times)
        return tl::unexpected(times.error());
    auto shown = until(std::move(plan), times->back());
    if (!shown)
        return tl::unexpected(shown.error());
    core::WorkDone done;
    const ElapsedLine progress(fmt::format("building a {} surface of {} at {} times",
                                           protocol::name(shown->parameters.kind),
                                           dataset.info.name, times->size()),
                               &done, times->back());
    core::WorkMemory memory(
        account, stop, std::chrono::seconds(1),
        fmt::format("a surface of at most {} quads", shown->parameters.max_quads));
    const int used = options.threads > 0 ? options.threads
                                         : static_cast<int>(std::thread::hardware_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(used));
    tbb::task_arena arena(used);
    const core::WorkPart work{&done, &memory};
    return arena.execute([&]() -> core::Result<void> {
        switch (series.form) {
        case Series::Form::Animation:
            return write_animation(options, *shown, *times, dataset, account, done, stop);
        case Series::Form::Numbers:
            return write_numbers(options, *shown, *times, through, dataset, work, stop);
        default:
            return write_files(options, *shown, *times, dataset, work, stop);
        }
    });
}

} // namespace wakesurf::server
