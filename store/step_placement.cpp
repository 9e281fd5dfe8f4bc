#include "store/step_placement.hpp"

#include <string>

namespace wakesurf::store {

using core::Error;
using core::GridKind;

core::Result<StepPlacement> parse_step_placement(std::string_view text) {
    if (text == "auto")
        return StepPlacement::Auto;
    if (text == "whole")
        return StepPlacement::Whole;
    if (text == "bricks")
        return StepPlacement::Bricks;
    return core::fail(Error::Code::InvalidArgument,
                      "--layout: '" + std::string(text) + "' is none of auto, whole and bricks");
}

core::Result<std::uint32_t> brick_cells_for(StepPlacement placement, const StoredGrid& grid) {
    const bool cells = grid.kind != GridKind::Uniform && grid.kind != GridKind::Rectilinear;
    if (cells && placement == StepPlacement::Bricks)
        return core::fail(Error::Code::Unsupported,
                          "--layout bricks: only uniform and rectilinear grids lie in bricks, not "
                          "meshes of cells",
                          "leave --layout out");
    const bool large = step_file_size(grid.nodes(), 3, core::Precision::Single) > whole_at_most;
    if (cells || placement == StepPlacement::Whole || (placement == StepPlacement::Auto && !large))
        return 0;
    return core::BrickLayout::usual_cells;
}

bool goes_on(StepPlacement placement, std::uint32_t brick_cells) {
    return placement == StepPlacement::Auto ||
           (placement == StepPlacement::Bricks) == (brick_cells != 0);
}

} // namespace wakesurf::store
