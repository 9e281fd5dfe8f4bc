#include "protocol/api/generated/names.hpp"
#include "protocol/files/animation_page.hpp"
#include "protocol/files/file_difference.hpp"
#include "protocol/files/mesh_file.hpp"
#include "protocol/files/recipe.hpp"
#include "server/app/command_options.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/name_mapping.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/recipe_data.hpp"
#include "server/app/shown_surfaces.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/process_account.hpp"
#include "server/live/animation_file.hpp"
#include "server/live/surface_file.hpp"
#include "server/net/static_files.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace wakesurf::server {

namespace {

using core::Error;

constexpr int differs = 1; // exit status, as of what failed

core::Result<std::string> read_file(const std::string& name) {
    std::error_code wrong;
    const bool folder = std::filesystem::is_directory(name, wrong);
    std::ifstream stream(name, std::ios::binary);
    if (folder || !stream)
        return core::fail(Error::Code::NotFound, "cannot read " + name,
                          "name a file that wakesurf has written");
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// Returns the data to open: a file names none but built-in flows, as a stranger may have written it.
core::Result<std::string> data_for(const VerifyOptions& options, const protocol::Recipe& recipe) {
    // Beside a dataset, a picture may show surfaces of flows.
    if (!options.dataset.empty() && (recipe.flow.empty() || !recipe.format.empty()))
        return options.dataset;
    if (!recipe.flow.empty())
        return "flow:" + recipe.flow;
    return core::fail(Error::Code::InvalidArgument,
                      "the surface is one of the dataset " + recipe.dataset,
                      "name the data: wakesurf verify " + options.file + " DATA");
}

/// Calls `build` with as many threads as the options say.
template <class Build>
auto on_threads(const VerifyOptions& options, const Build& build) {
    const int used = options.threads > 0 ? options.threads
                                         : static_cast<int>(std::thread::hardware_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(used));
    tbb::task_arena arena(used);
    return arena.execute(build);
}

/// Prints what the file says it is.
void tell_recipe(const std::string& file, const protocol::Recipe& recipe) {
    tell("{}: a {} surface of {}, from {:g} to {:g}, by wakesurf {}\n", file,
         protocol::name(recipe.parameters.kind), recipe.dataset, recipe.parameters.from,
         recipe.parameters.to, recipe.version);
    if (recipe.version != WAKESURF_VERSION)
        tell("the versions differ: this is wakesurf {}, which may compute or write it in another "
             "way\n",
             WAKESURF_VERSION);
}

/// Says why another result need not be the fault of the file.
void tell_machine(const protocol::Recipe& recipe) {
    if (!recipe.rounding.empty() && recipe.rounding != rounding_mark())
        tell("the machines differ: sines and powers round in another way here than where it was "
             "written, so the last digits of a surface may differ\n");
}

/// Compares, prints the verdict, and returns the exit status.
int tell_verdict(const std::string& file,
                 const protocol::FoundRecipe& found,
                 SurfaceFile made,
                 bool sealed) {
    const bool same_mesh = made.mesh == found.recipe.mesh;
    // Any other byte makes another seal, which stands before most of them.
    const protocol::FoundRecipe own = protocol::find_recipes(made.bytes).sound.front();
    const bool same_seal = own.seal == found.seal;
    made.bytes.replace(own.seal_begin(), found.seal.size(), found.seal);
    auto difference = protocol::first_difference(found.recipe.format, file, made.bytes);
    if (difference.what.empty() && !difference.recompressed && !same_seal)
        difference.what = "its seal is another";
    if (difference.what.empty() && same_mesh && (sealed || !difference.recompressed)) {
        tell("verified: {}\n", difference.recompressed
                                   ? "the same values; another zlib compresses them otherwise"
                                   : fmt::format("the same {} bytes", file.size()));
        return 0;
    }
    tell("differs: {}\n", !difference.what.empty() ? difference.what
                          : difference.recompressed
                              ? "compressed bytes were changed, but no value"
                              : "the surface has another digest than its recipe states");
    tell("{}\n", same_mesh ? "the data and the recipe lead to the surface that was written: the "
                             "file has been changed since"
                           : "the data and the recipe lead to another surface now than when it "
                             "was written");
    if (sealed)
        tell("the file agrees with its own seal\n");
    if (!same_mesh)
        tell_machine(found.recipe);
    return differs;
}

/// Makes the file again. @param found  its recipe
core::Result<SurfaceFile> made_again(const protocol::FoundRecipe& found,
                                     const core::SurfacePlan& plan,
                                     const LoadedDataset& dataset,
                                     const core::MemoryAccount& account,
                                     const std::stop_token& stop) {
    auto share = account.open(core::MemoryUse::Downloads);
    const FileMemory memory{&account, &share, std::chrono::seconds(1)};
    if (found.recipe.format != protocol::animation_extension)
        return make_surface_file(found.recipe, plan, dataset, stop, memory, found.text);
    return read_animation_viewer().and_then([&](const std::string& viewer) {
        return make_animation_file(found.recipe, plan, dataset, viewer, stop, memory, found.text)
            .map([](AnimationFile&& made) { return std::move(made.file); });
    });
}

/// Verifies a file of a mesh, of lines, or of an animation.
core::Result<int> verify_file(const VerifyOptions& options,
                              const std::string& file,
                              const protocol::FoundRecipe& found,
                              const std::stop_token& stop) {
    const protocol::Recipe& recipe = found.recipe;
    tell_recipe(options.file, recipe);
    const bool sealed = seal_holds(file, found);
    if (!recipe.unrepeatable.empty()) {
        tell("it cannot be made again: {}\n{}\n", recipe.unrepeatable,
             sealed ? "the file agrees with its own seal"
                    : "the file does not agree with its own seal: it has been changed since");
        return differs;
    }
    const auto data = data_for(options, recipe);
    if (!data)
        return tl::unexpected(data.error());
    const ProcessAccount process(options.memory);
    const auto dataset =
        open_for_command(*data, options.store, options.taken, process.account(), stop);
    if (!dataset)
        return tl::unexpected(dataset.error());
    if (const std::string other = data_difference(*dataset, recipe); !other.empty()) {
        tell("the data differ: {}\n", other);
        return differs;
    }
    const auto plan = plan_of(recipe, *dataset);
    if (!plan)
        return tl::unexpected(plan.error());
    const ElapsedLine progress("building the surface again");
    return on_threads(options,
                      [&] { return made_again(found, *plan, *dataset, process.account(), stop); })
        .map(
            [&](SurfaceFile&& made) { return tell_verdict(file, found, std::move(made), sealed); });
}

/// Verifies the surfaces of a picture or a film.
core::Result<int> verify_picture(const VerifyOptions& options,
                                 const protocol::FoundRecipes& found,
                                 const std::stop_token& stop) {
    const ProcessAccount process(options.memory);
    int status = found.damaged > 0 ? differs : 0;
    if (found.damaged > 0)
        tell("{}\ndiffers: {} of the recipes in it are damaged\n", options.file, found.damaged);
    for (const ShownSurface& each : shown_surfaces(found.sound)) {
        tell_recipe(options.file, each.recipe);
        const auto data = data_for(options, each.recipe);
        if (!data)
            return tl::unexpected(data.error());
        const auto dataset =
            open_for_command(*data, options.store, options.taken, process.account(), stop);
        if (!dataset)
            return tl::unexpected(dataset.error());
        if (const std::string other = data_difference(*dataset, each.recipe); !other.empty()) {
            tell("the data differ: {}\n", other);
            status = differs;
            continue;
        }
        const ElapsedLine progress("building the surface again");
        const auto others = on_threads(
            options, [&] { return times_that_differ(each, *dataset, process.account(), stop); });
        if (!others)
            return tl::unexpected(others.error());
        if (others->empty())
            continue;
        tell("differs: another surface was shown at {} of {} times, the first one {}\n",
             others->size(), each.states.size(), others->front());
        tell_machine(each.recipe);
        status = differs;
    }
    if (status == 0)
        tell("verified: the surfaces that are shown; colours, view and pixels are not compared\n");
    return status;
}

core::Result<int> verify(const VerifyOptions& options, const std::stop_token& stop) {
    const auto file = read_file(options.file);
    if (!file)
        return tl::unexpected(file.error());
    const auto found = protocol::find_recipes(*file);
    if (found.sound.empty() && found.damaged > 0) {
        tell("{}\ndiffers: its recipe is damaged\n", options.file);
        return differs;
    }
    if (found.sound.empty())
        return core::fail(Error::Code::InvalidArgument, options.file + " has no recipe",
                          "files that wakesurf wrote before it had recipes, or that other programs "
                          "have saved again, cannot be verified");
    const std::string& format = found.sound.front().recipe.format;
    const bool whole =
        protocol::mesh_format(format).has_value() || format == protocol::animation_extension;
    return whole ? verify_file(options, *file, found.sound.front(), stop)
                 : verify_picture(options, found, stop);
}

} // namespace

void add_verify_options(CLI::App& command, VerifyOptions& options) {
    command.add_option("FILE", options.file, "A file that wakesurf has written")->required();
    command.add_option("DATA", options.dataset,
                       "The data that it was made from, as for `wakesurf surface`; not needed for "
                       "a built-in flow");
    add_process_options(command, options);
}

int run_verify(const VerifyOptions& options) {
    const StopOnSignal signals;
    const auto done = verify(options, signals.token()).map_error(with_options);
    return done ? *done : report_refusal(done.error());
}

} // namespace wakesurf::server
