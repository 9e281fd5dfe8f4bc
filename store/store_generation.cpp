#include "store/store_generation.hpp"

#include "core/field/analytic_flow.hpp"
#include "core/field/sample_grid.hpp"
#include "store/brick_mask.hpp"
#include "store/store_grid.hpp"
#include "store/store_writer.hpp"
#include "store/value_writing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace wakesurf::store {

using core::Error;
namespace fs = std::filesystem;

namespace {

// A piece takes 12 MB: enough for every core, little enough to stop within a few milliseconds.
constexpr std::size_t piece_nodes = std::size_t{1} << 20;

// So much must stay free for the manifest, and whatever else the machine writes meanwhile.
constexpr std::uint64_t spare_bytes = std::uint64_t{64} << 20;

StoreSource source_of(const GenerateRequest& request) {
    const auto& d = request.grid.dimensions;
    return {{},
            {},
            fmt::format("flow:{} grid {},{},{} times {}:{}:{}", request.flow, d[0], d[1], d[2],
                        request.times.front(), request.times.back(), request.times.size())};
}

core::DatasetInfo info_of(const GenerateRequest& request, const core::DatasetInfo& flow) {
    const auto& grid = request.grid;
    core::DatasetInfo info;
    info.dataset = info.name = flow.name;
    info.reader = "wakesurf generate (flow:" + request.flow + ")";
    info.bounds = grid.bounds();
    info.dimensions = grid.dimensions;
    info.spacing = grid.spacing;
    info.finest_spacing = std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    info.points = grid.nodes();
    info.cells =
        std::uint64_t{grid.dimensions[0] - 1} * (grid.dimensions[1] - 1) * (grid.dimensions[2] - 1);
    info.times = request.times;
    info.steady = request.times.size() == 1;
    info.fields = flow.fields;
    info.velocity = flow.velocity;
    info.why = "sampled from a built-in flow";
    info.bytes_per_step = grid.nodes() * 3 * sizeof(float);
    return info;
}

bool has_size(const fs::path& file, std::uint64_t bytes) {
    const auto size = core::PosixDisk().size(file);
    return size && *size == bytes;
}

/// Returns the layout of the placement that was asked for; a store that was begun otherwise keeps its own.
/// REQUIRES: a grid of nodes.
StoreLayout layout_of(const GenerateRequest& request) {
    StoreLayout layout;
    layout.grid = stored_grid(request.grid);
    layout.times = request.times;
    layout.brick_cells = *brick_cells_for(request.placement, layout.grid);
    return layout;
}

std::uint64_t step_bytes(const StoreLayout& layout) {
    std::uint64_t bytes = 0;
    for (const StepFile& file : step_files(layout, 0, 0))
        bytes += file.size;
    return bytes;
}

core::Result<std::uint64_t> bytes_of(const StoreLayout& layout) {
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    const auto sound = check_bricks(layout);
    const std::uint64_t step = sound ? step_bytes(layout) : most;
    const std::uint64_t mask = layout.grid.nodes();
    if (step > (most - mask) / layout.times.size())
        return core::fail(Error::Code::OverLimit, "no disk holds that many nodes and time-steps",
                          "choose a coarser --grid or fewer --times");
    return step * layout.times.size() + mask;
}

class Generation {
  public:
    Generation(const GenerateRequest& request,
               const core::DatasetInfo& description,
               std::unique_ptr<core::Flow> flow,
               fs::path folder,
               const std::function<void(const ImportProgress&)>& show,
               std::stop_token stop)
        : request_(request), flow_(std::move(flow)), folder_(std::move(folder)), show_(show),
          stop_(std::move(stop)) {
        manifest_.source = source_of(request);
        manifest_.info = info_of(request, description);
        manifest_.layout = layout_of(request);
        manifest_.velocity_range = {std::numeric_limits<double>::infinity(), 0.0};
    }

    core::Result<void> run() {
        if (const auto before = begun_before(); before && before->has_value())
            manifest_.layout.brick_cells = (*before)->layout.brick_cells;
        if (auto room = check_room(); !room)
            return room;
        auto writer = StoreWriter::open(folder_, [] {
            return core::fail(Error::Code::Io, "another program is writing this store",
                              "wait for it to end, or give another folder");
        });
        if (!writer)
            return tl::unexpected(writer.error());
        const auto before = begun_before();
        if (!before)
            return tl::unexpected(before.error());
        if (before->has_value() && whole(**before)) {
            const std::size_t steps = request_.times.size();
            show_({"done", steps, steps, {}, "the store is up to date"});
            return {};
        }
        if (!before->has_value())
            if (auto cleared = writer->clear(); !cleared)
                return cleared;
        return write_all(*writer);
    }

  private:
    /// Returns what an earlier run of the same request has left. Error: the folder holds another store.
    core::Result<std::optional<StoreManifest>> begun_before() const {
        auto before = read_store_manifest(folder_, core::PosixDisk());
        if (before && before->source == manifest_.source &&
            goes_on(request_.placement, before->layout.brick_cells))
            return std::move(*before);
        if (!before && before.error().code == Error::Code::NotFound)
            return std::nullopt;
        return core::fail(Error::Code::InvalidArgument,
                          before
                              ? "the folder holds a different store, made by " + before->info.reader
                              : "the folder's " + before.error().message,
                          "give a new or empty folder, or delete this one first");
    }

    bool kept(std::size_t step) const {
        bool all = true;
        for (const StepFile& file : step_files(manifest_.layout, 0, step))
            all = all && has_size(folder_ / file.name, file.size);
        return all && core::PosixDisk().size(folder_ / checksums_file_name).value_or(0) >=
                          (step + 1) * sizeof(std::uint32_t);
    }

    bool whole(const StoreManifest& before) const {
        bool all = before.complete;
        for (std::size_t step = 0; all && step < request_.times.size(); ++step)
            all = kept(step);
        return all && (!before.layout.mask ||
                       read_fixed_file(store_layout(before, folder_), std::string(mask_file_name),
                                       core::PosixDisk().size(folder_ / mask_file_name).value_or(0),
                                       core::PosixDisk()));
    }

    core::Result<void> check_room() const {
        const auto all = bytes_of(manifest_.layout);
        const auto before = begun_before();
        if (!all || !before)
            return tl::unexpected(!all ? all.error() : before.error());
        std::uint64_t wanted = *all;
        for (std::size_t step = 0; before->has_value() && step < request_.times.size(); ++step)
            wanted -= kept(step) ? step_bytes(manifest_.layout) : 0;
        std::error_code error;
        fs::path there = fs::absolute(folder_, error);
        while (!error && !fs::exists(there, error) && there.has_relative_path())
            there = there.parent_path();
        const auto space = fs::space(there, error);
        if (error || wanted + spare_bytes <= space.available)
            return {}; // an unknown disk says so when it is full
        return core::fail(
            Error::Code::OverLimit,
            fmt::format("the store needs {:.1f} GB more, but the disk has {:.1f} GB free",
                        static_cast<double>(wanted) * 1e-9,
                        static_cast<double>(space.available) * 1e-9),
            "choose a coarser --grid, fewer --times or another disk");
    }

    core::Result<void> write_all(StoreWriter& writer) {
        if (auto masked = write_mask(writer); !masked)
            return masked;
        const std::size_t steps = request_.times.size();
        for (std::size_t step = 0; step < steps; ++step) {
            if (auto written = write_step(writer, step); !written)
                return written;
            show_({"generate", step + 1, steps, file_of(step), {}});
            // From its first time-step on the store can be opened.
            if (step == 0 || step + 1 == steps)
                if (auto written = write_manifest(writer, step + 1 == steps); !written)
                    return written;
        }
        show_({"done", steps, steps, {}, {}});
        return {};
    }

    core::Result<void> write_mask(StoreWriter& writer) {
        if (!flow_->obstacle())
            return {};
        const std::string name(mask_file_name);
        bool solid = false;
        std::vector<std::uint8_t> fluid(std::min(piece_nodes, request_.grid.nodes()));
        const auto next =
            [&, first = std::size_t{0}]() mutable -> core::Result<std::span<const std::uint8_t>> {
            if (stop_.stop_requested())
                return interrupted();
            const auto piece =
                std::span(fluid).first(std::min(fluid.size(), request_.grid.nodes() - first));
            core::sample_mask(*flow_, request_.grid, first, piece);
            first += piece.size();
            solid = solid || std::find(piece.begin(), piece.end(), 0) != piece.end();
            return piece;
        };
        auto written = store::write_mask(writer, manifest_.layout, next);
        if (!written)
            return tl::unexpected(written.error());
        manifest_.info.obstacle = manifest_.layout.mask = solid;
        std::error_code ignored;
        if (solid)
            manifest_.layout.checksums[name] = *written;
        else // no node of this grid lies in the obstacle
            fs::remove(folder_ / name, ignored);
        return {};
    }

    /// A step that is already there is sampled again as well: what it adds to the range of the speed is
    /// nowhere else.
    core::Result<void> write_step(StoreWriter& writer, std::size_t step) {
        buffer_.resize(3 * std::min(piece_nodes, request_.grid.nodes()));
        std::size_t first = 0;
        const auto next = [&]() -> core::Result<std::span<const float>> {
            const std::size_t count = std::min(piece_nodes, request_.grid.nodes() - first);
            const auto piece = std::span(buffer_).first(3 * count);
            const auto range = core::sample_nodes(*flow_, request_.grid, first,
                                                  request_.times[step], piece, stop_);
            if (stop_.stop_requested())
                return interrupted();
            if (!range)
                return tl::unexpected(range.error());
            first += count;
            auto& all = manifest_.velocity_range;
            all = {std::min(all[0], (*range)[0]), std::max(all[1], (*range)[1])};
            show_part(step, static_cast<double>(first));
            return piece;
        };
        if (!kept(step))
            return write_values(writer, manifest_.layout, 0, step, next)
                .and_then([&](std::uint32_t checksum) {
                    return writer.finish_step(step, {&checksum, 1});
                });
        for (;;) {
            const auto piece = next();
            if (!piece)
                return tl::unexpected(piece.error());
            if (piece->empty())
                return {};
        }
    }

    core::Result<void> write_manifest(StoreWriter& writer, bool complete) {
        auto& range = manifest_.velocity_range;
        range[0] = std::min(range[0], range[1]); // a grid of solid nodes only
        if (complete)
            if (auto settled = writer.settle(); !settled)
                return settled;
        manifest_.complete = complete;
        manifest_.info.fields.front().range = range;
        const std::string text = store_manifest_text(manifest_);
        return writer.write(std::string(manifest_file_name), std::as_bytes(std::span(text)))
            .map([](std::uint32_t) {});
    }

    std::string file_of(std::size_t step) const {
        return step_files(manifest_.layout, 0, step).front().name;
    }

    void show_part(std::size_t step, double nodes) const {
        const double part = nodes / static_cast<double>(request_.grid.nodes());
        show_({"part", step, request_.times.size(), file_of(step), {}, part});
    }

    static tl::unexpected<Error> interrupted() {
        return core::fail(Error::Code::Cancelled, "generating the store was interrupted",
                          "run the same command again to resume");
    }

    const GenerateRequest& request_;
    std::unique_ptr<core::Flow> flow_;
    fs::path folder_;
    const std::function<void(const ImportProgress&)>& show_;
    std::stop_token stop_;
    StoreManifest manifest_;
    std::vector<float> buffer_;
};

} // namespace

core::Result<std::uint64_t> generated_bytes(const GenerateRequest& request) {
    if (auto sound = check_grid(stored_grid(request.grid)); !sound)
        return tl::unexpected(sound.error());
    return bytes_of(layout_of(request));
}

core::Result<void> generate_store(const GenerateRequest& request,
                                  const fs::path& folder,
                                  const std::function<void(const ImportProgress&)>& show,
                                  std::stop_token stop) {
    auto flow = core::make_analytic_flow(request.flow);
    const auto description = core::describe_analytic_flow(request.flow);
    if (!flow)
        return tl::unexpected(flow.error());
    return Generation(request, *description, std::move(*flow), folder, show, std::move(stop)).run();
}

} // namespace wakesurf::store
