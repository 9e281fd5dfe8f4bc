#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/measures/numbers_over_time.hpp"
#include "core/surface/rake.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "protocol/files/numbers_csv.hpp"
#include "server/app/command_options.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/output_files.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/process_account.hpp"
#include "server/base/split.hpp"
#include "server/data/node_fields.hpp"
#include "server/data/probe.hpp"
#include "server/data/region_text.hpp"
#include "server/data/series_times.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;
using core::Vec3;

namespace {

constexpr std::size_t most_points = 1'000'000, most_times = 100'000;
/// Of a number in the table, in the text and in what is printed, and of a row beside, with its sample.
constexpr std::size_t bytes_per_number = 60, bytes_per_row = 200;

Result<Vec3> read_point(std::string_view text, const std::string& option) {
    if (const auto point = point_of(text))
        return *point;
    return fail(Error::Code::InvalidArgument,
                fmt::format("{}: '{}' is no point", option, text.substr(0, 200)),
                "three numbers with commas, as in 0.5,0,1");
}

struct Places {
    std::vector<Vec3> points;
    std::vector<double> distances; ///< along the line; empty: they are not on one
};

/// Returns points evenly along a line of straight pieces.
Result<Places> along_line(const std::string& text, std::size_t count) {
    core::Rake line{core::Rake::Kind::Polyline, {}, 2};
    for (const std::string_view part : split(text, ':')) {
        const auto point = read_point(part, "--line");
        if (!point)
            return tl::unexpected(point.error());
        line.points.push_back(*point);
    }
    if (!core::check_rake(line))
        return fail(Error::Code::InvalidArgument, "--line: it has no length",
                    "two points or more with colons, as in 0,0,1:4,0,1");
    const core::SeedingCurve curve(line);
    Places out;
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        out.distances.push_back(part * curve.length());
        out.points.push_back(curve.at(part));
    }
    return out;
}

Result<Places> read_places(const ProbeOptions& options) {
    if (!options.line.empty())
        return along_line(options.line, options.points);
    Places out;
    for (const std::string& text : options.at) {
        const auto point = read_point(text, "--at");
        if (!point)
            return tl::unexpected(point.error());
        out.points.push_back(*point);
    }
    if (out.points.empty())
        return fail(Error::Code::InvalidArgument, "neither --at nor --line says where",
                    "as in --at 0.5,0,1 or --line 0,0,1:4,0,1");
    return out;
}

Result<std::vector<double>> read_sample_times(const ProbeOptions& options,
                                              const LoadedDataset& dataset) {
    if (options.times.empty())
        return chosen_time(options.time, dataset).map([](double time) {
            return std::vector{time};
        });
    const auto& stored = dataset.info.times;
    if (dataset.info.steady || stored.size() == 1)
        return fail(Error::Code::InvalidArgument, "--times: the data have one time",
                    "leave it out: nothing changes");
    if (options.times == "stored") {
        if (stored.empty())
            return fail(Error::Code::InvalidArgument, "--times: the data have no stored times",
                        "give FIRST:LAST:EVERY");
        return stored;
    }
    const auto bounds = dataset.flow->time_bounds();
    return read_times(options.times, "--times").and_then([&](const SeriesTimes& times) {
        core::SurfaceParameters range;
        range.from = bounds ? (*bounds)[0] : std::min(times.first, times.last);
        range.to = bounds ? (*bounds)[1] : std::max(times.first, times.last);
        return times_in(times, range, most_times, "--times");
    });
}

/// A column of what is printed, and how it comes from what is sampled.
struct Quantity {
    enum class Of { Field, Speed, Component } of = Of::Field;
    core::NamedNumber column;
    std::size_t field = 0; ///< of the fields that are sampled
    int axis = 0;          ///< of a component
};

struct Wanted {
    std::vector<std::string> fields; ///< to sample
    std::vector<Quantity> quantities;
};

/// The velocity, by its name or as `velocity`, becomes its components; these and `speed` come of it unless a field has that name.
Result<Wanted> read_quantities(const std::vector<std::string>& names, const LoadedDataset& data) {
    const std::string& velocity = data.info.velocity;
    Wanted out;
    const auto place_of = [&](const std::string& field) {
        const auto found = std::find(out.fields.begin(), out.fields.end(), field);
        const auto place = static_cast<std::size_t>(found - out.fields.begin());
        if (found == out.fields.end())
            out.fields.push_back(field);
        return place;
    };
    const auto add = [&](Quantity::Of of, const std::string& name, const std::string& field,
                         int axis) {
        const auto same = [&](const Quantity& each) { return each.column.name == name; };
        if (std::any_of(out.quantities.begin(), out.quantities.end(), same))
            return;
        out.quantities.push_back({of,
                                  {name, 0, 0, core::not_known, core::unit_of(data.info, field)},
                                  place_of(field),
                                  axis});
    };
    const auto& components = core::velocity_component_names;
    for (const std::string& name : names) {
        const bool stored = data.scalars != nullptr && data.scalars->find(name);
        const auto* const component = std::find(components.begin(), components.end(), name);
        if (name == "speed" && !stored) {
            add(Quantity::Of::Speed, name, velocity, 0);
        } else if (name == velocity || (name == "velocity" && !stored)) {
            for (int axis = 0; axis < 3; ++axis)
                add(Quantity::Of::Component,
                    std::string(components[static_cast<std::size_t>(axis)]), velocity, axis);
        } else if (component != components.end() && !stored) {
            add(Quantity::Of::Component, name, velocity,
                static_cast<int>(component - components.begin()));
        } else {
            if (auto known = find_node_field(name, data.info, data.scalars.get(), "--fields");
                !known)
                return tl::unexpected(known.error());
            add(Quantity::Of::Field, name, name, 0);
        }
    }
    return out;
}

double value_of(const Quantity& quantity, const ProbeResult& found, std::size_t point) {
    const ProbeField& field = found.fields[quantity.field];
    switch (quantity.of) {
    case Quantity::Of::Speed:
        return glm::length(field.vectors[point]);
    case Quantity::Of::Component:
        return field.vectors[point][quantity.axis];
    default:
        // The digits that its precision has, not those that a double adds.
        return std::strtod(fmt::format("{}", field.scalars[point]).c_str(), nullptr);
    }
}

/// Prints what a command was asked for. Error: Io where the reader is gone or the disk full.
Result<void> print_text(const std::string& text) {
    const std::string shown = core::printable(text);
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size() &&
        std::fflush(stdout) == 0)
        return {};
    return fail(Error::Code::Io, "the table could not be printed whole", "write it to a file: -o");
}

Result<void> print_samples(const ProbeOptions& options, const std::stop_token& stop) {
    const auto places = read_places(options);
    if (!places)
        return tl::unexpected(places.error());
    const ProcessAccount process(options.memory);
    const auto dataset =
        open_for_command(options.dataset, options.store, options.taken, process.account(), stop);
    if (!dataset)
        return tl::unexpected(dataset.error());
    const auto times = read_sample_times(options, *dataset);
    if (!times)
        return tl::unexpected(times.error());
    const auto wanted = read_quantities(
        options.fields.empty() ? std::vector<std::string>{"speed", "velocity"} : options.fields,
        *dataset);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const bool line = !places->distances.empty();
    core::NumberTable table;
    const std::string& length_unit = dataset->info.length_unit;
    const core::NamedNumber time{"time", 0, 1};
    if (line)
        table.columns = {{"distance", 1, 0}};
    else
        table.columns = {time};
    for (const char* name : {"x", "y", "z"})
        table.columns.push_back({name, 1, 0});
    if (line)
        table.columns.push_back(time);
    for (const Quantity& each : wanted->quantities)
        table.columns.push_back(each.column);
    core::MemoryAccount::Share share = process.account().open(core::MemoryUse::Downloads);
    const std::size_t rows = times->size() * places->points.size();
    const std::size_t bytes = rows * (table.columns.size() * bytes_per_number + bytes_per_row);
    if (!share.grow_to(bytes))
        return tl::unexpected(process.account().refusal("this table", bytes));
    std::size_t outside = 0;
    {
        const ElapsedLine progress("sampling");
        for (const double at : *times) {
            const auto found = probe({dataset->info, *dataset->flow, dataset->scalars.get()},
                                     {places->points, at, wanted->fields}, stop);
            if (!found)
                return tl::unexpected(found.error());
            for (std::size_t i = 0; i < places->points.size(); ++i) {
                const Vec3& point = places->points[i];
                std::vector<double> row{line ? places->distances[i] : at, point.x, point.y,
                                        point.z};
                if (line)
                    row.push_back(at);
                for (const Quantity& each : wanted->quantities)
                    row.push_back(value_of(each, *found, i));
                table.rows.push_back(std::move(row));
                outside += found->inside[i] ? 0 : 1;
            }
        }
    }
    const std::string text = protocol::numbers_csv(table, length_unit, dataset->info.time_unit);
    if (auto written =
            options.output.empty() ? print_text(text) : write_whole_file(options.output, text);
        !written)
        return written;
    if (!options.output.empty())
        tell("{}: {} rows\n", options.output, rows);
    if (outside > 0)
        tell(stderr, "wakesurf: {} of {} rows are of no place in the fluid, and have no values\n",
             outside, rows);
    return {};
}

} // namespace

void add_probe_options(CLI::App& command, ProbeOptions& options) {
    add_dataset_argument(command, options.dataset);
    CLI::Option* const at =
        command.add_option("--at", options.at, "A point, x,y,z; may be given again")
            ->allow_extra_args(false);
    command
        .add_option("--line", options.line,
                    "Points evenly along a line, x,y,z:x,y,z; more corners with colons")
        ->excludes(at);
    command.add_option("--points", options.points, "Points along the line (default: 401)")
        ->check(CLI::Range(std::size_t{2}, most_points));
    command
        .add_option("--fields", options.fields,
                    "Fields, a,b: stored scalars, the velocity, speed, velocity_x, vorticity, "
                    "q_criterion (default: speed and velocity)")
        ->delimiter(',')
        ->allow_extra_args(false);
    CLI::Option* const time =
        command.add_option("--time", options.time, "Time of the values (default: the last)")
            ->check(CLI::Number);
    command
        .add_option("--times", options.times,
                    "Times FIRST:LAST:EVERY, or `stored` for all time-steps: a row each")
        ->excludes(time);
    command.add_option("-o,--output", options.output, "CSV file (default: print it)");
    add_process_options(command, options);
}

int run_probe(const ProbeOptions& options) {
    const StopOnSignal signals;
    const auto done = print_samples(options, signals.token());
    return done ? 0 : report_refusal(done.error());
}

} // namespace wakesurf::server
