#include "store/brick_mask.hpp"

#include "store/brick_slabs.hpp"
#include "store/store_grid.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::store {

using core::Error;
using core::Result;

namespace {

/// The kind of a brick, as the file has it.
enum State : std::uint8_t { Solid, Fluid, Mixed };

tl::unexpected<Error> corrupt_mask(std::string message) {
    return core::fail(Error::Code::Corrupt, std::move(message), "import the dataset again");
}

} // namespace

Result<std::uint32_t>
write_mask(StoreWriter& writer, const StoreLayout& layout, const NextMask& next) {
    const std::string name(mask_file_name);
    if (layout.brick_cells == 0)
        return writer.write(
            name, [&] { return next().map([](auto nodes) { return std::as_bytes(nodes); }); });
    const auto bricks = layout.bricks();
    std::vector<std::uint8_t> states(bricks.count());
    std::map<std::size_t, std::vector<std::byte>> mixed; // by place
    BrickSlabs slabs(bricks, 1, [&](std::size_t place, std::span<const std::byte> nodes) {
        const bool all_same = std::all_of(nodes.begin(), nodes.end(),
                                          [&](std::byte node) { return node == nodes[0]; });
        states[place] = all_same ? static_cast<std::uint8_t>(nodes[0]) : std::uint8_t{Mixed};
        if (!all_same)
            mixed[place].assign(nodes.begin(), nodes.end());
        return Result<void>();
    });
    for (;;) {
        const auto piece = next();
        if (!piece)
            return tl::unexpected(piece.error());
        if (piece->empty())
            break;
        if (auto added = slabs.add(std::as_bytes(*piece)); !added)
            return tl::unexpected(added.error());
    }
    if (!slabs.complete())
        throw std::logic_error("a mask has fewer bytes than its grid has nodes");
    auto at = mixed.begin();
    bool given = false;
    return writer.write(name, [&]() -> Result<std::span<const std::byte>> {
        if (!std::exchange(given, true))
            return std::as_bytes(std::span<const std::uint8_t>(states));
        if (at == mixed.end())
            return std::span<const std::byte>();
        return std::span<const std::byte>((at++)->second);
    });
}

Result<core::BrickBytes> parse_brick_mask(std::span<const std::byte> bytes,
                                          const core::BrickLayout& layout) {
    const std::size_t count = layout.count();
    if (bytes.size() < count)
        return corrupt_mask("has fewer bytes than the grid has bricks");
    const std::span values(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    const auto states = values.first(count);
    auto nodes = values.subspan(count);
    if (std::any_of(states.begin(), states.end(), [](auto state) { return state > Mixed; }))
        return corrupt_mask("holds bricks that are neither solid, fluid nor mixed");
    const auto mixed =
        static_cast<std::size_t>(std::count(states.begin(), states.end(), std::uint8_t{Mixed}));
    if (nodes.size() != mixed * layout.nodes_per_brick())
        return corrupt_mask("has " + std::to_string(bytes.size()) + " bytes instead of " +
                            std::to_string(count + mixed * layout.nodes_per_brick()));
    if (std::any_of(nodes.begin(), nodes.end(), [](auto node) { return node > 1; }))
        return corrupt_mask("holds values other than 0 and 1");
    core::BrickBytes mask(layout);
    for (std::size_t place = 0; place < count; ++place)
        if (states[place] == Mixed) {
            mask.set(layout.brick_on_disk(place), nodes.first(layout.nodes_per_brick()));
            nodes = nodes.subspan(layout.nodes_per_brick());
        } else {
            mask.set(layout.brick_on_disk(place), states[place]);
        }
    return mask;
}

Result<core::BrickBytes> read_brick_mask(const StoreLayout& layout, const core::Disk& disk) {
    const std::string name(mask_file_name);
    const auto bricks = layout.bricks();
    const auto size = disk.size(layout.folder / name);
    if (!size)
        return tl::unexpected(size.error());
    if (*size > bricks.count() * (1 + bricks.nodes_per_brick()))
        return corrupt_mask(name + " has more bytes than all of the grid's bricks");
    return read_fixed_file(layout, name, *size, disk)
        .and_then([&](const std::vector<std::byte>& bytes) {
            return parse_brick_mask(bytes, bricks).map_error([&](Error error) {
                error.message = name + " " + error.message;
                return error;
            });
        });
}

} // namespace wakesurf::store
