// The program `wakesurf`: parses the command line and hands over to one command.

#include "core/base/result.hpp"
#include "protocol/api/base/nearest_name.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/environment.hpp"
#include "server/app/packaged_texts.hpp"
#include "server/app/version.hpp"
#include "server/data/dataset_argument.hpp"
#include "store/command/manual_page.hpp"
#include "store/command/memory_size.hpp"
#include "store/command/source_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace wakesurf;
using namespace wakesurf::server;

constexpr int failed = 1;

std::vector<std::string> command_names(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* each : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    return names;
}

/// Commands consist of letters and dashes; files have dots, folders slashes, flows a colon.
bool looks_like_command(const std::string& word) {
    return word.find_first_of("./:") == std::string::npos;
}

/// The words of a command line with its command in front.
struct CommandWords {
    std::vector<std::string> words;
    /// The command was added: the data are served, and the page is opened.
    bool implied = false;
};

/// Adds the command if it is missing: `wakesurf case.foam`. A word that is neither a command nor existing data counts as a mistyped
/// command, unless it looks like a file's name. Error: InvalidArgument, with the command that may be meant.
/// @param words  without the program
core::Result<CommandWords> with_command(const CLI::App& program, std::vector<std::string> words) {
    const auto as_serve = [&words] {
        words.insert(words.begin(), "serve");
        return CommandWords{std::move(words), true};
    };
    if (words.empty())
        return as_serve();
    const std::string first = words.front();
    if (first.starts_with('-')) {
        const bool known = program.get_option_no_throw(first) != nullptr;
        return known ? CommandWords{std::move(words), false} : as_serve();
    }
    const auto names = command_names(program);
    if (std::find(names.begin(), names.end(), first) != names.end())
        return CommandWords{std::move(words), false};
    if (const auto there = resolve_dataset(first);
        there || there.error().code != core::Error::Code::NotFound || !looks_like_command(first))
        return as_serve(); // which explains the error
    const std::string meant = protocol::nearest_name(first, names);
    return core::fail(core::Error::Code::InvalidArgument,
                      "`" + first +
                          "` is not a command, and there is no file or folder of this name",
                      meant.empty() ? "wakesurf --help lists the commands"
                                    : "did you mean `wakesurf " + meant + "`?");
}

void add_import_options(CLI::App& command, ImportOptions& options) {
    command.add_option("DATASET", options.dataset, "A file or folder of simulation results")
        ->required();
    command.add_option("STORE_DIR", options.store, "Folder to write the store to")->required();
    command
        .add_option("--precision", options.precision,
                    "single, or half: half the size, rounded by 2^-11 of each value")
        ->check(CLI::IsMember({"single", "half"}));
    wakesurf::command::add_layout_option(command, options.layout);
    command.add_option("--jobs", options.jobs, "Number of processes (default: one per core)")
        ->check(CLI::Range(1, 256));
    command
        .add_option("--memory", options.memory,
                    "Memory for all its processes, for example 4GiB (default: a quarter of the "
                    "memory of the machine or control group)")
        ->transform(wakesurf::command::as_memory_size());
    command
        .add_option("--fields", options.fields,
                    "Fields to keep beside the velocity, a,b (default: all scalars, and the "
                    "magnitudes of other vectors)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--times", options.times,
                       "T0:T1[:EVERY], several with commas: only time-steps in one of these");
    wakesurf::command::add_source_options(command, options.taken);
}

/// Adds an option for packagers: it prints a text made from the declarations, and exits.
void add_hidden(CLI::App& app, const char* option, std::function<std::string()> text) {
    app.add_flag_callback(option,
                          [text = std::move(text)] { throw CLI::CallForVersion(text(), 0); })
        ->group("");
}

int run(int argc, char** argv) {
    CLI::App app{"Integral surfaces of unsteady flow, interactively.", "wakesurf"};
    app.set_version_flag("--version", version_text(built_commit()));
    app.require_subcommand(1);
    add_hidden(app, "--man-page", [&] {
        return wakesurf::command::manual_page(app, {version_number(), manual_chapters()});
    });
    add_hidden(app, "--bash-completion",
               [&] { return bash_completion(app, app.get_subcommand("serve")); });
    std::function<int()> chosen;
    const auto command = [&](const char* name, const char* about, std::function<int()> action) {
        CLI::App* added = app.add_subcommand(name, about);
        added->callback([&chosen, action] { chosen = action; });
        return added;
    };

    ServeOptions serve;
    CLI::App& serve_command = *command("serve", "Serve datasets to browsers and scripts",
                                       [&] { return run_serve(serve); });
    add_serve_options(serve_command, serve);
    SessionsOptions sessions;
    add_sessions_options(*command("sessions",
                                  "List, rename, save and delete the sessions of a server",
                                  [&] { return run_sessions(sessions); }),
                         sessions);
    SurfaceOptions surface;
    add_surface_options(*command("surface", "Build one surface and write it to a file",
                                 [&] { return run_surface(surface); }),
                        surface);
    SurfaceOptions twin;
    add_twin_options(*command("twin",
                              "Build a surface and compare it with the same seeds in other data, "
                              "or with other settings",
                              [&] { return run_twin(twin); }),
                     twin);
    VerifyOptions verify;
    add_verify_options(*command("verify",
                                "Make the surface of a file again from the data, and compare",
                                [&] { return run_verify(verify); }),
                       verify);
    FamilyOptions family;
    add_family_options(*command("family",
                                "Make a family of stream surfaces as a scalar field of a dataset",
                                [&] { return run_family(family); }),
                       family);
    SliceOptions slice;
    add_slice_options(*command("slice", "Write fields on a plane through a dataset to a file",
                               [&] { return run_slice(slice); }),
                      slice);
    LinesOptions lines;
    add_lines_options(*command("lines", "Write streamlines of a dataset to a file",
                               [&] { return run_lines(lines); }),
                      lines);
    ProbeOptions probe;
    add_probe_options(*command("probe",
                               "Print fields of a dataset at points, along a line or over time",
                               [&] { return run_probe(probe); }),
                      probe);
    BodyOptions body;
    add_body_options(*command("body", "Write the walls of a dataset, with values, to a file",
                              [&] { return run_body(body); }),
                     body);
    MeansOptions means;
    add_means_options(*command("means",
                               "Make the mean and the rms over time of fields of a dataset, or "
                               "means by phase, as scalar fields",
                               [&] { return run_means(means); }),
                      means);
    InfoOptions info;
    auto* const info_command =
        command("info", "Describe a dataset", [&] { return run_info(info); });
    info_command
        ->add_option("DATASET", info.dataset,
                     "A file or folder of simulation results, a store or a Zarr or the https:// "
                     "address of one, or flow:NAME[?k=v,...]")
        ->required();
    wakesurf::command::add_source_options(*info_command, info.taken);
    info_command->add_flag("--json", info.json, "Print JSON");
    info_command
        ->add_option(
            "--memory", info.memory,
            "Memory for reading the files (default: a quarter of the memory of the machine "
            "or control group)")
        ->transform(wakesurf::command::as_memory_size());
    ImportOptions import;
    add_import_options(
        *command("import", "Convert a dataset into a store", [&] { return run_import(import); }),
        import);
    GenerateOptions generate;
    add_generate_options(*command("generate", "Sample a built-in flow into a store",
                                  [&] { return run_generate(generate); }),
                         generate);
    McpOptions mcp;
    add_mcp_options(*command("mcp", "Offer tools to AI agents over the Model Context Protocol",
                             [&] { return run_mcp(mcp); }),
                    mcp);
    StateCommandOptions state;
    add_state_commands(*app.add_subcommand("state",
                                           "Check, back up or restore the sessions a "
                                           "server keeps, or print records it could not use"),
                       state, chosen);
    BenchOptions bench;
    add_bench_options(*command("bench", "Measure how fast wakesurf is on this machine",
                               [&] { return run_bench(bench); }),
                      bench);

    // Comes last: each command would take it from the program.
    app.footer("Without a subcommand, `wakesurf [DATASET ...]` serves the data, or the bundled "
               "simulation, and opens\nthe page in the browser; options are those of serve.");
    auto given = with_command(app, {argv + 1, argv + argc});
    if (!given) {
        report_failure(given.error());
        return wrong_usage;
    }
    serve.open = given->implied;
    std::reverse(given->words.begin(), given->words.end()); // in the order of this parser
    try {
        app.parse(std::move(given->words));
        serve.port_by_chance = given->implied && serve_command.count("--listen") == 0 &&
                               from_environment("WAKESURF_LISTEN").empty();
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0)
            return app.exit(error); // --help, --version
        tell(stderr, "wakesurf: {} (see --help)\n", error.what());
        return wrong_usage;
    }
    return chosen();
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        wakesurf::server::tell(stderr, "wakesurf: {}\n", error.what());
        return failed;
    }
}
