#include "core/base/work_memory.hpp"
#include "protocol/api/generated/names.hpp"
#include "protocol/files/lines_files.hpp"
#include "server/app/command_options.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/output_files.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/limits.hpp"
#include "server/base/process_account.hpp"
#include "server/data/dataset_lines.hpp"
#include "server/data/line_seeds_text.hpp"
#include "server/data/node_fields.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;

namespace {

/// The memory for a point in each file, its text included, in bytes.
constexpr std::size_t vtp_point_bytes = 100, csv_point_bytes = 160;

Result<core::Direction> direction_of(const std::string& text) {
    for (const auto& [direction, word] : protocol::words_of<core::Direction>)
        if (text == word)
            return direction;
    return fail(Error::Code::InvalidArgument, "--direction: '" + text + "' is no direction",
                "choose forward, backward or both");
}

Result<void> make_lines(const LinesOptions& options, const std::stop_token& stop) {
    const std::filesystem::path file = options.output;
    const bool csv = file.extension() == ".csv";
    if (!csv && file.extension() != ".vtp")
        return fail(Error::Code::InvalidArgument, "-o: lines are written as .vtp or .csv",
                    ".vtp is for ParaView, .csv a table");
    auto seeds = parse_line_seeds(options.from, "--from");
    if (!seeds)
        return tl::unexpected(seeds.error());
    seeds->seeds = options.seeds;
    seeds->patches = options.patches;
    const auto direction = direction_of(options.direction);
    if (!direction)
        return tl::unexpected(direction.error());
    const ProcessAccount process(options.memory);
    const auto dataset =
        open_for_command(options.dataset, options.store, options.taken, process.account(), stop);
    if (!dataset)
        return tl::unexpected(dataset.error());
    const auto time = chosen_time(options.time, *dataset);
    if (!time)
        return tl::unexpected(time.error());
    const auto field =
        find_node_field(options.field.empty() ? dataset->info.velocity : options.field,
                        dataset->info, dataset->scalars.get());
    if (!field)
        return tl::unexpected(field.error());
    core::WorkMemory memory(process.account(), stop, std::chrono::seconds(1), "these lines");
    const auto lines = [&] {
        const ElapsedLine progress("tracing lines");
        return dataset_lines(*seeds,
                             {*direction, sampled(*field, dataset->scalars.get()), *time,
                              options.duration, options.length, limits::line_points},
                             *dataset, memory, stop);
    }();
    if (!lines)
        return tl::unexpected(lines.error());
    if (!memory.grow(lines->points.size() * (csv ? csv_point_bytes : vtp_point_bytes)))
        return tl::unexpected(memory.refusal());
    return write_whole_file(file, csv ? protocol::lines_csv(*lines, field->name)
                                      : protocol::lines_vtp(*lines, field->name, *time))
        .map([&] {
            tell("{}: {}, t = {:g}, {}\n", options.output, field->name, *time,
                 protocol::lines_words(*lines));
        });
}

} // namespace

void add_lines_options(CLI::App& command, LinesOptions& options) {
    add_dataset_argument(command, options.dataset);
    command
        .add_option("--from", options.from,
                    "Where the lines are released: line:x,y,z:x,y,z, plane:x,y,z:x,y,z:x,y,z (a "
                    "corner and those beside it), sphere:x,y,z:radius, "
                    "walls:distance or along (on the walls, which the lines follow)")
        ->required();
    command
        .add_option("--patch", options.patches,
                    "A patch of the boundary by its name, for --from walls:distance and along, "
                    "instead of all walls of bodies; may be given again")
        ->allow_extra_args(false);
    command.add_option("--seeds", options.seeds, "Number of seeds")
        ->check(CLI::Range(std::uint64_t{1}, limits::line_seeds))
        ->capture_default_str();
    command.add_option("--direction", options.direction, "forward, backward or both")
        ->capture_default_str();
    command
        .add_option("--duration", options.duration,
                    "Time of flight each way (default: as long as it takes)")
        ->check(CLI::NonNegativeNumber);
    command
        .add_option("--length", options.length,
                    "Longest line each way (default: twice the domain's diagonal)")
        ->check(CLI::NonNegativeNumber);
    command.add_option("--field", options.field,
                       "Field along the lines: a stored scalar, vorticity, q_criterion, a "
                       "component as vorticity_z (default: the speed)");
    command.add_option("--time", options.time, "Time of the flow (default: the last)")
        ->check(CLI::Number);
    command.add_option("-o,--output", options.output, "File to write: .vtp or .csv")->required();
    add_process_options(command, options);
}

int run_lines(const LinesOptions& options) {
    const StopOnSignal signals;
    const auto done = make_lines(options, signals.token());
    return done ? 0 : report_refusal(done.error());
}

} // namespace wakesurf::server
