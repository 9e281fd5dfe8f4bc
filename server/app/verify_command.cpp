#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/level/level_surface.hpp"
#include "protocol/api/generated/names.hpp"
#include "protocol/files/file_difference.hpp"
#include "protocol/files/recipe.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/name_mapping.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/process_account.hpp"
#include "server/data/surface_scalars.hpp"
#include "server/live/surface_file.hpp"
#include "store/command/memory_size.hpp"

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
    if (!options.dataset.empty())
        return options.dataset;
    if (!recipe.flow.empty())
        return "flow:" + recipe.flow;
    return core::fail(Error::Code::InvalidArgument,
                      "the surface is one of the dataset " + recipe.dataset,
                      "name the data: wakesurf verify " + options.file + " DATA");
}

/// Says how the data are others than those of the recipe; empty: they are the same.
std::string data_difference(const LoadedDataset& dataset, const protocol::Recipe& recipe) {
    const auto known = [](const std::string& flow) {
        return flow.empty() ? "stored data" : "flow:" + flow;
    };
    if (dataset.flow_text != recipe.flow)
        return fmt::format("the file was made from {}, not from {}", known(recipe.flow),
                           known(dataset.flow_text));
    if (!dataset.store || !dataset.store->contradicts(recipe.values))
        return {};
    const auto other = [&](std::size_t word) {
        std::string_view rest = recipe.values;
        for (; word > 0 && !rest.empty(); --word)
            rest.remove_prefix(std::min(rest.find(' ') + 1, rest.size()));
        return dataset.store->contradicts(std::string(rest.substr(0, rest.find(' '))));
    };
    return other(0)   ? "they have another grid or other fields, or are stored in another way"
           : other(1) ? "they have other values, from the first time-step on"
                      : "they have other values in a later time-step";
}

core::Result<core::SurfacePlan> planned_again(const protocol::Recipe& recipe,
                                              const LoadedDataset& dataset) {
    auto plan = core::plan_surface(dataset.flow, recipe.rake, recipe.parameters);
    if (!plan)
        return plan;
    if (auto there = core::take_levels(*plan, dataset.levels); !there)
        return tl::unexpected(there.error());
    std::vector<std::string> fields = recipe.fields;
    std::erase_if(fields, core::is_twin_name);
    if (auto known = check_fields(dataset, fields); !known)
        return tl::unexpected(known.error());
    return plan;
}

core::Result<SurfaceFile> made_again(const VerifyOptions& options,
                                     const protocol::FoundRecipe& found,
                                     const LoadedDataset& dataset,
                                     const core::MemoryAccount& account,
                                     const std::stop_token& stop) {
    const auto plan = planned_again(found.recipe, dataset);
    if (!plan)
        return tl::unexpected(plan.error());
    const ElapsedLine progress("building the surface again");
    const int used = options.threads > 0 ? options.threads
                                         : static_cast<int>(std::thread::hardware_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(used));
    tbb::task_arena arena(used);
    auto share = account.open(core::MemoryUse::Downloads);
    return arena.execute([&] {
        return make_surface_file(found.recipe, *plan, dataset, stop,
                                 {&account, &share, std::chrono::seconds(1)}, found.text);
    });
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

/// Compares, prints the verdict, and returns the exit status.
int tell_verdict(const std::string& file,
                 const protocol::FoundRecipe& found,
                 const SurfaceFile& made,
                 bool sealed) {
    const bool same_mesh = made.mesh == found.recipe.mesh;
    const auto difference =
        protocol::first_difference(*protocol::mesh_format(found.recipe.format), file, made.bytes);
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
    return differs;
}

core::Result<int> verify(const VerifyOptions& options, const std::stop_token& stop) {
    const auto file = read_file(options.file);
    if (!file)
        return tl::unexpected(file.error());
    const auto all = protocol::find_recipes(*file);
    if (all.sound.empty() && all.damaged > 0) {
        tell("{}\ndiffers: its recipe is damaged\n", options.file);
        return differs;
    }
    if (all.sound.empty())
        return core::fail(Error::Code::InvalidArgument, options.file + " has no recipe",
                          "files that wakesurf wrote before it had recipes, or that other programs "
                          "have saved again, cannot be verified");
    const protocol::FoundRecipe& found = all.sound.front();
    const protocol::Recipe& recipe = found.recipe;
    tell_recipe(options.file, recipe);
    const bool sealed = seal_holds(*file, found);
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
    return made_again(options, found, *dataset, process.account(), stop)
        .map([&](const SurfaceFile& made) { return tell_verdict(*file, found, made, sealed); });
}

} // namespace

void add_verify_options(CLI::App& command, VerifyOptions& options) {
    command.add_option("FILE", options.file, "A file that wakesurf has written")->required();
    command.add_option("DATA", options.dataset,
                       "The data that it was made from, as for `wakesurf surface`; not needed for "
                       "a built-in flow");
    command
        .add_option(
            "--memory", options.memory,
            "Memory for the process (default: 60 % of the memory of the machine or control group)")
        ->transform(command::as_memory_size());
    command.add_option("--threads", options.threads, "Number of threads (default: one per core)")
        ->check(CLI::Range(1, 1024));
    command.add_option("--store", options.store,
                       "Folder for imported data (default: ~/.cache/wakesurf)");
    command::add_source_options(command, options.taken);
}

int run_verify(const VerifyOptions& options) {
    const StopOnSignal signals;
    const auto done = verify(options, signals.token()).map_error(with_options);
    if (done)
        return *done;
    const int status = report_failure(done.error());
    return done.error().code == Error::Code::InvalidArgument ? wrong_usage : status;
}

} // namespace wakesurf::server
