#include "store/store_reader.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/half.hpp"
#include "store/brick_mask.hpp"
#include "store/brick_slabs.hpp"
#include "store/finite_values.hpp"
#include "store/store_grid.hpp"
#include "store/stored_bricks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace wakesurf::store {

using core::Disk;
using core::Error;
using core::fail;
using core::FileIdentity;
using core::Precision;
using core::Result;
using core::ScalarSteps;
using core::Slab;
using core::SlabPool;
using core::TimeStep;
using core::WallGeometry;

static_assert(std::endian::native == std::endian::little, "stores are little-endian");

namespace {

constexpr const char* again = "import the dataset again";

std::string step_name(std::size_t index, const std::string& file) {
    return "time-step " + std::to_string(index) + " (" + file + ")";
}

tl::unexpected<Error> replaced(const std::string& step) {
    return fail(Error::Code::Corrupt, step + " was replaced while in use",
                "the server opens the new data by itself; elsewhere, open the dataset again");
}

} // namespace

Result<std::shared_ptr<const StoreReader>>
StoreReader::open(StoreLayout layout, std::shared_ptr<const Disk> disk, std::size_t brick_threads) {
    if (auto sound = check_layout(layout); !sound)
        return tl::unexpected(sound.error());
    auto marks = ValueMarks::read(layout, *disk);
    if (!marks)
        return tl::unexpected(marks.error());
    std::shared_ptr<StoreReader> reader(
        new StoreReader(std::move(layout), std::move(disk), std::move(*marks)));
    auto grid = read_grid(reader->layout_, *reader->disk_);
    if (!grid)
        return tl::unexpected(grid.error());
    reader->grid_ = std::move(*grid);
    if (auto loaded = reader->load_mask(); !loaded)
        return tl::unexpected(loaded.error());
    if (reader->layout_.brick_cells != 0)
        reader->open_bricks(brick_threads);
    return reader;
}

StoreReader::StoreReader(StoreLayout layout, std::shared_ptr<const Disk> disk, ValueMarks marks)
    : layout_(std::move(layout)), disk_(std::move(disk)),
      nodes_(static_cast<std::size_t>(layout_.grid.nodes())),
      slabs_(std::make_shared<SlabPool>(step_file_size(nodes_, 3, Precision::Single))),
      scalars_(std::make_unique<ScalarSteps>(std::min<std::size_t>(4, layout_.scalars.size()) *
                                             std::min<std::size_t>(2, layout_.times.size()))),
      seen_(layout_.times.size() * (1 + layout_.scalars.size())), marks_(std::move(marks)) {}

StoreReader::~StoreReader() = default;

const core::BrickSource* StoreReader::bricks() const {
    return bricks_.get();
}

void StoreReader::open_bricks(std::size_t threads) {
    stored_bricks_ = std::make_unique<StoredBricks>(
        layout_, disk_, [this](std::size_t column, std::size_t index) -> Result<std::uint32_t> {
            if (ready(index))
                return checksum(column, index);
            if (index < marks().steps())
                return replaced("it");
            return fail(Error::Code::NotFound, "it is not in the store",
                        std::string("wait for the import to reach it, or ") + again);
        });
    bricks_ = std::make_unique<FileBricks>(*stored_bricks_,
                                           threads != 0 ? threads : disk_->pace().readers);
}

Result<void> StoreReader::load_mask() {
    if (!layout_.mask)
        return {};
    if (layout_.brick_cells != 0)
        return read_brick_mask(layout_, *disk_).map([&](core::BrickBytes mask) {
            mask_.bricks = std::make_shared<const core::BrickBytes>(std::move(mask));
        });
    if (auto fits = check_fits("the mask of the grid's nodes", nodes_); !fits)
        return fits;
    const std::string name(mask_file_name);
    const auto bytes = read_fixed_file(layout_, name, nodes_, *disk_);
    if (!bytes)
        return tl::unexpected(bytes.error());
    mask_.fluid.resize(nodes_);
    std::memcpy(mask_.fluid.data(), bytes->data(), nodes_);
    if (std::any_of(mask_.fluid.begin(), mask_.fluid.end(), [](std::uint8_t v) { return v > 1; }))
        return fail(Error::Code::Corrupt, name + " holds values other than 0 and 1", again);
    return {};
}

bool StoreReader::ready(std::size_t index) const {
    if (index >= layout_.times.size())
        return false;
    const auto size = disk_->size(layout_.folder / checksums_file_name);
    return size && *size / (columns() * sizeof(std::uint32_t)) > index;
}

bool StoreReader::whole(std::size_t index) const {
    bool all = ready(index);
    for (std::size_t column = 0; all && column < columns(); ++column)
        all = whole_file(column, index).has_value();
    return all;
}

std::size_t StoreReader::bytes_per_step() const {
    return Slab::reservation(step_file_size(nodes_, 3, Precision::Single));
}

std::string StoreReader::file_name(std::size_t column, std::size_t index) const {
    return step_files(layout_, column, index).front().name;
}

// The last of a column's files, all of which have the sizes that they should have.
Result<FileIdentity> StoreReader::whole_file(std::size_t column, std::size_t index) const {
    Result<FileIdentity> identity;
    for (const StepFile& file : step_files(layout_, column, index)) {
        identity = disk_->identity(layout_.folder / file.name);
        if (!identity && identity.error().code == Error::Code::NotFound)
            return fail(Error::Code::NotFound, step_name(index, file.name) + " is not in the store",
                        std::string("wait for the import to reach it, or ") + again);
        if (!identity)
            return identity;
        if (identity->size != file.size)
            return fail(Error::Code::Corrupt,
                        step_name(index, file.name) + " has " + std::to_string(identity->size) +
                            " bytes instead of " + std::to_string(file.size),
                        again);
    }
    return identity;
}

ValueMarks StoreReader::marks() const {
    const std::scoped_lock lock(mutex_);
    return marks_;
}

std::string StoreReader::values() const {
    const std::scoped_lock lock(mutex_);
    return marks_.text();
}

bool StoreReader::contradicts(std::string_view values) const {
    const std::scoped_lock lock(mutex_);
    return marks_.contradicts(values);
}

Result<bool> StoreReader::refresh() const {
    auto now = ValueMarks::read(layout_, *disk_);
    if (!now)
        return tl::unexpected(now.error());
    const std::scoped_lock lock(mutex_);
    if (marks_.continues(*now)) // nothing new, or another thread has read it since
        return true;
    if (!now->continues(marks_))
        return false;
    marks_ = std::move(*now);
    return true;
}

// Steps of two different imports must never meet in one interpolation.
Result<std::uint32_t> StoreReader::checksum(std::size_t column, std::size_t index) const {
    const auto same = refresh();
    if (!same)
        return tl::unexpected(same.error());
    const std::scoped_lock lock(mutex_);
    if (!*same || index >= marks_.steps())
        return replaced(step_name(index, file_name(column, index)));
    return marks_.checksum(index, column);
}

std::optional<StoreReader::Seen> StoreReader::seen(std::size_t column, std::size_t index) const {
    const std::scoped_lock lock(mutex_);
    return seen_[index * columns() + column];
}

Result<bool> StoreReader::read(std::size_t column,
                               std::size_t index,
                               std::span<std::byte> out,
                               const std::stop_token& stop) const {
    if (index >= layout_.times.size())
        return fail(Error::Code::InvalidArgument, "there is no time-step " + std::to_string(index));
    const std::string name = file_name(column, index);
    if (!ready(index) && index < marks().steps())
        return replaced(step_name(index, name));
    if (!ready(index))
        return fail(Error::Code::NotFound, step_name(index, name) + " is not in the store",
                    std::string("wait for the import to reach it, or ") + again);
    const auto before = whole_file(column, index);
    if (!before)
        return tl::unexpected(before.error());
    if (stored_bricks_)
        return read_bricks(column, index, out, stop);
    const auto seen_before = seen(column, index);
    const auto known = seen_before && seen_before->identity == *before ? seen_before : std::nullopt;
    bool gaps = known && known->gaps;
    const auto file = layout_.folder / name;
    const bool half = layout_.precision == Precision::Half;
    // In pieces, so that a cancelled load ends soon, and what is checked is still in the processor's cache
    // where a disk is near.
    const std::size_t piece_bytes = disk_->pace().piece;
    std::vector<std::uint16_t> halves(half ? piece_bytes / sizeof(float) : 0);
    std::uint32_t sum = 0;
    for (std::size_t at = 0; at < out.size(); at += piece_bytes) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled,
                        "loading " + step_name(index, name) + " was cancelled");
        const auto piece = out.subspan(at, std::min(piece_bytes, out.size() - at));
        const auto stored =
            half ? std::as_writable_bytes(std::span(halves).first(piece.size() / sizeof(float)))
                 : piece;
        if (auto got = disk_->read_stoppable(file, half ? at / 2 : at, stored, stop); !got)
            return tl::unexpected(got.error());
        if (!known)
            sum = core::crc32c(stored, sum);
        if (half)
            core::from_half(std::span(halves).first(piece.size() / sizeof(float)),
                            {reinterpret_cast<float*>(piece.data()), piece.size() / sizeof(float)});
        if (!known && !all_finite(piece, Precision::Single))
            gaps = true;
    }
    const auto after = whole_file(column, index);
    if (!after)
        return tl::unexpected(after.error());
    if (*after != *before)
        return fail(Error::Code::Corrupt, step_name(index, name) + " changed while it was read",
                    "try again");
    if (known)
        return gaps;
    const auto expected = checksum(column, index);
    if (!expected)
        return tl::unexpected(expected.error());
    if (*expected != sum && seen_before)
        return replaced(step_name(index, name));
    if (*expected != sum)
        return fail(Error::Code::Corrupt,
                    step_name(index, name) +
                        " has changed since it was written: its checksum differs",
                    "delete that file from the store, then " + std::string(again));
    const std::scoped_lock lock(mutex_);
    seen_[index * columns() + column] = Seen{*after, gaps};
    return gaps;
}

Result<bool> StoreReader::read_bricks(std::size_t column,
                                      std::size_t index,
                                      std::span<std::byte> out,
                                      const std::stop_token& stop) const {
    const auto& layout = stored_bricks_->layout();
    const std::size_t brick_values = stored_bricks_->values(column);
    const std::size_t at_once =
        std::max<std::size_t>(1, disk_->pace().piece / (brick_values * sizeof(float)));
    const std::size_t node = components_of(column) * sizeof(float);
    std::vector<float> values(at_once * brick_values);
    Result<void> outcome;
    for (std::size_t place = 0; place < layout.count() && outcome; place += at_once) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled,
                        fmt::format("loading time-step {} was cancelled", index));
        std::vector<std::span<float>> to;
        for (std::size_t i = 0; i < std::min(at_once, layout.count() - place); ++i)
            to.push_back(std::span(values).subspan(i * brick_values, brick_values));
        const auto take = [&](std::size_t i, Result<void> result) {
            if (!result && outcome)
                outcome = std::move(result);
            const auto* const brick = reinterpret_cast<const std::byte*>(to[i].data());
            for_rows_of(layout, stored_bricks_->brick_at(place + i),
                        [&](std::size_t from, std::size_t first, std::size_t nodes) {
                            std::memcpy(out.data() + first * node, brick + from * node,
                                        nodes * node);
                        });
        };
        stored_bricks_->read(column, index, place, to, take, stop);
    }
    if (!outcome)
        return tl::unexpected(outcome.error());
    if (!layout_.checked && layout_.may_have_gaps) // by now it is known
        return !all_finite(out, Precision::Single);
    return stored_bricks_->gaps(column, index);
}

Result<std::shared_ptr<const TimeStep>> StoreReader::load(std::size_t index,
                                                          std::stop_token stop) const {
    std::shared_ptr<TimeStep> step(new TimeStep, [pool = slabs_](TimeStep* done) {
        pool->put_back(std::move(done->slab));
        delete done;
    });
    step->slab = slabs_->take();
    return read(0, index, step->slab.bytes(), stop)
        .map([&](bool gaps) -> std::shared_ptr<const TimeStep> {
            step->index = index;
            step->time = layout_.times[index];
            step->gaps = gaps;
            return step;
        });
}

std::optional<std::size_t> StoreReader::add(const KeptColumn& column) const {
    return stored_bricks_ ? std::optional(stored_bricks_->add(column) - 1) : std::nullopt;
}

Result<Slab>
StoreReader::load_scalar(std::size_t scalar, std::size_t index, const std::stop_token& stop) const {
    Slab slab(step_file_size(nodes_, 1, Precision::Single));
    if (1 + scalar >= columns())
        return read_bricks(1 + scalar, index, slab.bytes(), stop).map([&](bool) {
            return std::move(slab);
        });
    return read(1 + scalar, index, slab.bytes(), stop).map([&](bool) { return std::move(slab); });
}

Result<std::shared_ptr<const Slab>> StoreReader::scalar_values(std::size_t scalar,
                                                               std::size_t index,
                                                               const std::stop_token& stop) const {
    return scalars_->get(scalar, index, [&] { return load_scalar(scalar, index, stop); });
}

std::size_t StoreReader::scalar_memory() const {
    return scalars_->most() * Slab::reservation(step_file_size(nodes_, 1, Precision::Single));
}

std::size_t StoreReader::brick_memory() const {
    return stored_bricks_ ? stored_bricks_->memory() : 0;
}

Result<WallGeometry> StoreReader::load_walls() const {
    WallGeometry walls;
    if (!layout_.walls)
        return walls;
    const auto load = [&](const char* name, auto& values) -> Result<void> {
        using Value = std::remove_reference_t<decltype(values.front())>;
        const auto size = disk_->size(layout_.folder / name);
        if (!size)
            return tl::unexpected(size.error());
        constexpr std::uint64_t most = std::uint64_t{1} << 30;
        if (*size > most)
            return core::over_limit(most, std::string(name) + " has " + std::to_string(*size) +
                                              " bytes, and walls may have 1 GiB");
        const auto whole = *size / sizeof(Value) * sizeof(Value);
        return read_fixed_file(layout_, name, whole, *disk_).map([&](const auto& bytes) {
            values.resize(bytes.size() / sizeof(Value));
            std::memcpy(values.data(), bytes.data(), bytes.size());
        });
    };
    if (auto points = load("walls.f32", walls.points); !points)
        return tl::unexpected(points.error());
    if (auto triangles = load("walls.u32", walls.triangles); !triangles)
        return tl::unexpected(triangles.error());
    for (const auto& triangle : walls.triangles)
        for (const std::uint32_t point : triangle)
            if (point >= walls.points.size())
                return fail(Error::Code::Corrupt, "walls.u32 names points that do not exist",
                            again);
    std::uint64_t rest = walls.triangles.size();
    for (const auto& patch : layout_.patches) {
        if (patch.triangles > rest)
            return fail(Error::Code::Corrupt, "walls.u32 has fewer triangles than its patches",
                        again);
        rest -= patch.triangles;
    }
    walls.patches = layout_.patches;
    return walls;
}

} // namespace wakesurf::store
