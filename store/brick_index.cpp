#include "store/brick_index.hpp"

#include <algorithm>
#include <string>

namespace wakesurf::store {

bool BrickIndex::any_gap() const {
    return std::any_of(gaps.begin(), gaps.end(), [](std::uint8_t gap) { return gap != 0; });
}

std::vector<std::byte> brick_index_bytes(const BrickIndex& index) {
    std::vector<std::byte> out(BrickIndex::bytes(index.checksums.size()));
    const auto sums = std::as_bytes(std::span(index.checksums));
    const auto gaps = std::as_bytes(std::span(index.gaps));
    std::copy(gaps.begin(), gaps.end(), std::copy(sums.begin(), sums.end(), out.begin()));
    return out;
}

core::Result<BrickIndex> parse_brick_index(std::span<const std::byte> bytes, std::size_t bricks) {
    const auto corrupt = [](std::string message) {
        return core::fail(core::Error::Code::Corrupt, std::move(message),
                          "import the dataset again");
    };
    if (bytes.size() != BrickIndex::bytes(bricks))
        return corrupt("has " + std::to_string(bytes.size()) + " bytes instead of " +
                       std::to_string(BrickIndex::bytes(bricks)));
    BrickIndex index(bricks);
    const auto sums = std::as_writable_bytes(std::span(index.checksums));
    const auto gaps = bytes.subspan(sums.size());
    std::copy_n(bytes.begin(), sums.size(), sums.begin());
    std::copy(gaps.begin(), gaps.end(), std::as_writable_bytes(std::span(index.gaps)).begin());
    if (std::any_of(index.gaps.begin(), index.gaps.end(), [](std::uint8_t gap) { return gap > 1; }))
        return corrupt("says of a brick neither that it has gaps nor that it has none");
    return index;
}

} // namespace wakesurf::store
