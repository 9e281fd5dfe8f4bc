// Finds the bricks of particles, a vector of lanes at a time: each lane keeps the brick that it was found in,
// and only lanes that have left theirs are looked up, one by one.
#pragma once

#include "core/field/kernel/rk4_batch.hpp"

namespace wakesurf::core {

template <class Lanes>
class BrickLookUp {
    using Floats = typename Lanes::Floats;

  public:
    /// Begins with the time-steps of the pair. Bricks found of the same ones stay, also if the two have
    /// changed places, as they do for velocities at the second one's time.
    static void begin(const StoredPair& field, BrickReferences& bricks) {
        const bool unsteady = field.bricks1.at != nullptr;
        const bool smooth = unsteady && field.smooth;
        if (bricks.of[bricks.slot[0]].at != field.bricks0.at) {
            const std::size_t first = bricks.slot[0];
            bricks.slot[0] = bricks.slot[1];
            bricks.slot[1] = first;
        }
        const auto same = [&](std::size_t step, const StoredBricks& stored) {
            return bricks.of[bricks.slot[step]].at == stored.at;
        };
        if (same(0, field.bricks0) && (!unsteady || same(1, field.bricks1)) &&
            (!smooth || (same(2, field.bricks_before) && same(3, field.bricks_after))))
            return;
        const StoredBricks all[4] = {field.bricks0, field.bricks1,
                                     smooth ? field.bricks_before : StoredBricks{},
                                     smooth ? field.bricks_after : StoredBricks{}};
        for (std::size_t step = 0; step < 4; ++step) {
            bricks.slot[step] = step;
            bricks.of[step] = all[step];
        }
        bricks.absent = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t lane = 0; lane < BrickReferences::lanes; ++lane)
                bricks.beyond[axis][lane] = bricks.block_at[axis][lane] = 0.0f;
    }

    /// Returns bits of the lanes from `g` on, a vector of them, whose cells `at` are not in the bricks found,
    /// with so many cells after them; and the cells left in those that are, the lane's own included.
    static unsigned outside(const StoredPair& field,
                            const BrickReferences& bricks,
                            std::size_t g,
                            const Floats (&at)[3],
                            float after,
                            Floats (&left)[3]) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            left[axis] = Floats::load(bricks.beyond[axis] + g) - at[axis];
        const Floats least = Floats::min(Floats::min(left[0], left[1]), left[2]);
        const Floats most = Floats::max(Floats::max(left[0], left[1]), left[2]);
        return Floats::above(Floats::all(1.0f + after), least) |
               Floats::above(most, Floats::all(static_cast<float>(field.places.cells))) |
               (static_cast<unsigned>(bricks.absent >> g) & ((1u << Floats::size) - 1u));
    }

    /// Nodes from the places in cells `left` to the ends of their bricks. Exact: a brick has at most 2^24.
    static void nodes_left(const StoredPair& field, const Floats (&left)[3], std::int64_t* nodes) {
        const Floats sum = left[0] * Floats::all(static_cast<float>(field.places.node[0])) +
                           left[1] * Floats::all(static_cast<float>(field.places.node[1])) +
                           left[2] * Floats::all(static_cast<float>(field.places.node[2]));
        sum.low().widen().integers(nodes);
        sum.high().widen().integers(nodes + Lanes::Wide::size);
    }

    /// Keeps the brick of a lane's cell from now on.
    static void
    keep(const StoredPair& field, Rk4Batch& batch, std::size_t lane, const float (&cell)[3]) {
        const BrickPlaces& in = field.places;
        BrickReferences& bricks = batch.bricks;
        std::int64_t number = 0, nodes = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto brick = static_cast<std::int64_t>(cell[axis] * in.per_cell);
            number += brick * static_cast<std::int64_t>(in.brick[axis]);
            nodes += static_cast<std::int64_t>(in.cells) * static_cast<std::int64_t>(in.node[axis]);
            bricks.beyond[axis][lane] =
                static_cast<float>(static_cast<double>(brick + 1) * in.cells);
        }
        bricks.absent &= ~(std::uint64_t{1} << lane);
        for (std::size_t slot = 0; slot < 4; ++slot)
            if (bricks.of[slot].at != nullptr)
                bricks.end[slot][lane] =
                    (in_memory(in, batch, lane, bricks.of[slot], number) - in.zeros) + 3 * nodes;
    }

    /// Returns a brick of a time-step; if it is missing, the lane is marked and gets zeros.
    static const float* in_memory(const BrickPlaces& in,
                                  Rk4Batch& batch,
                                  std::size_t lane,
                                  const StoredBricks& step,
                                  std::int64_t number) {
        const float* found = __atomic_load_n(step.at + number, __ATOMIC_ACQUIRE);
        if (found == nullptr) {
            const auto bit = Rk4Batch::Bits{1} << lane;
            batch.bricks.absent |= bit;
            batch.missing |= bit;
            batch.missing_brick[lane] = static_cast<std::uint32_t>(number);
            return in.zeros;
        }
        std::uint16_t* used = step.used + number;
        if (__atomic_load_n(used, __ATOMIC_RELAXED) != in.age)
            __atomic_store_n(used, in.age, __ATOMIC_RELAXED);
        return found;
    }
};

} // namespace wakesurf::core
