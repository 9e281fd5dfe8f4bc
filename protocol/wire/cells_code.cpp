#include "protocol/wire/cells_code.hpp"

#include "protocol/wire/cell_model.hpp"

#include <stdexcept>
#include <string>

namespace wakesurf::protocol {

namespace {

/// The cells that are replaced, in order, then nothing.
class ReplacedCells {
  public:
    explicit ReplacedCells(const CellContext& context)
        : cells_(context.kept.cells), runs_(context.replaced.all()) {}

    const CellSlots* next() {
        if (runs_.empty())
            return nullptr;
        cell_ = slots_of(cells_[runs_.front().begin + at_]);
        if (++at_ == runs_.front().end - runs_.front().begin) {
            runs_ = runs_.subspan(1);
            at_ = 0;
        }
        return &cell_;
    }

  private:
    std::span<const core::Cell> cells_;
    std::span<const Run> runs_;
    std::uint32_t at_ = 0;
    CellSlots cell_{};
};

} // namespace

Bytes encode_cells(std::span<const core::Cell> cells, const CellContext& context) {
    if (cells.empty())
        return {};
    CellModel model(context);
    ReplacedCells replaced(context);
    RangeEncoder coder;
    for (const core::Cell& cell : cells) {
        CellSlots slots = slots_of(cell);
        if (!model.code(coder, slots, replaced.next()))
            throw std::logic_error("a cell to be encoded has a vertex that does not exist");
    }
    return coder.finish();
}

core::Result<std::vector<core::Cell>>
decode_cells(std::span<const std::byte> code, std::uint32_t count, const CellContext& context) {
    std::vector<core::Cell> cells;
    bool fine = count > 0 || code.empty();
    if (count > 0) {
        CellModel model(context);
        ReplacedCells replaced(context);
        RangeDecoder coder(code);
        CellSlots slots{};
        while (cells.size() < count && fine) {
            fine = model.code(coder, slots, replaced.next()) && !coder.failed();
            cells.push_back(cell_of(slots));
        }
        fine = fine && coder.exhausted();
    }
    if (fine)
        return cells;
    return core::fail(core::Error::Code::Corrupt,
                      "the cells of a mesh frame are damaged near cell " +
                          std::to_string(cells.size()),
                      "subscribe to the surface again");
}

} // namespace wakesurf::protocol
