#include "core/dataset/store_reader.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace wakesurf::core {

static_assert(std::endian::native == std::endian::little, "stores are little-endian float32");

namespace {

// Lengths beyond this, or below its inverse, overflow when squared further down the path.
constexpr double largest = 1e100;

// Read in pieces so that a cancelled load ends within a few milliseconds.
constexpr std::size_t piece_bytes = std::size_t{8} << 20;

std::string step_name(std::size_t index) {
    return "time-step " + std::to_string(index) + " (" + velocity_file_name(index) + ")";
}

// An exponent of all ones is infinity or NaN; or-ing keeps the loop free of branches.
bool all_finite(std::span<const std::byte> bytes) {
    constexpr std::uint32_t exponent = 0x7f800000u;
    std::uint32_t bad = 0;
    for (std::size_t at = 0; at + sizeof(std::uint32_t) <= bytes.size(); at += sizeof(bad)) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, bytes.data() + at, sizeof(bits));
        bad |= static_cast<std::uint32_t>((bits & exponent) == exponent);
    }
    return bad == 0;
}

Result<void> check_times(const std::vector<double>& times) {
    if (times.empty())
        return fail(Error::Code::InvalidArgument, "the store has no time-steps");
    const bool finite_times =
        std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
    const bool rising = std::adjacent_find(times.begin(), times.end(), [](double a, double b) {
                            return !(a < b);
                        }) == times.end();
    if (!finite_times || !rising)
        return fail(Error::Code::InvalidArgument, "the store's times are not strictly increasing");
    return {};
}

} // namespace

std::string velocity_file_name(std::size_t index) {
    std::string digits = std::to_string(index);
    digits.insert(0, digits.size() < 6 ? 6 - digits.size() : 0, '0');
    return "velocity_" + digits + ".f32";
}

Result<std::size_t> velocity_file_size(const UniformGrid& grid) {
    std::size_t nodes = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t count = grid.dimensions[static_cast<std::size_t>(axis)];
        if (count < 2)
            return fail(Error::Code::InvalidArgument, "the grid is thinner than two nodes");
        const double far =
            std::max(std::abs(grid.bounds().lo[axis]), std::abs(grid.bounds().hi[axis]));
        if (!(grid.spacing[axis] >= 1.0 / largest) || !(far <= largest))
            return fail(Error::Code::InvalidArgument, "the grid's origin or spacing is not usable");
        constexpr std::size_t most = std::numeric_limits<std::int64_t>::max() / (3 * sizeof(float));
        if (nodes > most / count)
            return fail(Error::Code::InvalidArgument,
                        "the grid has more nodes than memory can hold");
        nodes *= count;
    }
    return nodes * 3 * sizeof(float);
}

Result<std::shared_ptr<const StoreReader>> StoreReader::open(StoreLayout layout,
                                                             std::shared_ptr<const Disk> disk) {
    if (auto sound = check_times(layout.times); !sound)
        return tl::unexpected(sound.error());
    const auto file_size = velocity_file_size(layout.grid);
    if (!file_size)
        return tl::unexpected(file_size.error());
    std::shared_ptr<StoreReader> reader(
        new StoreReader(std::move(layout), std::move(disk), *file_size));
    if (auto loaded = reader->load_mask(); !loaded)
        return tl::unexpected(loaded.error());
    return reader;
}

StoreReader::StoreReader(StoreLayout layout,
                         std::shared_ptr<const Disk> disk,
                         std::size_t file_size)
    : layout_(std::move(layout)), disk_(std::move(disk)), file_size_(file_size),
      seen_(layout_.times.size()) {}

Result<void> StoreReader::load_mask() {
    if (layout_.mask.empty())
        return {};
    const auto file = layout_.folder / layout_.mask;
    const auto size = disk_->size(file);
    if (!size)
        return tl::unexpected(size.error());
    if (*size != layout_.grid.nodes())
        return fail(Error::Code::Corrupt, layout_.mask + " does not have one byte a node",
                    "import the dataset again");
    mask_.fluid.resize(layout_.grid.nodes());
    if (auto read = disk_->read(file, 0, std::as_writable_bytes(std::span(mask_.fluid))); !read)
        return read;
    if (std::any_of(mask_.fluid.begin(), mask_.fluid.end(), [](std::uint8_t v) { return v > 1; }))
        return fail(Error::Code::Corrupt, layout_.mask + " holds values other than 0 and 1",
                    "import the dataset again");
    return {};
}

bool StoreReader::ready(std::size_t index) const {
    if (index >= layout_.times.size())
        return false;
    const auto size = disk_->size(layout_.folder / velocity_file_name(index));
    return size && *size == file_size_;
}

std::size_t StoreReader::bytes_per_step() const {
    return Slab::reservation(file_size_);
}

Result<FileIdentity> StoreReader::whole_file(std::size_t index) const {
    auto identity = disk_->identity(layout_.folder / velocity_file_name(index));
    if (!identity && identity.error().code == Error::Code::NotFound)
        return fail(Error::Code::NotFound, step_name(index) + " is not in the store",
                    "wait for the import to reach it, or import the dataset again");
    if (identity && identity->size != file_size_)
        return fail(Error::Code::Corrupt,
                    step_name(index) + " has " + std::to_string(identity->size) +
                        " bytes instead of " + std::to_string(file_size_),
                    "import the dataset again");
    return identity;
}

// Steps of two different imports must never meet in one interpolation.
Result<void> StoreReader::same_as_before(std::size_t index, const FileIdentity& identity) const {
    const std::scoped_lock lock(mutex_);
    if (!seen_[index])
        seen_[index] = identity;
    if (*seen_[index] != identity)
        return fail(Error::Code::Corrupt, step_name(index) + " was replaced while in use",
                    "open the dataset again");
    return {};
}

Result<std::shared_ptr<const TimeStep>> StoreReader::load(std::size_t index,
                                                          std::stop_token stop) const {
    if (index >= layout_.times.size())
        return fail(Error::Code::InvalidArgument, "there is no time-step " + std::to_string(index));
    const auto before = whole_file(index);
    if (!before)
        return tl::unexpected(before.error());
    auto step = std::make_shared<TimeStep>(TimeStep{index, layout_.times[index], Slab(file_size_)});
    const auto file = layout_.folder / velocity_file_name(index);
    const auto bytes = step->slab.bytes();
    for (std::size_t at = 0; at < bytes.size(); at += piece_bytes) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "loading " + step_name(index) + " was cancelled");
        const auto piece = bytes.subspan(at, std::min(piece_bytes, bytes.size() - at));
        if (auto read = disk_->read(file, at, piece); !read)
            return tl::unexpected(read.error());
        if (!all_finite(piece))
            return fail(Error::Code::Corrupt, step_name(index) + " holds non-finite velocities",
                        "import the dataset again");
    }
    const auto after = whole_file(index);
    if (!after)
        return tl::unexpected(after.error());
    if (*after != *before)
        return fail(Error::Code::Corrupt, step_name(index) + " changed while it was read",
                    "try again");
    if (auto same = same_as_before(index, *after); !same)
        return tl::unexpected(same.error());
    return step;
}

} // namespace wakesurf::core
