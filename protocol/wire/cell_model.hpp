// What is expected of a cell's vertices, and how likely: the part of the cells code that both directions share.
// protocol/wire/README.md, Cells code. Twin: web-client/src/protocol/cellModel.ts.
#pragma once

#include "protocol/wire/cells_code.hpp"
#include "protocol/wire/open_sides.hpp"
#include "protocol/wire/range_coder.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace wakesurf::protocol {

/// A cell's vertices by slot: corners 0 to 3, then mids 0 to 3.
using CellSlots = std::array<std::uint32_t, 8>;

CellSlots slots_of(const core::Cell& cell);
core::Cell cell_of(const CellSlots& slots);

/// Codes one cell after the other and learns from each.
class CellModel {
  public:
    explicit CellModel(const CellContext& context);

    /// @param cell  what is written, or where what is read goes
    /// @param old   the cell it replaces, or null
    /// False when what was read is no cell of these vertices.
    template <class Coder>
    bool code(Coder& coder, CellSlots& cell, const CellSlots* old);

  private:
    /// Where a vertex was expected from.
    enum class Choice : std::uint8_t { Along, Beside, Stride, Fresh, Old, Back, Gate, None };
    static constexpr std::size_t choices = 8;

    /// Slots in the order of the outline, as far as they are known.
    struct Outline {
        std::array<std::uint8_t, 8> slot{};
        std::array<std::uint32_t, 8> vertex{};
        std::size_t count = 0;
    };

    static Outline outline_with(unsigned mids);
    std::uint32_t
    expected(Choice choice, const Outline& outline, std::size_t k, const CellSlots* old) const;
    /// Whether the cell repeats the choices of the last one; `outline` is then whole, unless what was read does not fit.
    template <class Coder>
    bool code_repeats(Coder& coder, const CellSlots& cell, Outline& outline);
    template <class Coder>
    unsigned code_mids(Coder& coder, const CellSlots& cell, const CellSlots* old);
    template <class Coder>
    Choice code_vertex(Coder& coder,
                       const CellSlots& cell,
                       Outline& outline,
                       std::size_t k,
                       Choice before,
                       const CellSlots* old);
    template <class Coder>
    void code_number(Coder& coder, std::uint32_t value, Outline& outline, std::size_t k);
    bool finish(const Outline& outline, CellSlots& cell);

    std::uint32_t vertices_;
    OpenSides open_;
    std::uint32_t fresh_; ///< above all vertices there have been
    CellSlots last_{};    ///< the newest vertex in each slot
    CellSlots stride_{1, 1, 1, 1, 1, 1, 1, 1};
    unsigned last_mids_ = 0;
    Choice last_start_ = Choice::None;
    std::array<Choice, 8>
        choice_{}; ///< by place in the outline, of the last cell that replaced none
    unsigned choice_mids_ = 0;
    bool repeatable_ = false; ///< all vertices of that cell were as expected
    unsigned repeats_ = 0;    ///< whether the cells before repeated, a bit each

    std::array<AdaptiveBit, 8> repeat_bit_;
    std::array<AdaptiveBit, 64> mid_bit_;
    std::array<AdaptiveBit, 2 * 8 * choices * choices> choice_bit_;
    std::array<AdaptiveNumber, 3> number_; ///< of first corners, other corners, mids
};

} // namespace wakesurf::protocol
