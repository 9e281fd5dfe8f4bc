#include "server/app/command_options.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/output_files.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/process_account.hpp"
#include "server/data/obstacle_file.hpp"
#include "server/data/surface_scalars.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

namespace wakesurf::server {

using core::Error;
using core::Result;

namespace {

Result<void> make_body(const BodyOptions& options, const std::stop_token& stop) {
    const std::filesystem::path file = options.output;
    if (file.extension() != ".vtp")
        return core::fail(Error::Code::InvalidArgument, "-o: a body is written as .vtp",
                          "as in -o body.vtp");
    const ProcessAccount process(options.memory);
    const auto dataset =
        open_for_command(options.dataset, options.store, options.taken, process.account(), stop);
    if (!dataset)
        return tl::unexpected(dataset.error());
    const auto time = chosen_time(options.time, *dataset);
    if (!time)
        return tl::unexpected(time.error());
    if (auto known = check_fields(*dataset, options.fields, "--fields"); !known)
        return known;
    using Of = PatchChoice::Of;
    const PatchChoice patches{!options.patches.empty() ? Of::Named
                              : options.all_patches    ? Of::All
                                                       : Of::Body,
                              options.patches};
    core::MemoryAccount::Share share = process.account().open(core::MemoryUse::Downloads);
    const auto made = [&] {
        const ElapsedLine progress("sampling beside the body");
        return obstacle_file(*dataset, {patches, options.fields, *time}, process.account(), share,
                             stop);
    }();
    if (!made)
        return tl::unexpected(made.error());
    return write_whole_file(file, made->bytes).map([&] {
        tell("{}: {} points, {} faces, t = {:g}\n", options.output, made->points, made->faces,
             *time);
        for (const core::BoundaryPatch& patch : made->patches)
            tell("  {}: {} faces\n", patch.name, patch.triangles);
    });
}

} // namespace

void add_body_options(CLI::App& command, BodyOptions& options) {
    add_dataset_argument(command, options.dataset);
    command
        .add_option("--fields", options.fields,
                    "Fields beside the body, a,b: stored scalars, the velocity, vorticity, "
                    "q_criterion (default: the shape alone)")
        ->delimiter(',')
        ->allow_extra_args(false);
    CLI::Option* const patch =
        command
            .add_option("--patch", options.patches,
                        "A patch of the boundary by its name, instead of all walls of bodies; "
                        "may be given again")
            ->allow_extra_args(false);
    command
        .add_flag("--all-patches", options.all_patches,
                  "All patches, also inlets, outlets and walls in the sides of the domain")
        ->excludes(patch);
    command.add_option("--time", options.time, "Time of the values (default: the last)")
        ->check(CLI::Number);
    command.add_option("-o,--output", options.output, "File to write: .vtp")->required();
    add_process_options(command, options);
}

int run_body(const BodyOptions& options) {
    const StopOnSignal signals;
    const auto done = make_body(options, signals.token());
    return done ? 0 : report_refusal(done.error());
}

} // namespace wakesurf::server
