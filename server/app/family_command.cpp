#include "protocol/api/generated/names.hpp"
#include "server/app/command_options.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/rake_text.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/process_account.hpp"
#include "server/data/family_making.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <charconv>
#include <chrono>
#include <filesystem>
#include <thread>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;

namespace {

constexpr std::string_view inflow_word = "inflow=";

Result<core::FamilyRequest> read_source(const FamilyOptions& options) {
    core::FamilyRequest request;
    const int sources = (options.from.empty() ? 0 : 1) + (options.plane.empty() ? 0 : 1) +
                        (options.rake.empty() ? 0 : 1);
    if (sources != 1)
        return fail(Error::Code::InvalidArgument,
                    "exactly one of --from, --plane and --rake is needed",
                    "for example --from inflow=y");
    if (options.plane.empty() && !options.scalar.empty())
        return fail(Error::Code::InvalidArgument, "--scalar is for --plane",
                    "the scalar of the inflow is written as --from inflow=y");
    if (!options.from.empty()) {
        if (!options.from.starts_with(inflow_word) || options.from.size() == inflow_word.size())
            return fail(Error::Code::InvalidArgument,
                        "--from: '" + options.from + "' is not inflow=SCALAR",
                        "for example --from inflow=y, or inflow=p for a field p");
        request.scalar = options.from.substr(inflow_word.size());
        return request;
    }
    if (!options.rake.empty()) {
        auto rake = parse_rake(options.rake, core::Rake{}.seeds, "--rake", options.rake_kind);
        if (!rake)
            return tl::unexpected(rake.error());
        request.source = std::move(*rake);
        return request;
    }
    const auto plane = parse_rake(options.plane, core::Rake{}.seeds, "--plane");
    if (!plane)
        return tl::unexpected(plane.error());
    if (plane->points.size() != 2)
        return fail(Error::Code::InvalidArgument, "--plane: a point and a normal are needed",
                    "as in --plane \"0,0,0 1,0,0\"");
    request.source = core::FamilyPlane{plane->points[0], plane->points[1]};
    if (!options.scalar.empty())
        request.scalar = options.scalar;
    return request;
}

Result<std::vector<double>> read_times(std::string_view text) {
    std::vector<double> times;
    while (!text.empty()) {
        const auto end = std::min(text.find(','), text.size());
        double time = 0.0;
        const auto [rest, fault] = std::from_chars(text.data(), text.data() + end, time);
        if (fault != std::errc() || rest != text.data() + end || !std::isfinite(time))
            return fail(Error::Code::InvalidArgument,
                        "--time: '" + std::string(text.substr(0, end)) + "' is not a time");
        times.push_back(time);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return times;
}

Result<FamilyWish> read_wish(const FamilyOptions& options) {
    FamilyWish wish;
    wish.name = options.name;
    if (wish.name.empty())
        return fail(Error::Code::InvalidArgument, "--name is needed, or --remove",
                    "it is the name of the field, for example --name psi");
    auto request = read_source(options);
    if (!request)
        return tl::unexpected(request.error());
    wish.request = std::move(*request);
    wish.request.length = options.length;
    wish.request.accuracy =
        *protocol::value_of<core::Accuracy>(options.accuracy); // one of three words
    return read_times(options.times).map([&](std::vector<double> times) {
        wish.times = std::move(times);
        return std::move(wish);
    });
}

Result<core::FamilyRecord> made_in_arena(const LoadedDataset& dataset,
                                         const FamilyWish& wish,
                                         int threads,
                                         const core::MemoryAccount& account,
                                         const std::stop_token& stop) {
    core::WorkDone done;
    const ElapsedLine progress("tracing the nodes of " + dataset.info.name, &done);
    const int used = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(used));
    tbb::task_arena arena(used);
    core::WorkMemory memory(account, stop, std::chrono::seconds(1), "this family");
    return arena.execute([&] { return make_family(dataset, wish, stop, {&done, &memory}); });
}

void tell_made(const core::FamilyRecord& family, double seconds) {
    for (const core::FamilyStep& step : family.steps) {
        const core::FamilyCounts& n = step.counts;
        tell("{}: time-step {}, t = {:g}: {} of {} nodes have a value, {:.4g} to {:.4g}\n",
             family.name, step.index, step.time, n.reached, n.nodes, n.range[0], n.range[1]);
        if (n.reached < n.nodes)
            tell("without a value: {} at rest, {} in or at an obstacle, {} still in the flow after "
                 "{:.4g}, {} that miss the source\n",
                 n.at_rest, n.obstacle, n.lost, family.request.length, n.outside);
    }
    std::uint64_t nodes = 0;
    for (const core::FamilyStep& step : family.steps)
        nodes += step.counts.nodes;
    tell("{:.2f} s, {:.0f} nodes/s\n", seconds, static_cast<double>(nodes) / seconds);
}

Result<void> run_with(const FamilyOptions& options, const std::stop_token& stop) {
    const bool remove = !options.remove.empty();
    Result<FamilyWish> wish = remove ? FamilyWish{} : read_wish(options);
    if (!wish)
        return tl::unexpected(wish.error());
    const ProcessAccount process(options.memory);
    const auto dataset =
        open_for_command(options.dataset, options.store, options.taken, process.account(), stop);
    if (!dataset)
        return tl::unexpected(dataset.error());
    if (remove)
        return remove_family(*dataset, options.remove).map([&] {
            tell("{}: removed\n", options.remove);
        });
    const auto began = std::chrono::steady_clock::now();
    return made_in_arena(*dataset, *wish, options.threads, process.account(), stop)
        .map([&](const core::FamilyRecord& family) {
            const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - began;
            tell_made(family, gone.count());
        });
}

} // namespace

void add_family_options(CLI::App& command, FamilyOptions& options) {
    command
        .add_option("DATASET", options.dataset,
                    "A file or folder of simulation results, or a store")
        ->required();
    command.add_option("--name", options.name, "Name of the new field: letters, digits, and _ - .");
    auto* const remove =
        command.add_option("--remove", options.remove, "Remove the family of this name instead");
    command.add_option("--from", options.from,
                       "inflow=SCALAR: the scalar, which is x, y, z or a scalar field, is given "
                       "where the flow enters the domain");
    command.add_option("--plane", options.plane,
                       "\"x,y,z nx,ny,nz\": the scalar is given on the plane through a point with "
                       "a normal");
    command.add_option("--scalar", options.scalar,
                       "Scalar on the plane: x, y, z or a scalar field (default: y)");
    command.add_option("--rake", options.rake,
                       "\"x,y,z x,y,z ...\": the scalar is the distance from this line or planar "
                       "polyline, in its plane: the level 0 is the stream surface through it");
    command.add_option("--rake-kind", options.rake_kind,
                       "What the points of --rake are: line, polyline, or circle: the centre and "
                       "two points on the rim (default: line or polyline, by their number)");
    command.add_option("--time", options.times,
                       "Time of the field, the nearest time-step; several with commas (default: "
                       "the first)");
    command
        .add_option("--accuracy", options.accuracy,
                    "How accurately nodes are traced: fast, balanced, exact")
        ->check(CLI::IsMember({"fast", "balanced", "exact"}))
        ->capture_default_str();
    command
        .add_option("--length", options.length,
                    "How far a node is followed at most (default: ten diagonals of the domain)")
        ->check(CLI::PositiveNumber);
    add_process_options(command, options);
    for (const char* other : {"--name", "--from", "--plane", "--rake", "--scalar", "--time"})
        remove->excludes(command.get_option(other));
}

int run_family(const FamilyOptions& options) {
    const StopOnSignal signals;
    const auto done = run_with(options, signals.token());
    return done ? 0 : report_refusal(done.error());
}

} // namespace wakesurf::server
