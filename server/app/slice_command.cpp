#include "core/surface/measures/region.hpp"
#include "protocol/files/slice_files.hpp"
#include "server/app/command_options.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/output_files.hpp"
#include "server/app/progress_line.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/limits.hpp"
#include "server/base/process_account.hpp"
#include "server/data/region_text.hpp"
#include "server/data/slice_field.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;

namespace {

/// The memory for a sample in each file, its text included, in bytes.
constexpr std::size_t vts_bytes = 80, csv_bytes = 120;

/// Says in a name what was subtracted: another dataset, another time, or both.
std::string minus_words(const SliceOptions& options, double time) {
    const std::string then = options.minus_time ? fmt::format("t = {:g}", time) : "";
    if (options.minus.empty())
        return " (" + then + ")";
    return " (" + options.minus + (then.empty() ? ")" : ", " + then + ")");
}

/// Times each other, mean and area are the integral: of the velocity across the plane, what flows through it.
std::string numbers_words(const core::SliceRaster& raster) {
    if (!raster.range)
        return "none with a value";
    double sum = 0.0;
    std::size_t known = 0;
    for (const float value : raster.values)
        if (std::isfinite(value)) {
            sum += value;
            ++known;
        }
    const double area = glm::length(raster.window.across) * glm::length(raster.window.up) *
                        static_cast<double>(known) / static_cast<double>(raster.values.size());
    return fmt::format("{:.4g} to {:.4g}, mean {:.6g} over the area {:.6g}", (*raster.range)[0],
                       (*raster.range)[1], sum / static_cast<double>(known), area);
}

/// Data at a time.
struct DataThen {
    const LoadedDataset& dataset;
    double time;
};

/// Samples every field on the same window. @param minus  whose fields are subtracted; null: nothing is
Result<std::vector<protocol::NamedRaster>> sample_fields(const SliceOptions& options,
                                                         const core::Plane& plane,
                                                         const DataThen& data,
                                                         const DataThen* minus,
                                                         const std::stop_token& stop) {
    const LoadedDataset& dataset = data.dataset;
    std::vector<std::string> names = options.fields;
    if (names.empty())
        names = {dataset.info.velocity};
    std::vector<protocol::NamedRaster> out;
    for (const std::string& name : names) {
        const auto field = slice_field(name, dataset.info, dataset.scalars.get(), plane.normal);
        if (!field)
            return tl::unexpected(field.error());
        const ElapsedLine progress("sampling " + name);
        auto raster =
            core::sample_slice({plane, *field, data.time, options.samples}, *dataset.flow, stop);
        if (raster && minus != nullptr)
            raster = subtracted_field(name, dataset.info, minus->dataset.info,
                                      minus->dataset.scalars.get(), plane.normal)
                         .and_then([&](const core::SampledField& there) {
                             return core::slice_minus(*raster,
                                                      {plane, there, minus->time, options.samples},
                                                      *minus->dataset.flow, stop);
                         });
        if (!raster)
            return tl::unexpected(raster.error());
        out.push_back(
            {minus == nullptr ? name : name + " - " + name + minus_words(options, minus->time),
             std::move(*raster)});
    }
    return out;
}

Result<void> make(const SliceOptions& options, const std::stop_token& stop) {
    const std::filesystem::path file = options.output;
    const bool csv = file.extension() == ".csv";
    if (!csv && file.extension() != ".vts")
        return fail(Error::Code::InvalidArgument, "-o: a slice is written as .vts or .csv",
                    ".vts is for ParaView, .csv a table");
    const auto region = parse_region("plane:" + options.plane, "--plane");
    if (!region)
        return fail(Error::Code::InvalidArgument,
                    "--plane: '" + options.plane + "' is no point and normal",
                    "as in --plane 0,0,3:0,0,1");
    const auto& plane = std::get<core::Plane>(*region);
    const ProcessAccount process(options.memory);
    const auto dataset =
        open_for_command(options.dataset, options.store, options.taken, process.account(), stop);
    if (!dataset)
        return tl::unexpected(dataset.error());
    const auto time = chosen_time(options.time, *dataset);
    if (!time)
        return tl::unexpected(time.error());
    std::optional<Result<LoadedDataset>> other;
    if (!options.minus.empty())
        other =
            open_for_command(options.minus, options.store, options.taken, process.account(), stop);
    if (other && !*other)
        return tl::unexpected(other->error());
    const bool subtracts = other || options.minus_time;
    const LoadedDataset& subtracted = other ? **other : *dataset;
    const auto then =
        chosen_time(options.minus_time ? options.minus_time : *time, subtracted, "--minus-time");
    if (subtracts && !then)
        return tl::unexpected(then.error());
    const auto window = core::plane_window(plane, dataset->flow->domain());
    if (!window)
        return tl::unexpected(window.error());
    const auto [columns, rows] = core::raster_size(*window, options.samples);
    core::MemoryAccount::Share share = process.account().open(core::MemoryUse::Downloads);
    const std::size_t bytes =
        (std::max<std::size_t>(1, options.fields.size()) + (subtracts ? 1 : 0)) *
            core::slice_memory(columns, rows) +
        columns * rows * (csv ? csv_bytes : vts_bytes);
    if (!share.grow_to(bytes))
        return tl::unexpected(process.account().refusal("this slice", bytes));
    const DataThen minus{subtracted, then.value_or(0.0)};
    const auto fields =
        sample_fields(options, plane, {*dataset, *time}, subtracts ? &minus : nullptr, stop);
    if (!fields)
        return tl::unexpected(fields.error());
    return write_whole_file(file, csv ? protocol::slice_csv(*fields)
                                      : protocol::slice_vts(*fields, *time))
        .map([&] {
            for (const protocol::NamedRaster& each : *fields) {
                tell("{}: {}, t = {:g}, {} x {} samples, {}\n", options.output, each.name, *time,
                     columns, rows, numbers_words(each.raster));
            }
        });
}

} // namespace

void add_slice_options(CLI::App& command, SliceOptions& options) {
    add_dataset_argument(command, options.dataset);
    command
        .add_option("--plane", options.plane, "x,y,z:nx,ny,nz: a point of the plane and its normal")
        ->required();
    command
        .add_option("--fields", options.fields,
                    "Fields to sample, a,b: stored scalars, vorticity, q_criterion, components as "
                    "vorticity_z, velocity_normal across the plane (default: the speed)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command.add_option("--time", options.time, "Time of the slice (default: the last)")
        ->check(CLI::Number);
    command.add_option("--minus", options.minus,
                       "Dataset whose fields are subtracted (default with --minus-time: the same)");
    command
        .add_option("--minus-time", options.minus_time,
                    "Time of what is subtracted (default with --minus: that of the slice)")
        ->check(CLI::Number);
    command.add_option("--samples", options.samples, "Samples along the longer side")
        ->check(CLI::Range(std::size_t{1}, limits::slice_samples))
        ->capture_default_str();
    command.add_option("-o,--output", options.output, "File to write: .vts or .csv")->required();
    add_process_options(command, options);
}

int run_slice(const SliceOptions& options) {
    const StopOnSignal signals;
    const auto done = make(options, signals.token());
    return done ? 0 : report_refusal(done.error());
}

} // namespace wakesurf::server
