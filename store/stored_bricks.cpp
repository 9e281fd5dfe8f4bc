#include "store/stored_bricks.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/half.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <ranges>
#include <tuple>
#include <utility>

namespace wakesurf::store {

using core::BrickRead;
using core::Error;

namespace {

constexpr std::size_t run_bytes = std::size_t{2} << 20;

} // namespace

struct FileBricks::Request {
    std::vector<BrickRead> reads;
    std::vector<std::size_t> order; ///< of those that can be read: as they lie in the files
    std::stop_token stop;
    Done done;
};

bool FileBricks::there_is(const BrickRead& read) const {
    return read.step < bricks_.steps() && read.field < bricks_.columns() &&
           read.brick < layout().count();
}

std::string FileBricks::name_of(const BrickRead& read) const {
    return there_is(read) ? bricks_.name_of(read.field, read.step, read.brick)
                          : "brick " + std::to_string(read.brick) + " of time-step " +
                                std::to_string(read.step);
}

void FileBricks::read(std::vector<BrickRead> reads, std::stop_token stop, Done done) const {
    const auto request =
        std::make_shared<Request>(Request{std::move(reads), {}, std::move(stop), std::move(done)});
    for (std::size_t i = 0; i < request->reads.size(); ++i) {
        const BrickRead& one = request->reads[i];
        if (!there_is(one))
            request->done(i, core::fail(Error::Code::NotFound, "there is no " + name_of(one)));
        else if (one.to.size() != bricks_.values(one.field))
            request->done(i,
                          core::fail(Error::Code::InvalidArgument,
                                     name_of(one) + ": there is room for another number of nodes"));
        else
            request->order.push_back(i);
    }
    const auto where = [&](std::size_t i) {
        const BrickRead& one = request->reads[i];
        return std::tuple(one.step, one.field, bricks_.place_of(one.brick));
    };
    std::sort(request->order.begin(), request->order.end(),
              [&](auto a, auto b) { return where(a) < where(b); });
    const auto& order = request->order;
    const std::size_t share = (order.size() + readers_ - 1) / readers_;
    std::vector<core::WorkerThreads::Work> work;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        const BrickRead& first = request->reads[order[begin]];
        const std::size_t most = std::clamp<std::size_t>(
            run_bytes / bricks_.stored_bytes(first.field), 1, std::max<std::size_t>(1, share));
        auto next = where(order[begin]);
        while (end < order.size() && end - begin < most && where(order[end]) == next) {
            ++end;
            ++std::get<2>(next);
        }
        work.emplace_back(
            [this, request, begin, end](bool ending) { read_run(*request, begin, end, ending); });
    }
    threads_.add(std::move(work));
}

void FileBricks::read_run(const Request& request,
                          std::size_t begin,
                          std::size_t end,
                          bool ending) const {
    const auto which = std::span(request.order).subspan(begin, end - begin);
    if (ending || request.stop.stop_requested()) {
        for (const std::size_t i : which)
            request.done(i, core::fail(Error::Code::Cancelled,
                                       "reading " + name_of(request.reads[i]) + " was cancelled"));
        return;
    }
    std::vector<std::span<float>> to;
    for (const std::size_t i : which)
        to.push_back(request.reads[i].to);
    const BrickRead& first = request.reads[which.front()];
    bricks_.read(
        first.field, first.step, bricks_.place_of(first.brick), to,
        [&](std::size_t i, core::Result<void> outcome) {
            request.done(which[i], std::move(outcome));
        },
        request.stop);
}

using core::Error;
using core::fail;
using core::FileIdentity;
using core::Precision;
using core::Result;

namespace {

constexpr std::size_t recent_bytes = std::size_t{16} << 20;
constexpr std::size_t fewest_recent = 8;
constexpr std::size_t bytes_known = 6; // of a brick: BrickIndex, and whether it is checked

} // namespace

StoredBricks::StoredBricks(StoreLayout layout,
                           std::shared_ptr<const core::Disk> disk,
                           Expected expected)
    : layout_(std::move(layout)), disk_(std::move(disk)), expected_(std::move(expected)),
      bricks_(layout_.bricks()) {}

std::size_t StoredBricks::columns() const {
    const std::scoped_lock lock(mutex_);
    return layout_.columns() + kept_.size();
}

std::size_t StoredBricks::add(const KeptColumn& column) const {
    const std::scoped_lock lock(mutex_);
    const auto found =
        std::find_if(kept_.begin(), kept_.end(), [&](const auto& each) { return *each == column; });
    const auto number = layout_.columns() + static_cast<std::size_t>(found - kept_.begin());
    if (found == kept_.end())
        kept_.push_back(std::make_shared<const KeptColumn>(column));
    return number;
}

// Null for a column of the layout.
std::shared_ptr<const KeptColumn> StoredBricks::kept(std::size_t column) const {
    if (column < layout_.columns())
        return nullptr;
    const std::scoped_lock lock(mutex_);
    return kept_[column - layout_.columns()];
}

std::vector<StepFile> StoredBricks::files(std::size_t column, std::size_t index) const {
    const auto shared = kept(column);
    return shared ? step_files(layout_, shared->stem, 1, Precision::Single, shared->file[index])
                  : step_files(layout_, column, index);
}

Result<std::uint32_t> StoredBricks::expected(std::size_t column, std::size_t index) const {
    const auto shared = kept(column);
    return shared ? Result<std::uint32_t>(shared->sums[shared->file[index]])
                  : expected_(column, index);
}

std::size_t StoredBricks::most_recent() const {
    return std::max(fewest_recent, recent_bytes / (bytes_known * bricks_.count()));
}

std::size_t StoredBricks::memory() const {
    const std::size_t files = std::min(most_recent(), steps() * columns());
    return layout_.checked ? files * bytes_known * bricks_.count() : 0;
}

std::string StoredBricks::name_of(std::size_t column, std::size_t index, std::size_t brick) const {
    return "brick " + std::to_string(brick) + " of time-step " + std::to_string(index) + " (" +
           files(column, index)[0].name + ")";
}

Result<bool> StoredBricks::gaps(std::size_t column, std::size_t index) const {
    return known(column, index, {}).map([](const KnownFile& found) {
        return found->index.any_gap();
    });
}

// Returns nothing if what is known is of another file than `file`.
StoredBricks::KnownFile StoredBricks::recent(const Key& key,
                                             const std::optional<FileIdentity>& file) const {
    const std::scoped_lock lock(mutex_);
    const auto found = std::find_if(recent_.begin(), recent_.end(),
                                    [&](const auto& each) { return each.first == key; });
    if (found == recent_.end() || (file && found->second->file != *file))
        return nullptr;
    recent_.splice(recent_.begin(), recent_, found);
    return found->second;
}

Result<StoredBricks::KnownFile> StoredBricks::known(std::size_t column,
                                                    std::size_t index,
                                                    const std::optional<FileIdentity>& file) const {
    const auto shared = kept(column);
    const Key key{shared ? shared->file[index] : index, column};
    if (auto found = recent(key, file))
        return found;
    const std::scoped_lock one_thread(examining_[(index * columns() + column) % examining_.size()]);
    if (auto found = recent(key, file)) // another thread was as fast
        return found;
    auto examined = examine(column, index);
    if (!examined)
        return examined;
    const std::scoped_lock lock(mutex_);
    std::erase_if(recent_, [&](const auto& each) { return each.first == key; });
    recent_.emplace_front(key, *examined);
    if (recent_.size() > most_recent())
        recent_.pop_back();
    return examined;
}

Result<StoredBricks::KnownFile> StoredBricks::examine(std::size_t column, std::size_t index) const {
    const auto expected = this->expected(column, index);
    if (!expected)
        return tl::unexpected(expected.error());
    const auto files = this->files(column, index);
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
    if (const auto expected = this->expected(column, index); !expected)
        return tl::unexpected(expected.error());
    return fail(Error::Code::Corrupt, "it has changed since it was written: its checksum differs",
                "delete that file from the store, then import the dataset again");
}

void StoredBricks::read(std::size_t column,
                        std::size_t index,
                        std::size_t place,
                        std::span<const std::span<float>> to,
                        const OnBrick& on_brick,
                        const std::stop_token& stop) const {
    std::size_t next = 0; // of those that were on_brick of
    const auto tell = [&](Result<void> outcome) {
        const std::size_t which = next++;
        on_brick(which, std::move(outcome).map_error([&](Error error) {
            error.message = name_of(column, index, brick_at(place + which)) + ": " + error.message;
            return error;
        }));
    };
    const auto tell_rest = [&](const Error& error) {
        while (next < to.size())
            tell(tl::unexpected(error));
    };
    const auto file = layout_.folder / files(column, index)[0].name;
    const auto before = disk_->identity(file);
    const auto found =
        known(column, index, before ? std::optional<FileIdentity>(*before) : std::nullopt);
    if (!found)
        return tell_rest(found.error());
    if (!before)
        return tell_rest(before.error());
    const bool half = precision(column) == Precision::Half;
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
