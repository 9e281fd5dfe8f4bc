#include "core/field/analytic_flow.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/split.hpp"
#include "store/command/source_options.hpp"
#include "store/store_generation.hpp"
#include "store/store_grid.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <vector>

namespace wakesurf::server {

namespace {

using Code = core::Error::Code;

// A longer manifest would be refused by readers.
constexpr std::size_t most_times = 100'000;

template <class Number>
std::optional<Number> number_of(std::string_view text) {
    Number value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

core::Result<core::UniformGrid> grid_over(const core::Box& box, const std::string& text) {
    core::UniformGrid grid;
    const auto parts = split(text, ',');
    bool sound = parts.size() == 3;
    for (std::size_t axis = 0; sound && axis < 3; ++axis) {
        const auto nodes = number_of<std::uint32_t>(parts[axis]);
        sound = nodes && *nodes >= 2;
        grid.dimensions[axis] = nodes.value_or(2);
    }
    if (!sound)
        return core::fail(Code::InvalidArgument,
                          "--grid: '" + text + "' is not three numbers of nodes, each at least 2",
                          "as in --grid 64,64,64");
    const auto& d = grid.dimensions;
    grid.origin = box.lo;
    grid.spacing = box.extent() / core::Vec3(d[0] - 1.0, d[1] - 1.0, d[2] - 1.0);
    if (auto size = store::check_grid(store::stored_grid(grid)); !size)
        return core::fail(Code::InvalidArgument, "--grid: " + size.error().message);
    return grid;
}

core::Result<std::vector<double>> times_of(const std::string& text) {
    const auto refused = core::fail(
        Code::InvalidArgument, "--times: '" + text + "' is not T0:T1:N, N time-steps from T0 to T1",
        "as in --times 0:10:21, with N from 1 to " + std::to_string(most_times));
    const auto parts = split(text, ':');
    if (parts.size() != 3)
        return refused;
    const auto first = number_of<double>(parts[0]);
    const auto last = number_of<double>(parts[1]);
    const auto count = number_of<std::size_t>(parts[2]);
    if (!first || !last || !count || !std::isfinite(*first) || !std::isfinite(*last) ||
        *count < 1 || *count > most_times || (*count > 1 && !(*first < *last)))
        return refused;
    std::vector<double> times{*first};
    for (std::size_t i = 1; i < *count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(*count - 1);
        times.push_back(i + 1 == *count ? *last : *first + (*last - *first) * part);
        if (!(times[i - 1] < times[i]))
            return core::fail(Code::InvalidArgument,
                              "--times: '" + text + "' has time-steps that are too close together",
                              "choose fewer");
    }
    return times;
}

std::string specification(const GenerateOptions& options) {
    constexpr std::string_view prefix = "flow:";
    std::string flow =
        options.flow.starts_with(prefix) ? options.flow.substr(prefix.size()) : options.flow;
    if (!options.parameters.empty())
        flow += (flow.find('?') == std::string::npos ? "?" : ",") + options.parameters;
    return flow;
}

// Checks the options. Error: InvalidArgument for wrong usage, NotFound for an unknown flow, listing the known
// ones.
core::Result<store::GenerateRequest> check_generate_options(const GenerateOptions& options) {
    store::GenerateRequest request;
    request.flow = specification(options);
    const auto info = core::describe_analytic_flow(request.flow);
    if (!info)
        return tl::unexpected(info.error());
    const auto grid = grid_over(info->bounds, options.grid);
    if (!grid)
        return tl::unexpected(grid.error());
    request.grid = *grid;
    auto times = options.times.empty() ? info->times : times_of(options.times);
    if (!times)
        return tl::unexpected(times.error());
    request.times = std::move(*times);
    const auto placement = store::parse_step_placement(options.layout);
    if (!placement)
        return tl::unexpected(placement.error());
    request.placement = *placement;
    return request;
}

} // namespace

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
    if (!request)
        return report_refusal(request.error());
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
