#include "server/data/bricks/ranks/rank_store.hpp"

#include "core/base/crc32c.hpp"
#include "store/store_manifest.hpp"

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

} // namespace wakesurf::server
