#include "server/data/open_dataset.hpp"

#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "server/data/import_process.hpp"
#include "server/remote/remote_dataset.hpp"
#include "store/open_store.hpp"
#include "store/store_manifest.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace wakesurf::server {

namespace {

/// Reads WAKESURF_SIMD: off, to tell a fault of the processor's vectors from one of ours; avx2, for
/// processors that slow down for wider ones.
core::Simd simd_wanted() {
    const char* text = std::getenv("WAKESURF_SIMD");
    const std::string_view value = text != nullptr ? text : "";
    return value == "off"    ? core::Simd::Portable
           : value == "avx2" ? core::Simd::Avx2
                             : core::Simd::Best;
}

constexpr double mebi = 1024.0 * 1024.0;

// The memory of a first surface beside the dataset, so that the least memory is enough for one.
constexpr std::size_t first_surface = std::size_t{32} << 20;

/// Bounds the memory for chunks of a Zarr beyond the least: chunks larger than bricks are read again and
/// again.
std::size_t more_chunks(std::size_t left) {
    constexpr std::size_t most = std::size_t{512} << 20;
    return std::min(left / 4, most);
}

/// Counts the memory beside the velocity's time-steps: the grid, the search structures of a mesh, the solid
/// mask by node, by cell and by round cells (CellMask); the checks of bricks; and that of sampling a scalar, which comes from the
/// memory of bricks if those are read one by one.
std::size_t fixed_bytes(const store::StoreReader& reader, bool by_brick) {
    const auto* mesh = std::get_if<core::CellMesh>(&reader.grid());
    constexpr std::size_t locator_bytes =
        37; // a cell: core/field/cells/cell_locator.hpp, cell_domain.hpp
    return core::memory_of(reader.grid()) + (mesh ? locator_bytes * mesh->cells.size() : 0) +
           3 * reader.mask().bytes() + reader.brick_memory() +
           (by_brick ? 0 : reader.scalar_memory());
}

/// Says in words what a dataset needs besides its grid.
std::string least_words(const store::StoreReader& reader, std::size_t bytes) {
    if (bytes < core::TimeStepCache::smallest_window(reader))
        return fmt::format("for bricks of time-steps of {:.1f} MiB",
                           static_cast<double>(reader.bytes_per_step()) / mebi);
    return fmt::format("for {} time-steps of {:.1f} MiB", bytes / reader.bytes_per_step(),
                       static_cast<double>(reader.bytes_per_step()) / mebi);
}

/// Returns the part of the budget left for time-steps. Error: OverLimit if it is too small to follow a
/// particle.
core::Result<std::size_t>
cache_budget(const store::StoreReader& reader, std::size_t fixed, std::size_t budget) {
    const std::size_t steps = core::TimeStepCache::smallest_budget(reader);
    if (budget >= fixed && budget - fixed >= steps)
        return budget - fixed;
    const auto up = [](std::size_t bytes) { return std::ceil(static_cast<double>(bytes) / mebi); };
    return core::over_limit(
        budget,
        fmt::format(
            "the dataset needs at least {:.0f} MiB of memory, {} and its grid, but may use only "
            "{:.0f} MiB",
            up(fixed + steps), least_words(reader, steps),
            std::floor(static_cast<double>(budget) / mebi)),
        fmt::format("start with --memory {:.0f}MiB or more; several datasets share it evenly",
                    up(fixed + steps)));
}

/// The error of a dataset that needs more than the account has. @param what  needs it
core::Error
not_free(const core::MemoryAccount& account, std::uint64_t bytes, const std::string& what) {
    const auto up = [](std::uint64_t n) { return std::ceil(static_cast<double>(n) / mebi); };
    const std::size_t free = account.free();
    return core::over_limit(
               account.budget(),
               fmt::format("the dataset needs at least {:.0f} MiB of memory, {}, but of the {:.0f} "
                           "MiB of --memory only {:.0f} MiB are free",
                           up(bytes), what,
                           std::floor(static_cast<double>(account.budget()) / mebi),
                           std::floor(static_cast<double>(free) / mebi)),
               fmt::format("start with --memory {:.0f}MiB or more, or with fewer datasets",
                           up((account.budget() - std::min(account.budget(), free) + bytes +
                               first_surface) /
                              7 * 8))) // an eighth is reserved for small work
        .value();
}

/// Asks for the memory that opening takes, before it is taken.
core::Result<void> room_to_open(core::MemoryAccount::Share* share,
                                const core::TimeStepCache::Options& options,
                                std::uint64_t bytes) {
    if (options.account)
        return share->grow_to(bytes)
                   ? core::Result<void>()
                   : tl::unexpected(not_free(*options.account, bytes, "for its grid alone"));
    if (bytes <= options.budget_bytes)
        return {};
    return core::over_limit(options.budget_bytes,
                            fmt::format("the dataset's grid alone needs {} MiB of memory, but may "
                                        "use only {} MiB",
                                        bytes >> 20, options.budget_bytes >> 20),
                            "start with a larger --memory");
}

/// Takes the memory of the grid from the account, and checks that the time-steps fit into the rest.
core::Result<void> count(core::MemoryAccount::Share& share,
                         const store::StoreReader& reader,
                         std::size_t fixed,
                         const core::MemoryAccount& account) {
    const std::size_t steps = core::TimeStepCache::smallest_budget(reader);
    if (!share.grow_to(fixed + steps))
        return tl::unexpected(
            not_free(account, fixed + steps, least_words(reader, steps) + " and its grid"));
    share.shrink_to(fixed);
    return {};
}

} // namespace

namespace {

/// Returns null without a job, or for a store without bricks.
std::shared_ptr<RankedStore> with_ranks(const std::shared_ptr<const store::StoreReader>& reader,
                                        const std::filesystem::path& folder,
                                        const StoreOptions& options) {
    if (!options.ranks || reader->bricks() == nullptr)
        return nullptr;
    if (is_others(folder)) {
        spdlog::warn("event=bricks_job_not_possible message=\"ranks can hold a store in a folder "
                     "only, not one on the web or a Zarr\"");
        return nullptr;
    }
    RankBricks::Options ranks = *options.ranks;
    ranks.store = std::filesystem::absolute(folder);
    ranks.closing = options.closing;
    return std::make_shared<RankedStore>(reader, std::move(ranks));
}

} // namespace

HowServed how_served(const store::StoreReader& reader,
                     const core::TimeStepCache::Options& options,
                     std::size_t chunk_bytes) {
    HowServed how;
    const std::size_t fixed = fixed_bytes(reader, false) + chunk_bytes;
    const std::size_t bytes = options.account ? options.account->free() : options.budget_bytes;
    how.room = bytes - std::min(bytes, fixed);
    if (options.account)
        how.room = std::min(how.room, core::TimeStepCache::room_in(options.account->budget()));
    how.by_brick =
        reader.bricks() != nullptr && (options.by_brick || is_on_the_web(reader.layout().folder) ||
                                       core::TimeStepCache::pages(reader, how.room));
    return how;
}

core::Result<LoadedDataset> open_flow(const DatasetArgument& argument) {
    auto info = core::describe_analytic_flow(argument.flow);
    if (!info)
        return tl::unexpected(info.error());
    return core::make_analytic_flow(argument.flow).map([&](std::unique_ptr<core::Flow> flow) {
        LoadedDataset open{std::move(*info), std::move(flow), nullptr, nullptr};
        open.flow_text = argument.flow;
        return open;
    });
}

core::Result<LoadedDataset> open_store(const std::filesystem::path& folder,
                                       const StoreOptions& how) {
    const core::TimeStepCache::Options& options = how.cache;
    const std::size_t all = options.account ? options.account->budget() : options.budget_bytes;
    const auto disk = open_disk(folder, scalar_bytes(all), how.closing);
    if (!disk)
        return tl::unexpected(disk.error());
    std::shared_ptr<core::MemoryAccount::Share> memory;
    if (options.account)
        memory = std::make_shared<core::MemoryAccount::Share>(
            options.account->open(core::MemoryUse::Meshes));
    auto opened = store::open_store(folder, disk->disk, [&](std::uint64_t bytes) {
        return room_to_open(memory.get(), options, bytes);
    });
    if (!opened)
        return tl::unexpected(opened.error());
    if (memory)
        memory->shrink_to(0);
    const auto& reader = opened->reader;
    const std::size_t chunk_bytes = disk->zarr ? disk->zarr->least : 0;
    core::TimeStepCache::Options cached = options;
    cached.by_brick = how_served(*reader, options, chunk_bytes).by_brick;
    const std::size_t fixed = fixed_bytes(*reader, cached.by_brick) + chunk_bytes;
    if (options.account) {
        if (auto there = count(*memory, *reader, fixed, *options.account); !there)
            return tl::unexpected(there.error());
        const std::size_t more = more_chunks(options.account->budget() / 4);
        if (disk->zarr &&
            memory->grow_within_free(fixed + more, core::TimeStepCache::smallest_budget(*reader) +
                                                       options.account->reserved_for_small() +
                                                       first_surface)) {
            disk->zarr->use(chunk_bytes + more);
        }
    } else if (const auto budget = cache_budget(*reader, fixed, options.budget_bytes)) {
        cached.budget_bytes = *budget;
        if (disk->zarr) {
            const std::size_t more =
                more_chunks(*budget - core::TimeStepCache::smallest_budget(*reader));
            disk->zarr->use(chunk_bytes + more);
            cached.budget_bytes -= more;
        }
    } else {
        return tl::unexpected(budget.error());
    }
    const auto ranked = with_ranks(reader, folder, how);
    auto cache = std::make_shared<core::TimeStepCache>(
        ranked ? std::shared_ptr<const core::TimeStepSource>(ranked) : reader, std::move(cached));
    if (ranked && cache->bricks()) {
        ranked->ranks().begin();
        if (memory)
            memory->set(fixed + ranked->ranks().shared_bytes());
    } else if (ranked) {
        spdlog::info("event=bricks_job_not_needed message=\"four time-steps fit into memory\"");
    }
    const std::shared_ptr<const core::Flow> flow =
        core::make_stored_flow(cache, std::make_shared<core::SteadyClock>(), simd_wanted());
    LoadedDataset open{std::move(opened->info), flow, cache, reader, std::move(memory)};
    open.ranks = ranked;
    return with_kept_fields(std::move(open), options);
}

void list_kept_fields(core::DatasetInfo& info, const store::StoreScalars& scalars) {
    std::erase_if(info.fields, &core::FieldInfo::kept);
    for (const core::FamilyRecord& each : scalars.families()) {
        core::FieldInfo field;
        field.name = each.name;
        field.family = true;
        field.range = each.steps.front().counts.range;
        for (const core::FamilyStep& step : each.steps)
            field.range = {std::min(field.range[0], step.counts.range[0]),
                           std::max(field.range[1], step.counts.range[1])};
        info.fields.push_back(std::move(field));
    }
    for (const core::MeanRecord& mean : scalars.means()) {
        const auto of = std::ranges::find(info.fields, mean.of, &core::FieldInfo::name);
        const std::string unit = of == info.fields.end() ? "" : of->unit;
        for (const core::MeanField& each : mean.fields) {
            core::FieldInfo field;
            field.name = each.name;
            if (!mean.is_energy(each)) // has its square
                field.unit = unit;
            field.mean = true;
            field.range = each.range;
            info.fields.push_back(std::move(field));
        }
    }
}

LoadedDataset with_kept_fields(LoadedDataset open, const core::TimeStepCache::Options& cache) {
    if (!open.store)
        return open;
    auto scalars = store::StoreScalars::open(open.store, open.store->disk());
    if (open.scalars && open.scalars->mark() == scalars->mark()) {
        list_kept_fields(open.info, *open.scalars);
        return open;
    }
    open.scalars = std::move(scalars);
    const auto* mesh = std::get_if<core::CellMesh>(&open.store->grid());
    if (mesh == nullptr || !mesh->axis)
        open.levels = std::make_shared<const NodeFields>(
            open.flow, open.store, open.info.velocity,
            NodeFields::Options{cache.account, open.info.fields}, open.scalars);
    open.kept_memory.reset();
    const std::size_t bytes = open.scalars->kept_memory(open.flow->bricks() != nullptr);
    if (cache.account && bytes > 0) {
        open.kept_memory = std::make_shared<core::MemoryAccount::Share>(
            cache.account->open(core::MemoryUse::Meshes));
        open.kept_memory->set(bytes);
    }
    list_kept_fields(open.info, *open.scalars);
    return open;
}

namespace {

/// Says whether the store on the disk has all values of the open one, and perhaps more.
bool has_all_of(const store::StoreManifest& now, const store::StoreReader& open) {
    const auto marks =
        store::ValueMarks::read(store::store_layout(now, open.layout().folder), core::PosixDisk());
    return open.refresh().value_or(false) && marks && marks->continues(open.marks());
}

} // namespace

core::Result<LoadedDataset> open_again(const LoadedDataset& open,
                                       const std::filesystem::path& folder,
                                       const StoreOptions& options) {
    if (is_others(folder)) // as it was when it was opened
        return open;
    const auto manifest = store::read_store_manifest(folder, core::PosixDisk());
    if (!manifest || !open.store || manifest->layout.times != open.store->times() ||
        !has_all_of(*manifest, *open.store))
        return open_store(folder, options);
    LoadedDataset whole = open;
    whole.info = manifest->info;
    return with_kept_fields(std::move(whole), options.cache);
}

bool still_there(const LoadedDataset& open) {
    if (!open.store || is_others(open.store->layout().folder))
        return true;
    const auto now = store::read_store_manifest(open.store->layout().folder, core::PosixDisk());
    return now && has_all_of(*now, *open.store);
}

std::size_t steps_ready(const LoadedDataset& open) {
    if (!open.store)
        return open.info.times.size();
    (void)open.store->refresh(); // one that cannot be read has no more of them
    return open.store->marks().steps();
}

std::string values_of(const LoadedDataset& open) {
    return open.store ? open.store->values() : std::string();
}

namespace {

// The importer names no folders. Where it cannot write, the user of a command line needs to know where.
core::Error with_store_root(core::Error error, const std::filesystem::path& root) {
    constexpr std::string_view words = "the store folder";
    const auto at = error.message.find(words);
    if (at == std::string::npos || !error.message.starts_with("cannot "))
        return error;
    error.message.insert(at + words.size(), " in " + root.string());
    error.hint = "name a folder that you can write to with --store";
    return error;
}

} // namespace

core::Result<LoadedDataset>
open_dataset(const DatasetArgument& argument,
             const OpenOptions& options,
             const std::function<void(const store::ImportProgress&)>& listener,
             std::stop_token stop) {
    if (auto fit = check_source_options(argument, options.taken); !fit)
        return tl::unexpected(fit.error());
    if (argument.kind == DatasetArgument::Kind::Flow)
        return open_flow(argument);
    if (argument.kind == DatasetArgument::Kind::Store)
        return open_store(argument.path, options.of_store());
    const auto folder = store_folder(options.store_root, argument, options.taken);
    ImportCommand command{argument.path, folder, {}, {}, options.importer};
    command.taken = options.taken;
    return run_import_process(command, listener, stop)
        .map_error([&](core::Error error) { return with_store_root(error, options.store_root); })
        .and_then([&] { return open_store(folder, options.of_store()); });
}

} // namespace wakesurf::server
