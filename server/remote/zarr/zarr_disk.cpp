#include "server/remote/zarr/zarr_disk.hpp"

#include "core/base/blocking_wait.hpp"
#include "server/remote/web/web_address.hpp"
#include "server/remote/zarr/zarr_chunk.hpp"
#include "store/store_grid.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <latch>
#include <mutex>

namespace wakesurf::server {

namespace {

/// Holds the numbers from..to along an axis.
struct Interval {
    std::uint64_t from = 0;
    std::uint64_t to = 1;
};

/// Returns the nodes of the brick that the grid has.
std::array<Interval, 3> nodes_of(const core::BrickLayout& layout, std::size_t brick) {
    const auto first = layout.first_node(brick);
    std::array<Interval, 3> out;
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = {first[i], std::min<std::uint64_t>(first[i] + layout.brick_nodes()[i],
                                                    layout.dimensions()[i])};
    return out;
}

/// Returns the part of an interval that is in a chunk.
Interval within(const Interval& wanted, std::uint64_t chunk, std::uint64_t length) {
    return {std::max(wanted.from, chunk * length), std::min(wanted.to, (chunk + 1) * length)};
}

/// Collects the pieces of one array.
class Pieces {
  public:
    Pieces(const ZarrDataset& dataset, std::size_t array, std::vector<Interval> wanted)
        : of_(dataset.arrays[array]), axes_(dataset.axes[array]), array_(array),
          wanted_(std::move(wanted)) {}

    void add_to(std::vector<BrickPiece>& out,
                const std::array<Interval, 3>& nodes,
                const std::vector<ZarrPart>& parts) const {
        std::vector<std::uint64_t> chunk;
        for (std::size_t axis = 0; axis < wanted_.size(); ++axis)
            chunk.push_back(wanted_[axis].from / of_.chunks[axis]);
        do
            out.push_back(piece(chunk, nodes, parts));
        while (next(chunk));
    }

  private:
    /// Advances the last axis fastest; returns false behind the last chunk.
    bool next(std::vector<std::uint64_t>& chunk) const {
        for (std::size_t axis = chunk.size(); axis-- > 0;) {
            if (++chunk[axis] * of_.chunks[axis] < wanted_[axis].to)
                return true;
            chunk[axis] = wanted_[axis].from / of_.chunks[axis];
        }
        return false;
    }

    BrickPiece piece(const std::vector<std::uint64_t>& chunk,
                     const std::array<Interval, 3>& nodes,
                     const std::vector<ZarrPart>& parts) const {
        BrickPiece out{array_, chunk, {}, {}, {}, parts.size(), {}};
        const auto here = [&](std::size_t axis) {
            return within(wanted_[axis], chunk[axis], of_.chunks[axis]);
        };
        for (std::size_t axis = 0; axis < chunk.size(); ++axis)
            out.from.push_back(here(axis).from - chunk[axis] * of_.chunks[axis]);
        for (std::size_t i = 0; i < 3; ++i) {
            const Interval along = here(axes_.place[i]);
            out.first[i] = static_cast<std::size_t>(along.from - nodes[i].from);
            out.count[i] = static_cast<std::size_t>(along.to - along.from);
        }
        const Interval has = axes_.component ? here(*axes_.component) : Interval{};
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].array == array_ && parts[i].component >= has.from &&
                parts[i].component < has.to)
                out.components.push_back({i, parts[i].component - has.from});
        return out;
    }

    const ZarrArray& of_;
    const ZarrAxes& axes_;
    std::size_t array_;
    std::vector<Interval> wanted_; ///< along each axis of the array
};

} // namespace

std::vector<BrickPiece> pieces_of(const ZarrDataset& dataset,
                                  const core::BrickLayout& layout,
                                  std::size_t column,
                                  std::size_t step,
                                  std::size_t brick) {
    const auto& parts = dataset.columns[column];
    const auto nodes = nodes_of(layout, brick);
    std::vector<BrickPiece> out;
    for (std::size_t array = 0; array < dataset.arrays.size(); ++array) {
        if (std::ranges::find(parts, array, &ZarrPart::array) == parts.end())
            continue;
        const ZarrAxes& axes = dataset.axes[array];
        std::vector<Interval> wanted(dataset.arrays[array].shape.size());
        if (axes.time)
            wanted[*axes.time] = {step, step + 1};
        if (axes.component)
            wanted[*axes.component] = {0, parts.size()};
        for (std::size_t i = 0; i < 3; ++i)
            wanted[axes.place[i]] = nodes[i];
        Pieces(dataset, array, std::move(wanted)).add_to(out, nodes, parts);
    }
    return out;
}

bool put_piece(const ZarrDataset& dataset,
               const core::BrickLayout& layout,
               const BrickPiece& piece,
               std::span<const std::byte> chunk,
               std::span<float> brick) {
    const ZarrArray& array = dataset.arrays[piece.array];
    const ZarrAxes& axes = dataset.axes[piece.array];
    const auto& nodes = layout.brick_nodes();
    std::vector<std::size_t> stride(array.shape.size(), array.number_bytes);
    for (std::size_t axis = stride.size() - 1; axis > 0; --axis)
        stride[axis - 1] = stride[axis] * static_cast<std::size_t>(array.chunks[axis]);
    std::size_t origin = 0;
    for (std::size_t axis = 0; axis < stride.size(); ++axis)
        origin += static_cast<std::size_t>(piece.from[axis]) * stride[axis];
    const float fill = chunk.empty() ? static_cast<float>(filled_value(array)) : 0.0F;
    bool finite = std::isfinite(fill);
    for (const auto& component : piece.components)
        for (std::size_t k = 0; k < piece.count[2]; ++k)
            for (std::size_t j = 0; j < piece.count[1]; ++j) {
                const std::size_t node =
                    piece.first[0] +
                    nodes[0] * (piece.first[1] + j + nodes[1] * (piece.first[2] + k));
                float* const to = brick.data() + node * piece.all_components + component.in_brick;
                if (chunk.empty()) {
                    for (std::size_t i = 0; i < piece.count[0]; ++i)
                        to[i * piece.all_components] = fill;
                    continue;
                }
                const std::size_t from =
                    origin + k * stride[axes.place[2]] + j * stride[axes.place[1]] +
                    (axes.component
                         ? static_cast<std::size_t>(component.from) * stride[*axes.component]
                         : 0);
                finite &= read_values(array, chunk.data() + from, stride[axes.place[0]], to,
                                      piece.all_components, piece.count[0]);
            }
    return finite;
}

void repeat_last(const core::BrickLayout& layout,
                 std::size_t brick,
                 std::size_t components,
                 std::span<float> values) {
    const auto there = nodes_of(layout, brick);
    std::size_t stride = components; // of a node along the axis
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t nodes = layout.brick_nodes()[axis];
        const auto filled = static_cast<std::size_t>(there[axis].to - there[axis].from);
        for (std::size_t row = 0; row < values.size(); row += stride * nodes)
            for (std::size_t node = filled; node < nodes; ++node)
                std::copy_n(values.data() + row + stride * (filled - 1), stride,
                            values.data() + row + stride * node);
        stride *= nodes;
    }
}

using core::Error;
using core::fail;
using core::Result;
namespace fs = std::filesystem;

namespace {

/// Returns the folders below, if the disk is this machine's.
std::optional<std::vector<std::string>> names_in(const fs::path& root) {
    if (is_on_the_web(root))
        return std::nullopt;
    std::vector<std::string> out;
    std::error_code error;
    for (fs::directory_iterator each(root, error), end; !error && each != end;
         each.increment(error))
        out.push_back(each->path().filename().string());
    std::ranges::sort(out);
    return out;
}

std::vector<std::byte> bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

} // namespace

Result<std::shared_ptr<const ZarrDisk>> ZarrDisk::open(const fs::path& root,
                                                       std::shared_ptr<const core::Disk> disk,
                                                       std::uint64_t scalar_bytes) {
    auto objects = std::make_unique<const ChunkObjects>(root, std::move(disk));
    const auto group = read_zarr_group(root, objects->disk(), names_in(root));
    if (!group)
        return tl::unexpected(group.error());
    auto dataset = describe_zarr(root.filename().string(), *group, *objects, scalar_bytes);
    if (!dataset)
        return tl::unexpected(dataset.error());
    return std::shared_ptr<const ZarrDisk>(
        new ZarrDisk(std::move(*dataset), std::move(objects), group->mark));
}

ZarrDisk::ZarrDisk(ZarrDataset dataset,
                   std::unique_ptr<const ChunkObjects> objects,
                   std::uint32_t mark)
    : dataset_(std::move(dataset)), objects_(std::move(objects)),
      layout_(dataset_.manifest.layout.bricks()), chunks_(least_memory()),
      threads_(objects_->disk().pace().readers) {
    const auto& manifest = dataset_.manifest;
    files_[std::string(store::manifest_file_name)] = bytes_of(store::store_manifest_text(manifest));
    const std::vector<std::uint32_t> marks(manifest.layout.times.size() * manifest.layout.columns(),
                                           mark);
    const auto sums = std::as_bytes(std::span(marks));
    files_[std::string(store::checksums_file_name)] = {sums.begin(), sums.end()};
    for (store::GridFile& file : store::grid_files(dataset_.grid))
        files_[file.name] = std::move(file.bytes);
}

std::size_t ZarrDisk::least_memory() const {
    std::size_t kept = 0;
    std::size_t reading = 0;
    for (const ZarrArray& array : dataset_.arrays) {
        kept += array.chunk_bytes();
        reading = std::max(reading, chunk_reading_bytes(array));
    }
    return kept + reading;
}

std::optional<ZarrDisk::Values> ZarrDisk::values_of(const fs::path& file) const {
    const auto& layout = dataset_.manifest.layout;
    const std::string name = file.filename().string();
    const auto digits = name.rfind('_');
    Values out{0, 0};
    if (digits == std::string::npos)
        return std::nullopt;
    std::from_chars(name.data() + digits + 1, name.data() + name.size(), out.step);
    for (; out.column < layout.columns() && out.step < layout.times.size(); ++out.column)
        if (store::step_files(layout, out.column, out.step)[0].name == name)
            return out;
    return std::nullopt;
}

Result<std::uint64_t> ZarrDisk::size(const fs::path& file) const {
    const std::string name = file.filename().string();
    if (const auto found = files_.find(name); found != files_.end())
        return found->second.size();
    if (const auto values = values_of(file))
        return store::step_files(dataset_.manifest.layout, values->column, values->step)[0].size;
    return fail(Error::Code::NotFound, name + " is not there");
}

Result<void>
ZarrDisk::read(const fs::path& file, std::uint64_t offset, std::span<std::byte> out) const {
    return read_stoppable(file, offset, out, {});
}

Result<void> ZarrDisk::read_stoppable(const fs::path& file,
                                      std::uint64_t offset,
                                      std::span<std::byte> out,
                                      const std::stop_token& stop) const {
    const auto bytes = size(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const std::string name = file.filename().string();
    if (offset > *bytes || out.size() > *bytes - offset)
        return fail(Error::Code::Corrupt, name + " ends before it should");
    if (const auto found = files_.find(name); found != files_.end()) {
        std::copy_n(found->second.begin() + static_cast<std::ptrdiff_t>(offset), out.size(),
                    out.begin());
        return {};
    }
    const Values values = *values_of(file);
    const std::size_t brick =
        layout_.nodes_per_brick() * dataset_.columns[values.column].size() * sizeof(float);
    if (offset % brick != 0 || out.size() % brick != 0)
        return fail(Error::Code::Unsupported, name + " is read by whole bricks only");
    return read_bricks(values, static_cast<std::size_t>(offset / brick),
                       {reinterpret_cast<float*>(out.data()), out.size() / sizeof(float)}, stop);
}

// Chunks are fetched in parallel, and no thread waits for another chunk while it holds one.
Result<void> ZarrDisk::read_bricks(const Values& values,
                                   std::size_t place,
                                   std::span<float> out,
                                   const std::stop_token& stop) const {
    const std::size_t components = dataset_.columns[values.column].size();
    const std::size_t numbers = layout_.nodes_per_brick() * components;
    std::vector<std::pair<BrickPiece, std::span<float>>> pieces;
    for (std::size_t i = 0; i * numbers < out.size(); ++i)
        for (BrickPiece& piece : pieces_of(dataset_, layout_, values.column, values.step,
                                           layout_.brick_on_disk(place + i)))
            pieces.emplace_back(std::move(piece), out.subspan(i * numbers, numbers));

    struct Waiting {
        std::latch left;
        std::mutex mutex;
        Result<void> outcome{};

        explicit Waiting(std::ptrdiff_t count) : left(count) {}
    };

    const auto waiting = std::make_shared<Waiting>(
        static_cast<std::ptrdiff_t>(pieces.size())); // its last user frees it
    std::vector<core::WorkerThreads::Work> work;
    for (const auto& each : pieces)
        work.emplace_back([&, waiting](bool ending) {
            const auto& [piece, brick] = each;
            auto done = ending ? fail(Error::Code::Cancelled, "the dataset is being closed")
                               : put(piece, values.column == 0, brick, stop);
            {
                const std::scoped_lock lock(waiting->mutex);
                if (!done && waiting->outcome)
                    waiting->outcome = std::move(done);
            }
            waiting->left.count_down();
        });
    threads_.add(std::move(work));
    {
        const core::BlockingWait blocked;
        waiting->left.wait();
    }
    for (std::size_t i = 0; i * numbers < out.size(); ++i)
        repeat_last(layout_, layout_.brick_on_disk(place + i), components,
                    out.subspan(i * numbers, numbers));
    return waiting->outcome;
}

Result<void> ZarrDisk::put(const BrickPiece& piece,
                           bool velocity,
                           std::span<float> brick,
                           const std::stop_token& stop) const {
    const ZarrArray& array = dataset_.arrays[piece.array];
    std::uint64_t number = 0;
    for (std::size_t axis = 0; axis < piece.chunk.size(); ++axis)
        number = number * array.chunks_along(axis) + piece.chunk[axis];
    bool finite = true;
    const auto got = chunks_.with(
        {piece.array, number}, chunk_reading_bytes(array),
        [&] { return objects_->read(array, piece.chunk, stop); },
        [&](std::span<const std::byte> chunk) {
            finite = put_piece(dataset_, layout_, piece, chunk, brick);
        },
        stop);
    if (got && !finite && velocity && !dataset_.manifest.layout.may_have_gaps)
        return fail(Error::Code::Corrupt,
                    "chunk " + array.path_of(piece.chunk) +
                        ": it has values that are not finite, but no fill_value says that values "
                        "may be missing",
                    "write NaN as the fill_value of the velocity's arrays");
    return got;
}

} // namespace wakesurf::server
