#include "store/stored_bricks.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/half.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <ranges>

namespace wakesurf::store {

using core::Error;
using core::fail;
using core::FileIdentity;
using core::Precision;
using core::Result;

namespace {

constexpr std::size_t kept_bytes = std::size_t{16} << 20;
constexpr std::size_t fewest_kept = 8;
constexpr std::size_t bytes_known = 6; // of a brick: BrickIndex, and whether it is checked

} // namespace

StoredBricks::StoredBricks(StoreLayout layout,
                           std::shared_ptr<const core::Disk> disk,
                           Expected expected)
    : layout_(std::move(layout)), disk_(std::move(disk)), expected_(std::move(expected)),
      bricks_(layout_.bricks()) {}

std::size_t StoredBricks::most_kept() const {
    return std::max(fewest_kept, kept_bytes / (bytes_known * bricks_.count()));
}

std::size_t StoredBricks::memory() const {
    const std::size_t files = std::min(most_kept(), steps() * columns());
    return layout_.checked ? files * bytes_known * bricks_.count() : 0;
}

std::string StoredBricks::name_of(std::size_t column, std::size_t index, std::size_t brick) const {
    return "brick " + std::to_string(brick) + " of time-step " + std::to_string(index) + " (" +
           step_files(layout_, column, index)[0].name + ")";
}

Result<bool> StoredBricks::gaps(std::size_t column, std::size_t index) const {
    return known(column, index, {}).map([](const KnownFile& found) {
        return found->index.any_gap();
    });
}

// Returns nothing if what is known is of another file than `file`.
StoredBricks::KnownFile StoredBricks::kept(const Key& key,
                                           const std::optional<FileIdentity>& file) const {
    const std::scoped_lock lock(mutex_);
    const auto found = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const auto& each) { return each.first == key; });
    if (found == kept_.end() || (file && found->second->file != *file))
        return nullptr;
    kept_.splice(kept_.begin(), kept_, found);
    return found->second;
}

Result<StoredBricks::KnownFile> StoredBricks::known(std::size_t column,
                                                    std::size_t index,
                                                    const std::optional<FileIdentity>& file) const {
    const Key key{index, column};
    if (auto found = kept(key, file))
        return found;
    const std::scoped_lock one_looks(looking_[(index * columns() + column) % looking_.size()]);
    if (auto found = kept(key, file)) // another thread was as fast
        return found;
    auto looked = look_at(column, index);
    if (!looked)
        return looked;
    const std::scoped_lock lock(mutex_);
    std::erase_if(kept_, [&](const auto& each) { return each.first == key; });
    kept_.emplace_front(key, *looked);
    if (kept_.size() > most_kept())
        kept_.pop_back();
    return looked;
}

Result<StoredBricks::KnownFile> StoredBricks::look_at(std::size_t column, std::size_t index) const {
    const auto expected = expected_(column, index);
    if (!expected)
        return tl::unexpected(expected.error());
    const auto files = step_files(layout_, column, index);
    Result<FileIdentity> identity;
    for (const auto& file : files | std::views::reverse) {
        identity = disk_->identity(layout_.folder / file.name);
        if (!identity)
            return tl::unexpected(identity.error());
        if (identity->size != file.size)
            return fail(Error::Code::Corrupt,
                        file.name + " has " + std::to_string(identity->size) +
                            " bytes instead of " + std::to_string(file.size),
                        "import the dataset again");
    }
    if (!layout_.checked) {
        BrickIndex index_of_none(0);
        index_of_none.gaps.assign(1, layout_.may_have_gaps ? 1 : 0);
        return std::make_shared<const Known>(Known{std::move(index_of_none), *identity, nullptr});
    }
    const std::string& name = files[1].name;
    std::vector<std::byte> bytes(static_cast<std::size_t>(files[1].size));
    if (auto got = disk_->read(layout_.folder / name, 0, bytes); !got)
        return tl::unexpected(got.error());
    if (core::crc32c(bytes) != *expected)
        return fail(Error::Code::Corrupt,
                    name + " has changed since it was written: its checksum differs",
                    "delete that file from the store, then import the dataset again");
    return parse_brick_index(bytes, bricks_.count())
        .map([&](BrickIndex&& parsed) -> KnownFile {
            return std::make_shared<const Known>(
                Known{std::move(parsed), *identity,
                      std::make_unique<std::atomic<bool>[]>(bricks_.count())});
        })
        .map_error([&](Error error) {
            error.message = name + " " + error.message;
            return error;
        });
}

// Checks a brick. A store that was replaced is not damaged: readers have to open it again.
Result<void> StoredBricks::check(std::size_t column,
                                 std::size_t index,
                                 std::uint32_t found,
                                 std::uint32_t written) const {
    if (found == written)
        return {};
    if (const auto expected = expected_(column, index); !expected)
        return tl::unexpected(expected.error());
    return fail(Error::Code::Corrupt, "it has changed since it was written: its checksum differs",
                "delete that file from the store, then import the dataset again");
}

void StoredBricks::read(std::size_t column,
                        std::size_t index,
                        std::size_t place,
                        std::span<const std::span<float>> to,
                        const Told& told,
                        const std::stop_token& stop) const {
    std::size_t next = 0; // of those that were told of
    const auto tell = [&](Result<void> outcome) {
        const std::size_t which = next++;
        told(which, std::move(outcome).map_error([&](Error error) {
            error.message = name_of(column, index, brick_at(place + which)) + ": " + error.message;
            return error;
        }));
    };
    const auto tell_rest = [&](const Error& error) {
        while (next < to.size())
            tell(tl::unexpected(error));
    };
    const auto file = layout_.folder / step_files(layout_, column, index)[0].name;
    const auto before = disk_->identity(file);
    const auto found =
        known(column, index, before ? std::optional<FileIdentity>(*before) : std::nullopt);
    if (!found)
        return tell_rest(found.error());
    if (!before)
        return tell_rest(before.error());
    const bool half = layout_.precision == Precision::Half;
    const std::size_t bytes = stored_bytes(column);
    const bool in_place = !half && to.size() == 1;
    std::vector<std::byte> staged;
    try {
        staged.resize(in_place ? 0 : bytes * to.size());
    } catch (const std::bad_alloc&) {
        return tell_rest({Error::Code::OverLimit, "there is not enough memory to read it", ""});
    }
    const auto stored = in_place ? std::as_writable_bytes(to.front()) : std::span(staged);
    if (auto got = disk_->read_stoppable(file, std::uint64_t{place} * bytes, stored, stop); !got)
        return tell_rest(got.error());
    if (const auto after = disk_->identity(file); !after || *after != (*found)->file)
        return tell_rest({Error::Code::Corrupt, "its file changed while it was read", "try again"});
    for (std::size_t i = 0; i < to.size(); ++i) {
        const auto one = stored.subspan(i * bytes, bytes);
        if (half)
            core::from_half({reinterpret_cast<const std::uint16_t*>(one.data()), to[i].size()},
                            to[i]);
        else if (!in_place)
            std::memcpy(to[i].data(), one.data(), bytes);
        Result<void> outcome;
        auto* const checked = layout_.checked ? &(*found)->checked[place + i] : nullptr;
        if (checked != nullptr && !*checked) {
            outcome = check(column, index, core::crc32c(one), (*found)->index.checksums[place + i]);
            *checked = outcome.has_value();
        }
        tell(std::move(outcome));
    }
}

} // namespace wakesurf::store
