// wakesurf-import: anything VTK reads -> a store, in a process of its own, so that a hostile or damaged file
// hurts nobody else.
#include "protocol/dataset_json.hpp"
#include "protocol/json_text.hpp"
#include "server/catalogue/store_writer.hpp"
#include "server/import/conversion.hpp"
#include "server/import/limited_rights.hpp"
#include "server/import/step_workers.hpp"

#include <CLI/CLI.hpp>
#include <malloc.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cstdio>
#include <limits>

namespace {

using namespace wakesurf;

int failed(const core::Error& error) {
    const std::string hint = error.hint.empty() ? "" : " (" + error.hint + ")";
    std::fprintf(stderr, "wakesurf-import: %s%s\n", error.message.c_str(), hint.c_str());
    return error.code == core::Error::Code::InvalidArgument && error.message.starts_with("--") ? 2
                                                                                               : 1;
}

void show(const server::ImportProgress& progress) {
    server::made_progress();
    if (::isatty(STDOUT_FILENO) != 0) {
        server::show_progress(progress, stdout);
    } else {
        std::puts(server::progress_line(progress).c_str());
        std::fflush(stdout);
    }
}

int run(const server::ImportRequest& request, const std::string& store, bool describe_only) {
    if (describe_only) {
        const auto info = server::describe_source(request);
        if (!info)
            return failed(info.error());
        std::puts(protocol::json_text(protocol::dataset_json(*info), 2).c_str());
        return 0;
    }
    const auto converted = server::convert(request, store, show);
    return converted ? 0 : failed(converted.error());
}

} // namespace

int main(int argc, char** argv) {
    server::ImportRequest request;
    std::string source;
    std::string store;
    std::string times;
    std::string precision = "single";
    unsigned stall = 1800;
    bool describe_only = false;
    CLI::App app("Converts a simulation of any format VTK reads into a wakesurf store.",
                 "wakesurf-import");
    app.add_option("SOURCE", source,
                   "a file, a collection, the first of a numbered series, a case folder")
        ->required();
    auto* folder = app.add_option("STORE_DIR", store, "the store's folder, made when missing");
    app.add_option("--fields", request.fields,
                   "names of the velocity (or of its parts), of scalars, and of vectors to keep "
                   "the magnitudes of")
        ->delimiter(',');
    app.add_option("--times", times, "T0:T1[:EVERY], both included; every EVERY-th time-step");
    app.add_option("--precision", precision, "single, or half: half the size, rounded to 2^-11")
        ->check(CLI::IsMember({"single", "half"}));
    app.add_option("--jobs", request.jobs,
                   "processes that convert time-steps at once; default: one a core")
        ->check(CLI::Range(1, 256));
    app.add_option("--stall", stall, "seconds without progress after which to give up; 0: never")
        ->capture_default_str();
    auto* describe =
        app.add_flag("--describe", describe_only, "print what SOURCE is as JSON, write nothing");
    try {
        app.parse(argc, argv);
        if (folder->count() == describe->count())
            throw CLI::ValidationError("STORE_DIR", "give a folder, or --describe");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    if (!times.empty()) {
        const auto selection = server::parse_times(times);
        if (!selection)
            return failed(selection.error());
        request.times = *selection;
    }
    request.source = source;
    for (const auto& field : request.fields)
        request.selection += "field " + field + " ";
    request.selection += times.empty() ? "" : "times " + times;
    request.precision = precision == "half" ? core::Precision::Half : core::Precision::Single;
    server::end_on_signals(
        "wakesurf-import: interrupted; the same command goes on where this one ended\n",
        server::end_step_workers);
    server::end_on_alarm("wakesurf-import: no progress for longer than --stall allows; the same "
                         "command goes on where this one ended\n");
    server::LimitedRights rights{std::nullopt, std::chrono::seconds(stall)};
    if (!describe_only)
        rights.store = store;
    server::limit_rights(rights);
    // Every time-step needs as much memory as the one before: what is freed is kept, not given back and cleared anew.
    ::mallopt(M_MMAP_MAX, 0);
    ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    try {
        return run(request, store, describe_only);
    } catch (const std::exception& error) {
        return failed({core::Error::Code::Io, std::string("unexpected: ") + error.what(), {}});
    }
}
