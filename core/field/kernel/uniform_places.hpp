// Where the particles of a batch are, in cells of a uniform grid: in double at the start of a step, and from
// there in float, as far as the stages of the step reach. As many particles at once as a vector has floats.
// Twin: rectilinear_places.hpp.
#pragma once

#include "core/field/kernel/rk4_batch.hpp"

namespace wakesurf::core {

/// Lowest nodes of the cells `cell` away from those whose lowest nodes are `first`.
template <class Lanes>
void nodes_from(const StoredPair& field,
                const double* first,
                const typename Lanes::Floats (&cell)[3],
                std::int64_t* node) {
    using Wide = typename Lanes::Wide;
    Wide low = Wide::load(first);
    Wide high = Wide::load(first + Wide::size);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Wide stride = Wide::all(field.stride[axis]);
        low = low + cell[axis].low().widen() * stride;
        high = high + cell[axis].high().widen() * stride;
    }
    low.integers(node);
    high.integers(node + Wide::size);
}

template <class Lanes>
class UniformPlaces {
    using Floats = typename Lanes::Floats;
    using Wide = typename Lanes::Wide;

  public:
    /// Takes the places of lanes 0 to `end`, a multiple of Floats::size. Outside points get the nearest
    /// border cell and fractions clamped to it; so does NaN, which Wide::max replaces.
    void
    begin(const StoredPair& field, const double (&position)[3][Rk4Batch::most], std::size_t end) {
        per_spacing_ = Floats::twice_of(static_cast<float>(field.per_spacing[0]),
                                        static_cast<float>(field.per_spacing[1]),
                                        static_cast<float>(field.per_spacing[2]));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            per_length_[axis] = static_cast<float>(field.per_spacing[axis]);
            last_[axis] = static_cast<float>(field.last[axis]);
            last_cell_[axis] = static_cast<float>(field.last_cell[axis]);
        }
        const Wide zero = Wide::all(0.0);
        for (std::size_t g = 0; g < end; g += Wide::size) {
            Wide node = zero;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Wide cells =
                    (Wide::load(position[axis] + g) - Wide::all(field.origin[axis])) *
                    Wide::all(field.per_spacing[axis]);
                const Wide x = Wide::min(Wide::max(cells, zero), Wide::all(field.last[axis]));
                const Wide cell = Wide::min(x, Wide::all(field.last_cell[axis])).truncated();
                (cells - cell).narrow().store(start_[axis] + g);
                cell.narrow().store(cell_[axis] + g);
                node = node + cell * Wide::all(field.stride[axis]);
            }
            node.store(node_ + g);
        }
    }

    /// Calls `place(cell, fraction)` for the places `by` (times per_spacing: cells) from where lanes from `g`
    /// on, a vector of them, began; cells count from the first one's.
    template <class Place>
    void move(const StoredPair&, std::size_t g, const Floats (&by)[3], const Place& place) {
        Floats cell[3];
        Floats fraction[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats first = Floats::load(cell_[axis] + g);
            const Floats last = Floats::all(last_[axis]) - first;
            const Floats last_cell = Floats::all(last_cell_[axis]) - first;
            const Floats x = Floats::min(
                Floats::max(Floats::load(start_[axis] + g) + by[axis], Floats::all(0.0f) - first),
                last);
            cell[axis] = Floats::min(x.floor(), last_cell);
            fraction[axis] = x - cell[axis];
        }
        place(cell, fraction);
    }

    /// Stays where the particles began.
    template <class Place>
    void stay(std::size_t g, const Place& place) {
        const Floats none = Floats::all(0.0f);
        const Floats cell[3] = {none, none, none};
        Floats fraction[3];
        for (std::size_t axis = 0; axis < 3; ++axis)
            fraction[axis] =
                Floats::min(Floats::max(Floats::load(start_[axis] + g), none), Floats::all(1.0f));
        place(cell, fraction);
    }

    /// Returns the lowest nodes of cells counted from the first ones.
    void nodes(const StoredPair& field,
               std::size_t g,
               const Floats (&cell)[3],
               std::int64_t* node) const {
        nodes_from<Lanes>(field, node_ + g, cell, node);
    }

    /// Tangents `w`, in length units, of particle `i` and those that go together with it: their components in
    /// cells, all over each.
    void in_cells(const Floats& w, std::size_t /*i*/, Floats (&cells)[3]) const {
        const Floats scaled = w * per_spacing_;
        cells[0] = scaled.template each<0>();
        cells[1] = scaled.template each<1>();
        cells[2] = scaled.template each<2>();
    }

    /// Returns cells per unit of length where a lane is.
    float per_length(std::size_t axis, std::size_t /*i*/) const { return per_length_[axis]; }

    /// Returns the number of cells to the last one on an axis, from those at `cell`.
    Floats to_last_cell(std::size_t axis, const Floats& cell) const {
        return Floats::all(last_cell_[axis]) - cell;
    }

    /// Returns the first cells of lanes from `g` on.
    Floats first_cell(std::size_t axis, std::size_t g) const {
        return Floats::load(cell_[axis] + g);
    }

  private:
    /// Counts from the first cell; outside the domain beyond it.
    alignas(32) float start_[3][Rk4Batch::most];
    alignas(64) float cell_[3][Rk4Batch::most];
    alignas(64) double node_[Rk4Batch::most];
    float last_[3];
    float last_cell_[3];
    float per_length_[3];
    Floats per_spacing_; ///< of x, y and z, as tangents are
};

} // namespace wakesurf::core
