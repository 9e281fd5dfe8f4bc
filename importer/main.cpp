// wakesurf-import: anything VTK reads -> a store, in a process of its own, so that a hostile or damaged file
// harms nothing else.
#include "core/base/plain_text.hpp"
#include "importer/base/library_messages.hpp"
#include "importer/base/limited_rights.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/base/watched_process.hpp"
#include "importer/conversion.hpp"
#include "importer/rake_file.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/openfoam/openfoam_case.hpp"
#include "importer/step_workers.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/dataset_json.hpp"
#include "store/command/manual_page.hpp"
#include "store/command/memory_size.hpp"
#include "store/command/source_options.hpp"
#include "store/store_writer.hpp"

#include <CLI/CLI.hpp>
#include <malloc.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace wakesurf;

/// Holds the options of the command line.
struct Wish {
    importer::ImportRequest request;
    importer::ImportBounds bounds;
    std::string store; ///< empty: describe the source only
    bool show_libraries = false;
    bool errors_are_shared = false;
    std::vector<std::filesystem::path> secrets; ///< of the server that started this
    std::string rake; ///< "line" or "points": print those of the source, a rake's file; else empty
    int parent = 0;   ///< ends with this process; 0: with none
};

std::string name_of(const std::filesystem::path& source) {
    return (source.has_filename() ? source : source.parent_path()).filename().string();
}

// Returns folders that no message may name: those of the source and of the store, as given and as resolved.
std::vector<std::filesystem::path> folders_of(const Wish& wish) {
    std::vector<std::filesystem::path> out;
    for (const auto& path : std::array<std::filesystem::path, 2>{wish.request.source, wish.store}) {
        std::error_code error;
        for (const auto& form : {path, std::filesystem::weakly_canonical(path, error)})
            out.push_back(form.parent_path());
    }
    return out;
}

int failed(std::FILE* stream, const Wish& wish, core::Error error) {
    if (error.code == core::Error::Code::OverLimit && !error.limit)
        error = importer::with_memory_bound(std::move(error), wish.bounds.memory);
    const std::string hint = error.hint.empty() ? "" : " (" + error.hint + ")";
    const std::string words = importer::without_folders(error.message + hint, folders_of(wish));
    std::fprintf(stream, "wakesurf-import: %s\n", core::printable_line(words).c_str());
    return error.code == core::Error::Code::InvalidArgument && error.message.starts_with("--") ? 2
                                                                                               : 1;
}

int print_rake(const Wish& wish, const importer::OwnOutput& out) {
    const auto points = importer::read_rake_file(wish.request.source, wish.rake == "points");
    if (!points)
        return failed(out.errors, wish, points.error());
    for (const auto& p : *points)
        std::fprintf(out.results, "%.17g,%.17g,%.17g\n", p.x, p.y, p.z);
    return 0;
}

int run(const Wish& wish, const importer::OwnOutput& out) {
    if (!wish.rake.empty())
        return print_rake(wish, out);
    if (wish.store.empty()) {
        auto info = importer::describe_source(wish.request);
        if (!info)
            return failed(out.errors, wish, info.error());
        info->note = importer::without_folders(info->note, folders_of(wish));
        std::fprintf(out.results, "%s\n", protocol::json_text(protocol::written(*info), 2).c_str());
        return 0;
    }
    bool rights_told = importer::kernel_has_landlock();
    const auto show = [&](store::ImportProgress progress) {
        importer::made_progress();
        if (!std::exchange(rights_told, true))
            progress.note +=
                (progress.note.empty() ? "" : "; ") +
                std::string("this kernel has no Landlock: the process that reads the files could "
                            "read and write wherever you can");
        if (::isatty(::fileno(out.results)) != 0)
            store::show_progress(progress, out.results);
        else
            std::fprintf(out.results, "%s\n", store::progress_line(progress).c_str());
        std::fflush(out.results);
    };
    const auto converted = importer::convert(wish.request, wish.store, show);
    return converted ? 0 : failed(out.errors, wish, converted.error());
}

// Leaves out what the source lies in: who named it has it read. A link among the data does not say that its author may
// have what it leads to.
std::vector<std::filesystem::path> secrets_of(const Wish& wish) {
    const auto given = std::filesystem::absolute(wish.request.source);
    const auto source = std::filesystem::weakly_canonical(given.parent_path()) / given.filename();
    auto named = wish.secrets;
    for (const char* name : {"WAKESURF_STATE", "WAKESURF_TOKEN_FILE"})
        if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
            named.emplace_back(value);
    std::vector<std::filesystem::path> out;
    for (const auto& each : named) {
        auto secret = std::filesystem::weakly_canonical(each);
        if (std::ranges::mismatch(secret, source).in1 != secret.end())
            out.push_back(std::move(secret));
    }
    return out;
}

importer::LimitedRights rights_of(const Wish& wish) {
    importer::LimitedRights rights;
    rights.secrets = secrets_of(wish);
    if (!wish.store.empty())
        rights.store = wish.store;
    rights.sources = {wish.request.source};
    if (wish.rake.empty())
        rights.sources.push_back(importer::openfoam_folder(wish.request.source));
    if (wish.rake.empty() && !wish.request.taken.confined)
        rights.sources.emplace_back("/");
    return rights;
}

// Runs in the watched process.
int read_and_convert(const Wish& wish) {
    const auto out = importer::take_outputs(wish.show_libraries);
    if (!wish.request.taken.confined)
        importer::allow_paths_out_of_folder();
    store::end_on_signals({}, importer::end_step_workers);
    if (wish.errors_are_shared)
        importer::send_library_messages_to(out.errors);
    // Every time-step needs as much memory as the one before: freed memory is kept, not returned and cleared
    // again.
    ::mallopt(M_MMAP_MAX, 0);
    ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    try {
        const auto rights = rights_of(wish);
        importer::refuse_secrets(rights.secrets);
        if (auto limited = importer::limit_rights(rights); !limited)
            return failed(out.errors, wish, limited.error());
        const auto readable = importer::check_readable(wish.request.source,
                                                       name_of(wish.request.source) + " is a file");
        return readable ? run(wish, out) : failed(out.errors, wish, readable.error());
    } catch (const std::exception& error) {
        return failed(out.errors, wish, importer::error_of(error, name_of(wish.request.source)));
    }
}

void add_bounds(CLI::App& app, importer::ImportBounds& bounds) {
    const auto seconds = [&app](const char* name, std::chrono::seconds& value, const char* about) {
        app.add_option_function<unsigned>(
               name, [&value](unsigned count) { value = std::chrono::seconds(count); }, about)
            ->default_str(std::to_string(value.count()));
    };
    seconds("--stall", bounds.stall, "give up after this many seconds without progress; 0: never");
    seconds("--survey", bounds.survey,
            "the same while SOURCE is examined, for each of its files; 0: never");
    app.add_option("--memory", bounds.memory,
                   "memory for all processes together, for example 4GiB (default: a quarter of the "
                   "memory of "
                   "the machine or control group)")
        ->transform(command::as_memory_size());
}

constexpr std::string_view manual_chapters = ".SH EXIT STATUS\n0 done, 1 failed, 2 wrong usage.\n"
                                             ".SH SEE ALSO\n\\fBwakesurf\\fR(1), whose command "
                                             "\\fBimport\\fR starts this program\n";

} // namespace

int main(int argc, char** argv) {
    Wish wish;
    std::string source;
    std::string times;
    std::string precision = "single";
    std::string layout = "auto";
    bool describe_only = false;
    CLI::App app("Converts a simulation of any format VTK reads into a wakesurf store.",
                 "wakesurf-import");
    app.add_option("SOURCE", source,
                   "a file, a collection, the first of a numbered series, a case folder")
        ->required();
    auto* folder =
        app.add_option("STORE_DIR", wish.store, "the store's folder, created if missing");
    app.add_option("--fields", wish.request.fields,
                   "scalars to keep beside the velocity, and vectors to keep the magnitudes of")
        ->delimiter(',')
        ->allow_extra_args(false);
    app.add_option(
        "--times", times,
        "T0:T1[:EVERY]: times from T0 to T1, both included; only every EVERY-th time-step; several "
        "with commas between them");
    command::add_source_options(app, wish.request.taken);
    app.add_option("--precision", precision, "single, or half: half the size, rounded to 2^-11")
        ->check(CLI::IsMember({"single", "half"}));
    command::add_layout_option(app, layout);
    app.add_option("--jobs", wish.request.jobs,
                   "number of processes that convert time-steps (default: one per core)")
        ->check(CLI::Range(1, 256));
    add_bounds(app, wish.bounds);
    app.add_flag("--library-output", wish.show_libraries,
                 "show on standard error what the file libraries print");
    app.add_option("--parent", wish.parent, "end when this process, which started it, ends")
        ->group("");
    app.add_flag(
           "--growing", wish.request.growing,
           "keep the time of a time-step that cannot be read yet, and end there with an error")
        ->group("");
    app.add_flag("--told-to-others", wish.errors_are_shared,
                 "print what libraries say in lines of its own, not in errors")
        ->group("");
    app.add_option("--secret", wish.secrets, "a file or folder that is not read, whoever names it")
        ->group("");
    auto* describe = app.add_flag("--describe", describe_only,
                                  "print a description of SOURCE as JSON; write nothing");
    auto* rake = app.add_option("--rake", wish.rake, "print the points of a rake in a file")
                     ->check(CLI::IsMember({"line", "points"}))
                     ->group("");
    app.add_flag_callback("--man-page",
                          [&app] {
                              throw CLI::CallForVersion(
                                  command::manual_page(app, {WAKESURF_VERSION, manual_chapters}),
                                  0);
                          })
        ->group(""); // for who makes packages
    try {
        app.parse(argc, argv);
        if (folder->count() + describe->count() + rake->count() != 1)
            throw CLI::ValidationError("STORE_DIR", "give a folder, or --describe");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    wish.request.source = source;
    if (!times.empty()) {
        const auto selection = importer::parse_times(times);
        if (!selection)
            return failed(stderr, wish, selection.error());
        wish.request.times = *selection;
    }
    for (const auto& field : wish.request.fields)
        wish.request.selection += "field " + field + " ";
    wish.request.selection += times.empty() ? "" : "times " + times;
    for (const auto& option : command::arguments_of(wish.request.taken))
        if (option != "--confined")
            wish.request.selection += " " + option;
    wish.request.precision = precision == "half" ? core::Precision::Half : core::Precision::Single;
    wish.request.placement = *store::parse_step_placement(layout);
    if (wish.bounds.memory == 0)
        wish.bounds.memory = importer::usual_import_memory();
    wish.request.memory = wish.bounds.memory;
    if (wish.parent > 0 && !importer::end_with(wish.parent))
        return 1;
    const auto ended = importer::run_watched(name_of(source), wish.bounds,
                                             [&wish] { return read_and_convert(wish); });
    return ended ? *ended : failed(stderr, wish, ended.error());
}
