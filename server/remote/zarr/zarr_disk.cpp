#include "server/remote/zarr/zarr_disk.hpp"

#include "core/base/blocking_wait.hpp"
#include "server/remote/web/web_address.hpp"
#include "server/remote/zarr/brick_pieces.hpp"
#include "server/remote/zarr/zarr_chunk.hpp"
#include "store/store_grid.hpp"

#include <algorithm>
#include <charconv>
#include <latch>
#include <mutex>

namespace wakesurf::server {

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
        return fail(
            Error::Code::Corrupt,
            "chunk " + array.path_of(piece.chunk) +
                ": it has values that are not finite, but no fill_value says that there are any",
            "write NaN as the fill_value of the velocity's arrays");
    return got;
}

} // namespace wakesurf::server
