#include "store/value_writing.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/half.hpp"
#include "store/brick_slabs.hpp"
#include "store/finite_values.hpp"
#include "store/store_layout.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace wakesurf::store {

using core::Precision;

namespace {

using Written = core::Result<std::uint32_t>;

Written write_bricks(StoreWriter& writer,
                     const StoreLayout& layout,
                     std::size_t column,
                     std::size_t index,
                     const NextPiece& next) {
    const auto files = step_files(layout, column, index);
    const auto bricks = layout.bricks();
    BrickIndex sums(bricks.count());
    const auto node_bytes = step_file_size(1, components_of(column), layout.precision);
    const auto fill = [&](const PutBytes& put) -> core::Result<void> {
        BrickSlabs slabs(bricks, node_bytes, [&](std::size_t place, auto bytes) {
            sums.checksums[place] = core::crc32c(bytes);
            sums.gaps[place] = all_finite(bytes, layout.precision) ? 0 : 1;
            return put(place * bytes.size(), bytes);
        });
        for (;;) {
            const auto piece = next();
            if (!piece)
                return tl::unexpected(piece.error());
            if (piece->empty() && !slabs.complete())
                throw std::logic_error("a time-step has fewer values than its grid has nodes");
            if (piece->empty())
                return {};
            if (auto added = slabs.add(*piece); !added)
                return added;
        }
    };
    return writer.write_in_place(files[0].name, files[0].size, fill).and_then([&] {
        return writer.write(files[1].name, brick_index_bytes(sums));
    });
}

} // namespace

Written write_values(StoreWriter& writer,
                     const StoreLayout& layout,
                     std::size_t column,
                     std::size_t index,
                     const NextValues& next) {
    std::vector<std::uint16_t> halves;
    const auto stored = [&]() -> core::Result<std::span<const std::byte>> {
        return next().map([&](std::span<const float> values) -> std::span<const std::byte> {
            if (layout.precision == Precision::Single)
                return std::as_bytes(values);
            halves.resize(values.size());
            core::to_half(values, halves);
            return std::as_bytes(std::span<const std::uint16_t>(halves));
        });
    };
    if (layout.brick_cells != 0)
        return write_bricks(writer, layout, column, index, stored);
    return writer.write(step_files(layout, column, index)[0].name, stored);
}

Written write_values(StoreWriter& writer,
                     const StoreLayout& layout,
                     std::size_t column,
                     std::size_t index,
                     std::span<const float> values) {
    // Halves are made piece by piece.
    static constexpr std::size_t piece = std::size_t{1} << 20;
    return write_values(writer, layout, column, index,
                        [rest = values]() mutable -> core::Result<std::span<const float>> {
                            const auto now = rest.first(std::min(piece, rest.size()));
                            rest = rest.subspan(now.size());
                            return now;
                        });
}

} // namespace wakesurf::store
