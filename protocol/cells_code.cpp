#include "protocol/cells_code.hpp"

#include <string>
#include <utility>

namespace wakesurf::protocol {

namespace {

using core::no_vertex;

// The header byte: bits 0-3 which mids exist, then:
constexpr unsigned continues = 0x10;       // corners 0 and 1 are corners 3 and 2 of the cell before
constexpr unsigned left_predicted = 0x20;  // corner 3 follows its column
constexpr unsigned right_predicted = 0x40; // corner 2 follows its column
constexpr unsigned plain = continues | left_predicted | right_predicted;
constexpr unsigned run_of_plain = 0x80 | plain; // followed by how many

unsigned mid_mask(const core::Cell& cell) {
    unsigned mask = 0;
    for (unsigned side = 0; side < 4; ++side)
        if (cell.mid[side] != no_vertex)
            mask |= 1u << side;
    return mask;
}

/// Reads ids that the code gives as differences from predictions, and holds them to the vertices there are.
class IdReader {
  public:
    IdReader(std::span<const std::byte> code, std::uint32_t vertices)
        : code_(code), vertices_(vertices) {}

    bool at_end() const { return at_ == code_.size(); }

    bool failed() const { return failed_; }

    unsigned byte() {
        if (at_end())
            failed_ = true;
        return failed_ ? 0u : std::to_integer<unsigned>(code_[at_++]);
    }

    std::uint32_t varint() {
        const auto value = take_varint(code_, at_);
        failed_ = failed_ || !value;
        return value.value_or(0);
    }

    std::uint32_t id(std::uint32_t predicted) { return checked(predicted + unzigzag(varint())); }

    std::uint32_t checked(std::uint32_t id) {
        failed_ = failed_ || id >= vertices_;
        return id;
    }

    std::uint32_t along(CellPredictor::Column& column,
                        std::uint32_t from,
                        bool has_mid,
                        bool end_predicted,
                        std::uint32_t& mid) {
        if (has_mid) {
            mid = id(column.after(from));
            column.saw(from, mid);
            from = mid;
        }
        const std::uint32_t expected = column.after(from);
        const std::uint32_t to = end_predicted ? checked(expected) : id(expected);
        column.saw(from, to);
        return to;
    }

  private:
    std::span<const std::byte> code_;
    std::size_t at_ = 0;
    std::uint32_t vertices_;
    bool failed_ = false;
};

core::Cell read_cell(IdReader& in, CellPredictor& expect, unsigned header) {
    core::Cell cell;
    if ((header & continues) != 0) {
        cell.corner[0] = in.checked(expect.next_corner0);
        cell.corner[1] = in.checked(expect.next_corner1);
    } else {
        const std::uint32_t width = expect.strip_corner1 - expect.strip_corner0;
        cell.corner[0] = in.id(expect.strip_corner1);
        cell.corner[1] = in.id(cell.corner[0] + width);
        expect.strip_corner0 = cell.corner[0];
        expect.strip_corner1 = cell.corner[1];
    }
    cell.corner[3] = in.along(expect.left, cell.corner[0], (header & 8u) != 0,
                              (header & left_predicted) != 0, cell.mid[3]);
    cell.corner[2] = in.along(expect.right, cell.corner[1], (header & 2u) != 0,
                              (header & right_predicted) != 0, cell.mid[1]);
    for (const unsigned side : {0u, 2u})
        if ((header & (1u << side)) != 0)
            expect.cross_mid = cell.mid[side] = in.id(expect.cross_mid);
    expect.finish(cell);
    return cell;
}

} // namespace

void CellPredictor::Column::saw(std::uint32_t from, std::uint32_t to) {
    // One odd step, as round an inserted vertex, must not spoil the stride for the steps after it.
    const std::uint32_t difference = to - from;
    if (difference == last_difference)
        stride = difference;
    last_difference = difference;
}

void CellPredictor::finish(const core::Cell& cell) {
    next_corner0 = cell.corner[3];
    next_corner1 = cell.corner[2];
}

void CellsEncoder::put(const core::Cell& cell) {
    auto& expect = predictor_;
    const unsigned mids = mid_mask(cell);
    const bool goes_on =
        cell.corner[0] == expect.next_corner0 && cell.corner[1] == expect.next_corner1;
    if (mids == 0 && goes_on && cell.corner[3] == expect.left.after(cell.corner[0]) &&
        cell.corner[2] == expect.right.after(cell.corner[1])) {
        expect.left.saw(cell.corner[0], cell.corner[3]);
        expect.right.saw(cell.corner[1], cell.corner[2]);
        expect.finish(cell);
        ++run_;
        return;
    }
    end_run();
    const std::size_t header_at = bytes_.size();
    unsigned header = mids | (goes_on ? continues : 0u);
    bytes_.push_back(std::byte{0});
    if (!goes_on) {
        const std::uint32_t width = expect.strip_corner1 - expect.strip_corner0;
        append_varint(bytes_, zigzag(cell.corner[0] - expect.strip_corner1));
        append_varint(bytes_, zigzag(cell.corner[1] - (cell.corner[0] + width)));
        expect.strip_corner0 = cell.corner[0];
        expect.strip_corner1 = cell.corner[1];
    }
    if (put_column(expect.left, cell.corner[0], cell.mid[3], cell.corner[3]))
        header |= left_predicted;
    if (put_column(expect.right, cell.corner[1], cell.mid[1], cell.corner[2]))
        header |= right_predicted;
    put_cross_mid(cell.mid[0]);
    put_cross_mid(cell.mid[2]);
    bytes_[header_at] = static_cast<std::byte>(header);
    expect.finish(cell);
}

std::size_t CellsEncoder::size() const {
    constexpr std::size_t longest_run = 6;
    return bytes_.size() + (run_ > 0 ? longest_run : 0);
}

Bytes CellsEncoder::finish() {
    end_run();
    predictor_ = {};
    return std::exchange(bytes_, {});
}

void CellsEncoder::end_run() {
    if (run_ == 1) {
        bytes_.push_back(static_cast<std::byte>(plain));
    } else if (run_ > 1) {
        bytes_.push_back(static_cast<std::byte>(run_of_plain));
        append_varint(bytes_, run_);
    }
    run_ = 0;
}

bool CellsEncoder::put_column(CellPredictor::Column& column,
                              std::uint32_t from,
                              std::uint32_t mid,
                              std::uint32_t to) {
    if (mid != no_vertex) {
        append_varint(bytes_, zigzag(mid - column.after(from)));
        column.saw(from, mid);
        from = mid;
    }
    const std::uint32_t expected = column.after(from);
    if (to != expected)
        append_varint(bytes_, zigzag(to - expected));
    column.saw(from, to);
    return to == expected;
}

void CellsEncoder::put_cross_mid(std::uint32_t mid) {
    if (mid == no_vertex)
        return;
    append_varint(bytes_, zigzag(mid - predictor_.cross_mid));
    predictor_.cross_mid = mid;
}

core::Result<void> decode_cells(std::span<const std::byte> code,
                                std::uint32_t count,
                                std::uint32_t vertices,
                                std::vector<core::Cell>& cells) {
    const std::size_t before = cells.size();
    IdReader in(code, vertices);
    CellPredictor expect;
    std::uint32_t left = count;
    while (left > 0 && !in.failed()) {
        const unsigned header = in.byte();
        const bool is_run = (header & 0x80u) != 0;
        const std::uint32_t length = is_run ? in.varint() : 1u;
        if (length == 0 || length > left || (is_run && header != run_of_plain))
            break;
        for (std::uint32_t i = 0; i < length && !in.failed(); ++i)
            cells.push_back(read_cell(in, expect, header));
        left -= length;
    }
    if (left == 0 && !in.failed() && in.at_end())
        return {};
    const std::size_t good = cells.size() - before;
    cells.resize(before);
    return core::fail(core::Error::Code::Corrupt,
                      "the cells of a mesh frame are damaged near cell " + std::to_string(good),
                      "subscribe to the surface again");
}

} // namespace wakesurf::protocol
