#include "core/field/analytic_flow.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/dataset_json.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/stop_tokens.hpp"
#include "server/base/field_names.hpp"
#include "server/base/process_account.hpp"
#include "server/data/dataset_argument.hpp"
#include "server/data/import_process.hpp"
#include "server/data/open_dataset.hpp"
#include "server/remote/remote_dataset.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <variant>
#include <vector>

namespace wakesurf::server {

using nlohmann::json;

namespace {

/// Holds the description of a dataset, and what was derived from it.
struct Described {
    core::DatasetInfo info;
    std::vector<core::FamilyRecord> families;
    std::vector<core::MeanRecord> means{};
    std::string stored{}; ///< how the time-steps of a store lie on the disk
    bool by_brick = false;
    std::string served{}; ///< how a server on this machine would have them in memory, and why
};

/// Describes how a server with default memory would hold the dataset. @param zarr  null if the data are a
/// store
void say_how_served(const store::StoreReader& reader,
                    const std::optional<ChunkMemory>& zarr,
                    Described& out) {
    const std::size_t memory = default_memory();
    core::TimeStepCache::Options options;
    options.account = core::MemoryAccount(memory);
    const HowServed how = how_served(reader, options, zarr ? zarr->least : 0);
    out.by_brick = how.by_brick;
    if (how.by_brick && is_on_the_web(reader.layout().folder)) {
        out.served = fmt::format("brick by brick: the {} is on the web", zarr ? "Zarr" : "store");
        return;
    }
    const std::size_t window = core::TimeStepCache::smallest_window(reader);
    const bool fits = window <= how.room;
    const auto mebibytes = [](std::size_t bytes) {
        return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20));
    };
    out.served =
        fmt::format("{}: {} time-steps take {}, {} than the {} that a server's memory here ({}, "
                    "--memory) has for them{}",
                    out.by_brick ? "brick by brick" : "whole time-steps",
                    window / std::max<std::size_t>(1, reader.bytes_per_step()), mebibytes(window),
                    fits ? "no more" : "more", mebibytes(how.room), mebibytes(memory),
                    !fits && !out.by_brick ? "; bricks need a store with --layout bricks" : "");
}

/// Describes a store; the note says if its import did not end, or has not ended yet.
core::Result<Described> describe_store(const std::filesystem::path& folder) {
    const auto opened_disk = open_disk(folder, scalar_bytes(default_memory()));
    if (!opened_disk)
        return tl::unexpected(opened_disk.error());
    const std::shared_ptr<const core::Disk>& disk = opened_disk->disk;
    auto manifest = store::read_store_manifest(folder, *disk);
    if (!manifest)
        return tl::unexpected(manifest.error());
    const auto reader = store::StoreReader::open(store::store_layout(*manifest, folder), disk);
    if (!reader)
        return tl::unexpected(reader.error());
    const std::size_t total = manifest->info.times.size();
    std::size_t ready = 0;
    for (std::size_t i = 0; i < total; ++i)
        ready += (*reader)->ready(i) ? 1 : 0;
    if (ready < total)
        manifest->info.note +=
            fmt::format("{}incomplete: {} of {} time-steps are stored; `wakesurf import` into the "
                        "same folder goes on",
                        manifest->info.note.empty() ? "" : "; ", ready, total);
    const auto scalars = store::StoreScalars::open(*reader, disk);
    list_kept_fields(manifest->info, *scalars);
    const auto cells = manifest->layout.brick_cells;
    Described out{std::move(manifest->info), scalars->families(), scalars->means(),
                  opened_disk->zarr ? std::string("chunks of a Zarr")
                  : cells == 0      ? std::string("whole time-steps")
                                    : fmt::format("bricks of {} cells", cells)};
    say_how_served(**reader, opened_disk->zarr, out);
    return out;
}

/// Adds the families and means, which are in the store that the source was imported into.
core::Result<Described> with_kept_fields_of_import(const DatasetArgument& source,
                                                   const InfoOptions& options,
                                                   core::DatasetInfo info) {
    const auto imported = describe_store(store_folder(default_store_root(), source, options.taken));
    Described out{std::move(info), {}};
    if (!imported)
        return out;
    out.families = imported->families;
    out.means = imported->means;
    std::ranges::copy_if(imported->info.fields, std::back_inserter(out.info.fields),
                         &core::FieldInfo::kept);
    return out;
}

core::Result<Described> describe(const DatasetArgument& argument, const InfoOptions& options) {
    if (auto fit = check_source_options(argument, options.taken); !fit)
        return tl::unexpected(fit.error());
    switch (argument.kind) {
    case DatasetArgument::Kind::Flow:
        return core::describe_analytic_flow(argument.flow).map([](core::DatasetInfo info) {
            return Described{std::move(info), {}};
        });
    case DatasetArgument::Kind::Store:
        return describe_store(argument.path);
    case DatasetArgument::Kind::Source:
        break;
    }
    const StopOnSignal signals;
    return describe_with_import_process(
               {argument.path, {}, {}, {}, {}, {}, 0, options.memory, options.taken},
               signals.token())
        .and_then([&](core::DatasetInfo info) {
            return with_kept_fields_of_import(argument, options, std::move(info));
        });
}

std::vector<std::string> carried_fields(const core::DatasetInfo& info) {
    std::vector<std::string> stored;
    for (const core::FieldInfo& field : info.fields)
        if (field.stored && field.name != info.velocity)
            stored.push_back(field.name);
    return vertex_field_names(std::move(stored), info);
}

std::string range_words(const std::array<double, 2>& range) {
    return std::isnan(range[0]) ? std::string("range not known")
                                : fmt::format("{:g} to {:g}", range[0], range[1]);
}

std::string made_from(const core::FamilyRequest& request) {
    if (std::holds_alternative<core::Rake>(request.source))
        return "the distance from a curve";
    return request.scalar + (std::holds_alternative<core::FamilyPlane>(request.source)
                                 ? " on a plane"
                                 : " where the flow enters");
}

void print_family(const core::FamilyRecord& family) {
    tell("  family    {}: {}\n", family.name, made_from(family.request));
    for (const core::FamilyStep& step : family.steps)
        tell("            at time {:.12g}: {:.4g} to {:.4g}, {} of {} nodes have a value\n",
             step.time, step.counts.range[0], step.counts.range[1], step.counts.reached,
             step.counts.nodes);
}

void print_mean(const core::MeanRecord& mean) {
    tell("  mean      of {} over {} time-steps, {:.12g} to {:.12g}{}\n", mean.of, mean.steps,
         mean.from, mean.to,
         mean.phases == 0 ? std::string()
                          : fmt::format(", by {} phases of {:g}", mean.phases, mean.period));
    for (const core::MeanField& each : mean.fields)
        tell("            {}: {:.4g} to {:.4g}\n", each.name, each.range[0], each.range[1]);
}

json described_json(const Described& described) {
    json out = protocol::written(described.info);
    out["surfaceFields"] = carried_fields(described.info);
    if (!described.served.empty()) {
        out["stored"] = described.stored;
        out["served"] = {{"by", described.by_brick ? "brick" : "timeStep"},
                         {"why", described.served}};
    }
    for (const core::FamilyRecord& each : described.families)
        out["families"].push_back(protocol::written(each));
    for (const core::MeanRecord& each : described.means)
        out["means"].push_back(protocol::written(each));
    return out;
}

std::string grid_text(const core::DatasetInfo& info) {
    const auto& d = info.dimensions;
    const auto name = protocol::name(info.grid);
    switch (info.grid) {
    case core::GridKind::Analytic:
        return std::string(name);
    case core::GridKind::Uniform:
        return fmt::format("{}, {} x {} x {} nodes, spacing {:g} x {:g} x {:g}", name, d[0], d[1],
                           d[2], info.spacing.x, info.spacing.y, info.spacing.z);
    case core::GridKind::Rectilinear:
        return fmt::format("{}, {} x {} x {} nodes", name, d[0], d[1], d[2]);
    default:
        return fmt::format("{}, {} points, {} cells", name, info.points, info.cells);
    }
}

void print_text(const Described& described) {
    const core::DatasetInfo& info = described.info;
    const std::string& stored = described.stored;
    const auto& [lo, hi] = info.bounds;
    tell("{}\n  reader    {}\n  grid      {}\n", info.name, info.reader, grid_text(info));
    tell("  bounds    x {:g} to {:g}, y {:g} to {:g}, z {:g} to {:g}\n", lo.x, hi.x, lo.y, hi.y,
         lo.z, hi.z);
    if (core::any(info.periodic))
        tell("  periodic  {}\n", core::axes_text(info.periodic));
    if (!info.times.empty())
        tell("  times     {} from {:.12g} to {:.12g}{}\n", info.times.size(), info.times.front(),
             info.times.back(), info.steady ? " (steady)" : "");
    tell("  velocity  {}: {}\n", info.velocity, info.why);
    const bool half = info.precision == core::Precision::Half;
    if (half || !stored.empty())
        tell("  stored    {}{}{}\n", stored, half && !stored.empty() ? ", " : "",
             half ? "in half precision" : "");
    if (!described.served.empty())
        tell("  served    {}\n", described.served);
    if (!info.note.empty())
        tell("  note      {}\n", info.note);
    for (const auto& field : info.fields)
        if (!field.kept())
            tell("  field     {}, {} component{}, {} data, {}{}{}{}\n", field.name,
                 field.components, field.components == 1 ? "" : "s",
                 field.source == core::FieldInfo::Source::Cell ? "cell" : "point",
                 range_words(field.range), field.unit.empty() ? "" : " ", field.unit,
                 field.stored ? "" : "; not stored, so surfaces cannot carry it");
    for (const core::FamilyRecord& each : described.families)
        print_family(each);
    for (const core::MeanRecord& each : described.means)
        print_mean(each);
    tell("  carried   {}: what surfaces can carry (--fields)\n",
         fmt::join(carried_fields(info), ", "));
    tell("  obstacle  {}\n", info.obstacle ? "yes" : "no");
    if (info.bytes_per_step > 0)
        tell("  memory    {:.1f} MiB a time-step\n",
             static_cast<double>(info.bytes_per_step) / (1 << 20));
}

} // namespace

int run_info(const InfoOptions& options) {
    const auto found =
        resolve_dataset(options.dataset).and_then([&](const DatasetArgument& argument) {
            return describe(argument, options);
        });
    if (!found) {
        const int status = report_failure(found.error());
        return found.error().code == core::Error::Code::InvalidArgument &&
                       found.error().message.starts_with("--")
                   ? 2
                   : status;
    }
    if (options.json)
        tell("{}\n", protocol::json_text(described_json(*found), 2));
    else
        print_text(*found);
    return 0;
}

} // namespace wakesurf::server
