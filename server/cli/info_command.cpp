#include "server/cli/info_command.hpp"

#include "core/field/analytic_flow.hpp"
#include "protocol/api/dataset_json.hpp"
#include "protocol/api/json_text.hpp"
#include "server/catalogue/dataset_argument.hpp"
#include "server/catalogue/import_process.hpp"
#include "server/catalogue/open_dataset.hpp"
#include "server/cli/failure.hpp"
#include "server/cli/stop_on_signal.hpp"
#include "server/cli/tell.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace wakesurf::server {

namespace {

/// Of a store whose import did not end, or has not ended yet, the note says so.
core::Result<core::DatasetInfo> describe_store(const std::filesystem::path& folder) {
    const auto disk = std::make_shared<core::PosixDisk>();
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
    list_families(manifest->info, *store::StoreScalars::open(*reader, disk));
    return std::move(manifest->info);
}

core::Result<core::DatasetInfo> describe(const DatasetArgument& argument,
                                         const InfoOptions& options) {
    if (auto fit = check_source_options(argument, options.taken); !fit)
        return tl::unexpected(fit.error());
    switch (argument.kind) {
    case DatasetArgument::Kind::Flow:
        return core::describe_analytic_flow(argument.flow);
    case DatasetArgument::Kind::Store:
        return describe_store(argument.path);
    case DatasetArgument::Kind::Source:
        break;
    }
    const StopOnSignal signals;
    return describe_with_import_process(
        {argument.path, {}, {}, {}, {}, {}, 0, options.memory, options.taken}, signals.token());
}

std::string grid_text(const core::DatasetInfo& info) {
    const auto& d = info.dimensions;
    const auto name = protocol::grid_name(info.grid);
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

void print_text(const core::DatasetInfo& info) {
    const auto& [lo, hi] = info.bounds;
    tell("{}\n  reader    {}\n  grid      {}\n", info.name, info.reader, grid_text(info));
    tell("  bounds    x {:g} to {:g}, y {:g} to {:g}, z {:g} to {:g}\n", lo.x, hi.x, lo.y, hi.y,
         lo.z, hi.z);
    if (!info.times.empty())
        tell("  times     {} from {:.12g} to {:.12g}{}\n", info.times.size(), info.times.front(),
             info.times.back(), info.steady ? " (steady)" : "");
    tell("  velocity  {}: {}\n", info.velocity, info.why);
    if (info.precision == core::Precision::Half)
        tell("  stored    in half precision\n");
    if (!info.note.empty())
        tell("  note      {}\n", info.note);
    for (const auto& field : info.fields)
        tell("  field     {}, {} component{}, {} data, {:g} to {:g}{}{}\n", field.name,
             field.components, field.components == 1 ? "" : "s",
             field.source == core::FieldInfo::Source::Cell ? "cell" : "point", field.range[0],
             field.range[1], field.unit.empty() ? "" : " ", field.unit);
    tell("  obstacle  {}\n", info.obstacle ? "yes" : "no");
    if (info.bytes_per_step > 0)
        tell("  memory    {:.1f} MiB a time-step\n",
             static_cast<double>(info.bytes_per_step) / (1 << 20));
}

} // namespace

int run_info(const InfoOptions& options) {
    const auto info =
        resolve_dataset(options.dataset).and_then([&](const DatasetArgument& argument) {
            return describe(argument, options);
        });
    if (!info) {
        const int status = report_failure(info.error());
        return info.error().code == core::Error::Code::InvalidArgument &&
                       info.error().message.starts_with("--")
                   ? 2
                   : status;
    }
    if (options.json)
        tell("{}\n", protocol::json_text(protocol::dataset_json(*info), 2));
    else
        print_text(*info);
    return 0;
}

} // namespace wakesurf::server
