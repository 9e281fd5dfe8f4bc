// A store's files about its bricks: what is read of them is what was written.
#include "store/brick_mask.hpp"
#include "store/store_layout.hpp"
#include "tests/fuzz/targets/all.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace wakesurf::fuzz {

namespace {

const core::BrickLayout brick_files_layout({6, 4, 3}, 2);

void run_brick_files(Input input) {
    const auto bytes = std::as_bytes(input);
    const std::size_t bricks = bytes.size() / 5;
    if (const auto index = store::parse_brick_index(bytes, bricks))
        demand(std::ranges::equal(store::brick_index_bytes(*index), bytes),
               "checksums of bricks are the same after they were read");
    const auto mask = store::parse_brick_mask(bytes, brick_files_layout);
    if (!mask)
        return;
    for (std::size_t brick = 0; brick < brick_files_layout.count(); ++brick)
        demand(std::ranges::all_of(std::span(mask->at(brick), brick_files_layout.nodes_per_brick()),
                                   [](auto node) { return node <= 1; }),
               "a node is fluid or solid");
}

std::vector<std::string> brick_files_seeds() {
    const std::size_t bricks = brick_files_layout.count();
    std::string mask(bricks, '\1');
    mask[1] = '\2';
    mask[2] = '\0';
    for (std::size_t node = 0; node < brick_files_layout.nodes_per_brick(); ++node)
        mask += node % 3 == 0 ? '\0' : '\1';
    return {mask, std::string(bricks, '\1'), std::string(5 * bricks, '\1'), ""};
}

} // namespace

const Target brick_files_target{"brick_files", run_brick_files, brick_files_seeds, false};

} // namespace wakesurf::fuzz
