// The compact code of the cells: a cell that continues a strip between two columns of consecutive vertices costs
// no byte of its own but lengthens a run; protocol/README.md has the byte map. Twin: cellsCode.ts.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/bytes.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// What both ends expect of the next cell, from the cells before it. Sums wrap modulo 2^32.
struct CellPredictor {
    /// Ids along a column: usually consecutive, or one row's length apart.
    struct Column {
        std::uint32_t stride = 1;
        std::uint32_t last_difference = 1;

        std::uint32_t after(std::uint32_t id) const { return id + stride; }

        void saw(std::uint32_t from, std::uint32_t to);
    };

    Column left;                     ///< corner 0, mid 3, corner 3
    Column right;                    ///< corner 1, mid 1, corner 2
    std::uint32_t next_corner0 = 0;  ///< corner 3 of the cell before
    std::uint32_t next_corner1 = 0;  ///< corner 2 of the cell before
    std::uint32_t strip_corner0 = 0; ///< of the first cell of the strip
    std::uint32_t strip_corner1 = 0;
    std::uint32_t cross_mid = 0; ///< last mid on side 0 or 2, which run from column to column

    /// REQUIRES: columns have been fed through Column::saw.
    void finish(const core::Cell& cell);
};

class CellsEncoder {
  public:
    void put(const core::Cell& cell);
    /// At least what finish() would give now.
    std::size_t size() const;
    Bytes finish();

  private:
    void end_run();
    /// Whether `to` was as predicted, and so cost nothing.
    bool put_column(CellPredictor::Column& column,
                    std::uint32_t from,
                    std::uint32_t mid,
                    std::uint32_t to);
    void put_cross_mid(std::uint32_t mid);

    CellPredictor predictor_;
    Bytes bytes_;
    std::uint32_t run_ = 0;
};

/// Appends `count` cells whose vertices are below `vertices`. Error: Corrupt, with `cells` as it was; never reads
/// outside `code`. Cost: O(count); the caller bounds `count`.
core::Result<void> decode_cells(std::span<const std::byte> code,
                                std::uint32_t count,
                                std::uint32_t vertices,
                                std::vector<core::Cell>& cells);

} // namespace wakesurf::protocol
