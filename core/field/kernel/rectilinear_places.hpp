// Where the particles of a batch are in the cells of a rectilinear grid: the cell in double at the start of a
// step, and from there in float, in lengths from the cell's lower end. A particle keeps its cell with both
// neighbours from step to step, so that a stage only chooses among the three. Twin: uniform_places.hpp.
#pragma once

#include "core/field/kernel/uniform_places.hpp"

namespace wakesurf::core {

/// @tparam Tangents  the cells' widths are asked for
template <class Lanes, bool Tangents>
class RectilinearPlaces {
    using Floats = typename Lanes::Floats;
    using Wide = typename Lanes::Wide;
    static constexpr std::size_t most = Rk4Batch::most;

  public:
    /// Begins as UniformPlaces does. Cells are those that RectilinearAxes finds: a face belongs to the one
    /// after it.
    void begin(const StoredPair& field, const double (&position)[3][most], std::size_t end) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double(&x)[most] = position[axis];
            if (begun_)
                follow(axis, field.axis[axis], x, end);
            else
                for (std::size_t lane = 0; lane < end; ++lane)
                    enter(axis, field.axis[axis], lane, find(field.axis[axis], x[lane]));
        }
        begun_ = true;
        for (std::size_t g = 0; g < end; g += Wide::size) {
            Wide node = Wide::all(0.0);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                (Wide::load(position[axis] + g) - Wide::load(low_[axis] + g))
                    .narrow()
                    .store(start_[axis] + g);
                node = node + Wide::load(cell_[axis] + g) * Wide::all(field.stride[axis]);
            }
            node.store(node_ + g);
        }
    }

    /// Moves as UniformPlaces does, `by` in lengths.
    template <class Place>
    void move(const StoredPair& field, std::size_t g, const Floats (&by)[3], const Place& place) {
        const Floats none = Floats::all(0.0f);
        const Floats one = Floats::all(1.0f);
        Floats cell[3];
        Floats fraction[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Reach& reach = reach_[axis];
            const Floats x = Floats::load(start_[axis] + g) + by[axis];
            const Floats begin = Floats::load(reach.begin + g);
            const Floats end = Floats::load(reach.end + g);
            const auto choose = [&](Floats before, Floats here, Floats after) {
                return Floats::where_above(begin, x, before,
                                           Floats::where_above(x, end, after, here));
            };
            cell[axis] = choose(none - one, none, one);
            const Floats scale =
                choose(Floats::load(reach.per_width_before + g), Floats::load(reach.per_width + g),
                       Floats::load(reach.per_width_after + g));
            if constexpr (Tangents)
                scale.store(scale_[axis] + g);
            const Floats from = choose(Floats::load(reach.lowest + g), none, end);
            fraction[axis] = Floats::min(Floats::max((x - from) * scale, none), one);
            if (const unsigned far = Floats::above(Floats::load(reach.below + g), x) |
                                     Floats::above(x, Floats::load(reach.above + g)))
                go_far(field.axis[axis], axis, g, far, x, cell[axis], fraction[axis]);
        }
        place(cell, fraction);
    }

    template <class Place>
    void stay(std::size_t g, const Place& place) {
        const Floats none = Floats::all(0.0f);
        const Floats cell[3] = {none, none, none};
        Floats fraction[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats scale = Floats::load(reach_[axis].per_width + g);
            if constexpr (Tangents)
                scale.store(scale_[axis] + g);
            fraction[axis] = Floats::min(Floats::max(Floats::load(start_[axis] + g) * scale, none),
                                         Floats::all(1.0f));
        }
        place(cell, fraction);
    }

    void nodes(const StoredPair& field,
               std::size_t g,
               const Floats (&cell)[3],
               std::int64_t* node) const {
        nodes_from<Lanes>(field, node_ + g, cell, node);
    }

    /// Finds cells like UniformPlaces, in the cells of the last move.
    void in_cells(const Floats& w, std::size_t i, Floats (&cells)[3]) const {
        cells[0] = w.template each<0>() * Floats::each_of(scale_[0] + i);
        cells[1] = w.template each<1>() * Floats::each_of(scale_[1] + i);
        cells[2] = w.template each<2>() * Floats::each_of(scale_[2] + i);
    }

    /// Returns cells per unit of length where a lane is.
    float per_length(std::size_t axis, std::size_t i) const { return scale_[axis][i]; }

    /// Returns the first cells of lanes from `g` on, exactly: an axis has fewer than 2^24 cells.
    Floats first_cell(std::size_t axis, std::size_t g) const {
        return Floats::both(Wide::load(cell_[axis] + g).narrow(),
                            Wide::load(cell_[axis] + g + Wide::size).narrow());
    }

  private:
    /// The CellReach of each particle's cell.
    struct Reach {
        alignas(64) float lowest[most];
        alignas(64) float begin[most];
        alignas(64) float below[most];
        alignas(64) float above[most];
        alignas(64) float end[most];
        alignas(64) float per_width_before[most];
        alignas(64) float per_width[most];
        alignas(64) float per_width_after[most];
    };

    /// Finds the cells of lanes that have left theirs since the step before. Those lanes are found first,
    /// without a branch a particle.
    void
    follow(std::size_t axis, const AxisTable& table, const double (&x)[most], std::size_t end) {
        Rk4Batch::Bits inside = 0;
        for (std::size_t g = 0; g < end; g += Wide::size) {
            const Wide at = Wide::load(x + g);
            inside |= Rk4Batch::Bits{Wide::not_above(Wide::load(low_[axis] + g), at) &
                                     ~Wide::not_above(Wide::load(high_[axis] + g), at)}
                      << g;
        }
        for (auto others = ~inside & ((Rk4Batch::Bits{1} << end) - 1u); others != 0;
             others &= others - 1u) {
            const auto lane = static_cast<std::size_t>(__builtin_ctzll(others));
            const auto cell = static_cast<std::int64_t>(cell_[axis][lane]);
            const std::int64_t next = cell + (x[lane] >= high_[axis][lane] ? 1 : 0) -
                                      (x[lane] >= low_[axis][lane] ? 0 : 1);
            const auto near = next < 0 ? std::int64_t{0} : next > table.last ? table.last : next;
            enter(axis, table, lane, walk(table, x[lane], static_cast<std::uint32_t>(near)));
        }
    }

    static std::uint32_t find(const AxisTable& table, double x) {
        const double at = (x - table.coordinate[0]) * table.per_bucket;
        const double last = table.buckets - 1.0;
        return walk(table, x,
                    at > 0.0 ? table.start[static_cast<std::uint32_t>(at < last ? at : last)] : 0);
    }

    /// Returns the cell of `x`, walking from a cell near by. NaN is in the first cell.
    static std::uint32_t walk(const AxisTable& table, double x, std::uint32_t cell) {
        while (cell < table.last && x >= table.coordinate[cell + 1])
            ++cell;
        while (cell > 0 && !(x >= table.coordinate[cell]))
            --cell;
        return cell;
    }

    void enter(std::size_t axis, const AxisTable& table, std::size_t lane, std::uint32_t cell) {
        cell_[axis][lane] = cell;
        low_[axis][lane] = table.coordinate[cell];
        high_[axis][lane] = table.coordinate[cell + 1];
        const CellReach& from = table.cell[cell];
        Reach& to = reach_[axis];
        to.lowest[lane] = from.lowest;
        to.begin[lane] = from.begin;
        to.below[lane] = from.below;
        to.above[lane] = from.above;
        to.end[lane] = from.end;
        to.per_width_before[lane] = from.per_width_before;
        to.per_width[lane] = from.per_width;
        to.per_width_after[lane] = from.per_width_after;
    }

    /// Finds the cells of particles that went beyond their neighbours' cells, `far` a bit each. They are
    /// rare, so it goes one by one.
    void go_far(const AxisTable& table,
                std::size_t axis,
                std::size_t g,
                unsigned far,
                const Floats& from_low,
                Floats& cell,
                Floats& fraction) {
        alignas(64) float x[Floats::size];
        alignas(64) float cells[Floats::size];
        alignas(64) float fractions[Floats::size];
        from_low.store(x);
        cell.store(cells);
        fraction.store(fractions);
        for (; far != 0; far &= far - 1u) {
            const auto i = static_cast<std::size_t>(__builtin_ctz(far));
            const double low = low_[axis][g + i];
            const auto first = static_cast<std::uint32_t>(cell_[axis][g + i]);
            const double there = low + x[i];
            const std::uint32_t at = walk(table, there, first);
            const float scale = table.cell[at].per_width;
            const float part = static_cast<float>(there - table.coordinate[at]) * scale;
            cells[i] = static_cast<float>(at) - static_cast<float>(first);
            fractions[i] = part > 0.0f ? (part < 1.0f ? part : 1.0f) : 0.0f;
            if constexpr (Tangents)
                scale_[axis][g + i] = scale;
        }
        cell = Floats::load(cells);
        fraction = Floats::load(fractions);
    }

    bool begun_ = false; ///< cells are those of the step before
    alignas(64) float start_[3][most];
    /// Counts cells a unit of length, in the cell of the last move.
    alignas(64) float scale_[Tangents ? 3 : 1][most];
    alignas(64) double low_[3][most]; ///< ends of the cell
    alignas(64) double high_[3][most];
    alignas(64) double cell_[3][most]; ///< its index
    alignas(64) double node_[most];    ///< its lowest
    Reach reach_[3];
};

} // namespace wakesurf::core
