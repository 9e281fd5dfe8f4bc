#include "server/data/bricks/ranks/brick_window.hpp"

#include "core/base/crc32c.hpp"
#include "store/store_manifest.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::Result;

Result<std::unique_ptr<RankStore>> RankStore::open(const std::filesystem::path& folder) {
    const core::PosixDisk disk;
    const auto manifest = store::read_store_manifest(folder, disk);
    if (!manifest)
        return tl::unexpected(manifest.error());
    auto layout = store::store_layout(*manifest, folder);
    if (auto sound = store::check_layout(layout); !sound)
        return tl::unexpected(sound.error());
    if (layout.brick_cells == 0)
        return core::fail(Error::Code::Unsupported, "the store's time-steps are not in bricks",
                          "import the dataset again with --layout bricks");
    auto marks = store::ValueMarks::read(layout, disk);
    if (!marks)
        return tl::unexpected(marks.error());
    return std::unique_ptr<RankStore>(new RankStore(std::move(layout), std::move(*marks)));
}

RankStore::RankStore(store::StoreLayout layout, store::ValueMarks marks)
    : marks_(std::move(marks)), marks_text_(marks_.text()),
      bricks_(std::move(layout),
              std::make_shared<core::PosixDisk>(),
              [this](std::size_t column, std::size_t index) -> Result<std::uint32_t> {
                  if (index < marks_.steps())
                      return marks_.checksum(index, column);
                  return core::fail(Error::Code::NotFound, "it is not in the store");
              }),
      shape_{bricks_.layout().dimensions(), bricks_.layout().cells(), bricks_.steps(),
             bricks_.values(0)} {}

bool RankStore::read(std::uint64_t place, std::span<float> to, BrickHead& head) const {
    const std::size_t count = bricks_.layout().count();
    const std::size_t step = place / count;
    bool good = false;
    bricks_.read(0, step, place % count, {&to, 1},
                 [&](std::size_t, const Result<void>& outcome) { good = outcome.has_value(); });
    if (!good)
        return false;
    head.checksum = core::crc32c(std::as_bytes(to));
    head.brick = static_cast<std::uint32_t>(bricks_.brick_at(place % count));
    head.step = step;
    return true;
}

BrickWindow::BrickWindow(const RankStore& store, std::uint64_t memory)
    : store_(store), record_(brick_record_bytes(store.shape().values)) {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
    const auto ranks = static_cast<std::uint64_t>(ranks_);
    const std::uint64_t share =
        (store.bricks() + ranks - 1 - static_cast<std::uint64_t>(rank_)) / ranks;
    const std::uint64_t room = std::min(share, memory / record_);
    rooms_.resize(ranks);
    MPI_Allgather(&room, 1, MPI_UINT64_T, rooms_.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
    for (const std::uint64_t each : rooms_)
        room_ += each;
    MPI_Win_allocate(static_cast<MPI_Aint>(room * record_), 1, MPI_INFO_NULL, MPI_COMM_WORLD,
                     &memory_, &window_);
    for (std::uint64_t i = 0; i < room; ++i)
        std::memset(memory_ + i * record_, 0, sizeof(BrickHead)); // not read yet
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
}

BrickWindow::~BrickWindow() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
}

bool BrickWindow::load_next() {
    if (next_ >= rooms_[static_cast<std::size_t>(rank_)])
        return false;
    std::byte* const record = memory_ + next_ * record_;
    const std::uint64_t place =
        next_ * static_cast<std::uint64_t>(ranks_) + static_cast<std::uint64_t>(rank_);
    ++next_;
    auto& head = *reinterpret_cast<BrickHead*>(record);
    auto* const values = reinterpret_cast<float*>(record + sizeof(BrickHead));
    if (store_.read(place, {values, static_cast<std::size_t>(store_.shape().values)}, head)) {
        MPI_Win_sync(window_);
        std::atomic_ref(head.held).store(job_magic, std::memory_order_release);
        MPI_Win_sync(window_);
    }
    return true;
}

std::optional<int> BrickWindow::rank_of(std::uint64_t step, std::uint32_t brick) const {
    const std::uint64_t place = store_.place_of(step, brick);
    const auto ranks = static_cast<std::uint64_t>(ranks_);
    const auto owner = static_cast<std::size_t>(place % ranks);
    return place / ranks < rooms_[owner] ? std::optional(static_cast<int>(owner)) : std::nullopt;
}

MPI_Request BrickWindow::get(std::uint64_t step, std::uint32_t brick, std::span<std::byte> to) {
    const std::uint64_t place = store_.place_of(step, brick);
    const auto ranks = static_cast<std::uint64_t>(ranks_);
    MPI_Request request = MPI_REQUEST_NULL;
    const int bytes = static_cast<int>(record_);
    MPI_Rget(to.data(), bytes, MPI_BYTE, static_cast<int>(place % ranks),
             static_cast<MPI_Aint>(place / ranks * record_), bytes, MPI_BYTE, window_, &request);
    return request;
}

} // namespace wakesurf::server
