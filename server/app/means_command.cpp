#include "server/app/command_options.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/process_account.hpp"
#include "server/data/mean_making.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <thread>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;

namespace {

Result<MeanWish> read_wish(const MeansOptions& options) {
    if (options.fields.empty())
        return fail(Error::Code::InvalidArgument, "--fields is needed, or --remove",
                    "it names what is averaged, for example --fields p,U");
    MeanWish wish{options.fields, options.from, options.to, options.period, {}, options.label};
    if (options.phases != 0)
        wish.phases = options.phases;
    return wish;
}

Result<std::vector<core::MeanRecord>> made_in_arena(const LoadedDataset& dataset,
                                                    const MeanWish& wish,
                                                    int threads,
                                                    const core::MemoryAccount& account,
                                                    const std::stop_token& stop) {
    core::WorkDone done;
    const ElapsedLine progress(
        fmt::format("averaging {} of {}", fmt::join(wish.fields, ", "), dataset.info.name), &done);
    const int used = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(used));
    tbb::task_arena arena(used);
    core::WorkMemory memory(account, stop, std::chrono::seconds(1), "this mean");
    return arena.execute([&] { return make_means(dataset, wish, stop, {&done, &memory}); });
}

void tell_made(const core::MeanRecord& mean) {
    tell("{}: {} time-steps, {:g} to {:g}{}\n", mean.of, mean.steps, mean.from, mean.to,
         mean.phases == 0
             ? std::string()
             : fmt::format(", {} phases of a period of {:g}", mean.phases, mean.period));
    for (const core::MeanField& each : mean.fields)
        tell("  {:<12} {:.4g} to {:.4g}\n", each.name, each.range[0], each.range[1]);
}

Result<void> run_with(const MeansOptions& options, const std::stop_token& stop) {
    const bool remove = !options.remove.empty();
    const Result<MeanWish> wish = remove ? MeanWish{} : read_wish(options);
    if (!wish)
        return tl::unexpected(wish.error());
    const ProcessAccount process(options.memory);
    const auto dataset =
        open_for_command(options.dataset, options.store, options.taken, process.account(), stop);
    if (!dataset)
        return tl::unexpected(dataset.error());
    if (remove)
        return remove_mean(*dataset, options.remove).map([&] {
            tell("{}: removed\n", options.remove);
        });
    return made_in_arena(*dataset, *wish, options.threads, process.account(), stop)
        .map([](const std::vector<core::MeanRecord>& made) {
            for (const core::MeanRecord& each : made)
                tell_made(each);
        });
}

} // namespace

void add_means_options(CLI::App& command, MeansOptions& options) {
    command
        .add_option("DATASET", options.dataset,
                    "A file or folder of simulation results, or a store")
        ->required();
    command
        .add_option("--fields", options.fields,
                    "What is averaged, with commas: the velocity, scalar fields, or what is "
                    "derived, such as vorticity")
        ->delimiter(',')
        ->allow_extra_args(false);
    auto* const remove = command.add_option(
        "--remove", options.remove, "Remove the means that were made with the field of this name");
    command.add_option("--from", options.from,
                       "No time-step before this time counts (default: the first one does)");
    command.add_option("--to", options.to,
                       "No time-step after this time counts (default: the last one does)");
    command
        .add_option("--period", options.period,
                    "Make means by phase of this period, instead of the mean and the rms")
        ->check(CLI::PositiveNumber);
    command
        .add_option("--phases", options.phases,
                    "Into how many phases the period is divided (default: as many as it has "
                    "time-steps, at most 24)")
        ->check(CLI::Range(2, 64));
    command.add_option("--label", options.label,
                       "Behind the names of the new fields, as in p_mean_late: letters, digits, "
                       "and _ - .");
    add_process_options(command, options);
    for (const char* other : {"--fields", "--from", "--to", "--period", "--phases", "--label"})
        remove->excludes(command.get_option(other));
}

int run_means(const MeansOptions& options) {
    const StopOnSignal signals;
    const auto done = run_with(options, signals.token());
    return done ? 0 : report_refusal(done.error());
}

} // namespace wakesurf::server
