#include "protocol/wire/cell_model.hpp"

#include <algorithm>

namespace wakesurf::protocol {

using core::no_vertex;

namespace {

/// Of the cells that stay as they are these are looked at: the last ones, where rows grow, and those by a touched vertex.
constexpr std::size_t newest_kept = 4096;

unsigned mids_of(const CellSlots& cell) {
    unsigned mids = 0;
    for (std::size_t i = 0; i < 4; ++i)
        mids |= cell[4 + i] != no_vertex ? 1u << i : 0u;
    return mids;
}

OpenSides sides_of(const CellContext& context) {
    OpenSides open(context.vertices);
    const auto& cells = context.kept.cells;
    const std::size_t newest = cells.size() > newest_kept ? cells.size() - newest_kept : 0;
    const auto join = [&](std::uint32_t i) {
        const core::CellPolygon outline = core::polygon(cells[i]);
        open.join_outline(outline.vertex, outline.count);
    };
    for (const std::uint32_t i : context.kept.near)
        if (i < newest)
            join(i);
    for_each_gap(context.replaced, static_cast<std::uint32_t>(cells.size()),
                 [&](std::uint32_t begin, std::uint32_t end) {
                     for (auto i = std::max(begin, static_cast<std::uint32_t>(newest)); i < end;
                          ++i)
                         join(i);
                 });
    return open;
}

} // namespace

CellSlots slots_of(const core::Cell& cell) {
    const auto& [c, m] = cell;
    return {c[0], c[1], c[2], c[3], m[0], m[1], m[2], m[3]};
}

core::Cell cell_of(const CellSlots& s) {
    return {{s[0], s[1], s[2], s[3]}, {s[4], s[5], s[6], s[7]}};
}

CellModel::CellModel(const CellContext& context)
    : vertices_(context.vertices), open_(sides_of(context)), fresh_(context.kept.stay) {}

CellModel::Outline CellModel::outline_with(unsigned mids) {
    Outline outline;
    for (std::uint8_t side = 0; side < 4; ++side) {
        outline.slot[outline.count++] = side;
        if ((mids & (1u << side)) != 0)
            outline.slot[outline.count++] = static_cast<std::uint8_t>(4 + side);
    }
    return outline;
}

/// `no_vertex`, or something beyond the vertices, where nothing is expected.
std::uint32_t CellModel::expected(Choice choice,
                                  const Outline& outline,
                                  std::size_t k,
                                  const CellSlots* old) const {
    const std::size_t slot = outline.slot[k];
    switch (choice) {
    case Choice::Along:
        return last_[3];
    case Choice::Beside:
        return last_[1];
    case Choice::Stride:
        return last_[slot] + stride_[slot];
    case Choice::Fresh:
        return fresh_;
    case Choice::Old:
        return (*old)[slot];
    case Choice::Back: {
        std::uint32_t v = outline.vertex[0];
        for (std::size_t steps = outline.count - k; steps > 0 && v < vertices_; --steps)
            v = open_.before(v);
        return v;
    }
    case Choice::Gate:
        return outline.vertex[k - 1] < vertices_ ? open_.after(outline.vertex[k - 1]) : no_vertex;
    default:
        return no_vertex;
    }
}

template <class Coder>
bool CellModel::code(Coder& coder, CellSlots& cell, const CellSlots* old) {
    Outline outline;
    if (old == nullptr && repeatable_ && code_repeats(coder, cell, outline))
        return finish(outline, cell);
    const unsigned mids = code_mids(coder, cell, old);
    outline = outline_with(mids);
    std::array<Choice, 8> chosen{};
    bool all_expected = true;
    Choice before = last_start_;
    for (std::size_t k = 0; k < outline.count; ++k) {
        before = chosen[k] = code_vertex(coder, cell, outline, k, before, old);
        all_expected = all_expected && before != Choice::None;
    }
    if (old == nullptr) {
        choice_ = chosen;
        choice_mids_ = mids;
        repeatable_ = all_expected;
        last_start_ = chosen[0];
    }
    last_mids_ = mids;
    return finish(outline, cell);
}

template <class Coder>
bool CellModel::code_repeats(Coder& coder, const CellSlots& cell, Outline& outline) {
    outline = outline_with(choice_mids_);
    bool repeats = !Coder::writes || mids_of(cell) == choice_mids_;
    for (std::size_t k = 0; k < outline.count && repeats; ++k) {
        outline.vertex[k] = expected(choice_[k], outline, k, nullptr);
        repeats = !Coder::writes || outline.vertex[k] == cell[outline.slot[k]];
    }
    repeats = coder.bit(repeat_bit_[repeats_ & 7u], repeats);
    repeats_ = (repeats_ << 1) | (repeats ? 1u : 0u);
    return repeats;
}

template <class Coder>
unsigned CellModel::code_mids(Coder& coder, const CellSlots& cell, const CellSlots* old) {
    const unsigned value = Coder::writes ? mids_of(cell) : 0u;
    const unsigned old_mids = old != nullptr ? mids_of(*old) : 0u;
    unsigned mids = 0;
    for (unsigned side = 0; side < 4; ++side) {
        const auto has = [side](unsigned all) { return (all >> side) & 1u; };
        const unsigned beside = side > 0 ? (mids >> (side - 1)) & 1u : 0u;
        const unsigned context = (old != nullptr ? 32u : 0u) + 8u * side + 4u * has(old_mids) +
                                 2u * (side == 2 ? 0u : has(last_mids_)) + beside;
        mids |= coder.bit(mid_bit_[context], has(value) != 0) ? 1u << side : 0u;
    }
    return mids;
}

template <class Coder>
CellModel::Choice CellModel::code_vertex(Coder& coder,
                                         const CellSlots& cell,
                                         Outline& outline,
                                         std::size_t k,
                                         Choice before,
                                         const CellSlots* old) {
    constexpr std::array start{Choice::Along, Choice::Beside, Choice::Stride, Choice::Fresh};
    constexpr std::array start_of_old{Choice::Old};
    constexpr std::array next{Choice::Old, Choice::Back, Choice::Gate, Choice::Fresh,
                              Choice::Stride};
    const std::span<const Choice> in_turn = k > 0            ? std::span<const Choice>(next)
                                            : old != nullptr ? std::span<const Choice>(start_of_old)
                                                             : std::span<const Choice>(start);
    const std::size_t slot = outline.slot[k];
    const std::size_t context =
        (((old != nullptr ? 8u : 0u) + slot) * choices + static_cast<std::size_t>(before)) *
        choices;
    // What is in the outline already, or was no use before, is not asked again.
    std::array<std::uint32_t, 13> seen;
    auto end = std::copy_n(outline.vertex.begin(), k, seen.begin());
    for (const Choice choice : in_turn) {
        if ((choice == Choice::Old && old == nullptr) || (choice == Choice::Stride && slot >= 4))
            continue;
        const std::uint32_t v = expected(choice, outline, k, old);
        if (v >= vertices_ || std::find(seen.begin(), end, v) != end)
            continue;
        if (coder.bit(choice_bit_[context + static_cast<std::size_t>(choice)],
                      Coder::writes && cell[slot] == v)) {
            outline.vertex[k] = v;
            return choice;
        }
        *end++ = v;
    }
    code_number(coder, cell[slot], outline, k);
    return Choice::None;
}

template <class Coder>
void CellModel::code_number(Coder& coder, std::uint32_t value, Outline& outline, std::size_t k) {
    const std::size_t slot = outline.slot[k];
    const std::uint32_t from = k == 0 ? last_[0] : slot >= 4 ? fresh_ : outline.vertex[k - 1];
    const std::size_t kind = k == 0 ? 0 : slot >= 4 ? 2 : 1;
    outline.vertex[k] = from + unzigzag(number_[kind].code(coder, zigzag(value - from)));
    if (outline.vertex[k] >= vertices_)
        outline.vertex[k] = no_vertex;
}

bool CellModel::finish(const Outline& outline, CellSlots& cell) {
    cell.fill(no_vertex);
    for (std::size_t k = 0; k < outline.count; ++k) {
        const std::uint32_t v = outline.vertex[k];
        if (v >= vertices_)
            return false;
        const std::size_t slot = outline.slot[k];
        cell[slot] = v;
        stride_[slot] = v - last_[slot];
        last_[slot] = v;
        fresh_ = std::max(fresh_, v + 1);
    }
    open_.join_outline(outline.vertex, outline.count);
    return true;
}

template bool CellModel::code(RangeEncoder&, CellSlots&, const CellSlots*);
template bool CellModel::code(RangeDecoder&, CellSlots&, const CellSlots*);

} // namespace wakesurf::protocol
