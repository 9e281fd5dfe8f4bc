#include "server/cli/generate_command.hpp"

#include "command/layout_option.hpp"
#include "server/cli/failure.hpp"
#include "server/cli/generate_request.hpp"
#include "server/cli/stop_on_signal.hpp"
#include "server/cli/tell.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace wakesurf::server {

void add_generate_options(CLI::App& command, GenerateOptions& options) {
    command.add_option("FLOW", options.flow, "A built-in flow: NAME, flow:NAME or NAME?k=v,...")
        ->required();
    command.add_option("OUT_DIR", options.folder, "Folder to write the store to")->required();
    command.add_option("--grid", options.grid, "Nodes over the flow's domain, NX,NY,NZ")
        ->capture_default_str();
    command.add_option("--times", options.times,
                       "T0:T1:N, N time-steps (default: 0:10:21, or one of a steady flow)");
    command.add_option("--parameters", options.parameters, "Parameters of the flow, k=v,...");
    command::add_layout_option(command, options.layout);
}

int run_generate(const GenerateOptions& options) {
    const auto request = check_generate_options(options);
    if (!request) {
        const int status = report_failure(request.error());
        return request.error().code == core::Error::Code::InvalidArgument ? wrong_usage : status;
    }
    const StopOnSignal signals;
    const auto show = [](const store::ImportProgress& progress) {
        store::show_progress(progress, stdout, "generate");
    };
    const auto generated = store::generate_store(*request, options.folder, show, signals.token());
    if (!generated) {
        if (::isatty(STDOUT_FILENO) != 0)
            std::puts(""); // ends the line of the bar
        return report_failure(generated.error());
    }
    const auto& d = request->grid.dimensions;
    tell("{}: {} time-step{} of {} x {} x {} nodes, {:.1f} MB\n", options.folder,
         request->times.size(), request->times.size() == 1 ? "" : "s", d[0], d[1], d[2],
         static_cast<double>(*store::generated_bytes(*request)) * 1e-6);
    return 0;
}

} // namespace wakesurf::server
