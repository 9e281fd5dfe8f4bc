#include "store/brick_mask.hpp"

#include "store/brick_rows.hpp"
#include "store/brick_slabs.hpp"
#include "store/store_grid.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace wakesurf::store {

using core::Error;
using core::Result;

namespace {

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
        states[place] =
            all_same ? static_cast<std::uint8_t>(nodes[0]) : std::uint8_t{BrickMask::Mixed};
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
    bool told = false;
    return writer.write(name, [&]() -> Result<std::span<const std::byte>> {
        if (!std::exchange(told, true))
            return std::as_bytes(std::span<const std::uint8_t>(states));
        if (at == mixed.end())
            return std::span<const std::byte>();
        return std::span<const std::byte>((at++)->second);
    });
}

Result<BrickMask> parse_brick_mask(std::span<const std::byte> bytes,
                                   const core::BrickLayout& layout) {
    const auto* const values = reinterpret_cast<const std::uint8_t*>(bytes.data());
    const std::size_t count = layout.count();
    if (bytes.size() < count)
        return corrupt_mask("has fewer bytes than the grid has bricks");
    BrickMask mask{{values, values + count}, {values + count, values + bytes.size()}};
    if (std::any_of(mask.states.begin(), mask.states.end(),
                    [](std::uint8_t state) { return state > BrickMask::Mixed; }))
        return corrupt_mask("holds bricks that are neither solid, fluid nor mixed");
    const auto mixed = static_cast<std::size_t>(
        std::count(mask.states.begin(), mask.states.end(), BrickMask::Mixed));
    if (mask.nodes.size() != mixed * layout.nodes_per_brick())
        return corrupt_mask("has " + std::to_string(bytes.size()) + " bytes instead of " +
                            std::to_string(count + mixed * layout.nodes_per_brick()));
    if (std::any_of(mask.nodes.begin(), mask.nodes.end(), [](std::uint8_t v) { return v > 1; }))
        return corrupt_mask("holds values other than 0 and 1");
    return mask;
}

Result<BrickMask> read_brick_mask(const StoreLayout& layout, const core::Disk& disk) {
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

core::SolidMask flat_mask(const BrickMask& mask, const core::BrickLayout& layout) {
    const auto& grid = layout.dimensions();
    core::SolidMask flat;
    flat.fluid.resize(std::size_t{grid[0]} * grid[1] * grid[2]);
    const auto order = layout.morton_order();
    const std::uint8_t* mixed = mask.nodes.data();
    for (std::size_t place = 0; place < order.size(); ++place) {
        const bool own = mask.states[place] == BrickMask::Mixed;
        for_rows_of(layout, order[place], [&](std::size_t from, std::size_t to, std::size_t nodes) {
            if (own)
                std::memcpy(flat.fluid.data() + to, mixed + from, nodes);
            else
                std::memset(flat.fluid.data() + to, mask.states[place], nodes);
        });
        mixed += own ? layout.nodes_per_brick() : 0;
    }
    return flat;
}

} // namespace wakesurf::store
