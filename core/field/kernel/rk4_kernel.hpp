// One RK4 step of a batch of particles through stored data, trilinear in space and linear in time, written once for
// vectors of any make: `Lanes` offers Row (8 floats: a row of two nodes), Quad (4 floats: one vector) and Wide (4
// doubles). Every operation is the same IEEE operation in the same order whatever the make, so all give the same bits.
// Layout and batching: measured best of 14 (docs/measurements.md, The limit of the kernel): velocity as in the file, an x-pair of nodes a load.
#pragma once

#include "core/field/kernel/rk4_batch.hpp"

namespace wakesurf::core {

template <class Lanes, bool Unsteady, bool Tangents>
class Rk4KernelOf {
    using Row = typename Lanes::Row;
    using Quad = typename Lanes::Quad;
    using Wide = typename Lanes::Wide;

  public:
    static void step(const StoredPair& field, Rk4Batch& batch) {
        begin(field, batch);
        stage<0>(field, batch);
        stage<1>(field, batch);
        stage<2>(field, batch);
        stage<3>(field, batch);
        finish(field, batch);
    }

  private:
    static void begin(const StoredPair& field, Rk4Batch& batch) {
        for (std::size_t i = 0; i < batch.count; ++i) {
            const double time = batch.start[i] + batch.taken[i] * batch.dt[i];
            const double blend = (time - field.time0) * field.per_interval;
            const double change = batch.dt[i] * field.per_interval;
            batch.later[0][i] = static_cast<float>(blend);
            batch.later[1][i] = static_cast<float>(blend + 0.5 * change);
            batch.later[2][i] = static_cast<float>(blend + change);
            for (int at = 0; at < 3; ++at)
                batch.earlier[at][i] = 1.0f - batch.later[at][i];
            batch.step[i] = static_cast<float>(batch.dt[i]);
        }
        const Wide per_spacing = Wide::load(field.per_spacing);
        const Wide origin = Wide::load(field.origin);
        for (std::size_t i = 0; i < batch.count; ++i) {
            const Wide cells = (Wide::load(batch.position[i]) - origin) * per_spacing;
            cells.store(batch.cell_position[i]);
            (per_spacing * Wide::all(batch.dt[i])).narrow().store(batch.scale[i]);
            locate(field, batch, i, cells);
            if constexpr (Tangents)
                Lanes::narrow(batch.tangent[i]).store(batch.tangent0[i]);
        }
    }

    /// Outside points get the nearest border cell and fractions clamped to it; so does NaN, which Wide::max replaces.
    static void locate(const StoredPair& field, Rk4Batch& batch, std::size_t i, const Wide& cells) {
        const Wide x = Wide::min(Wide::max(cells, Wide::all(0.0)), Wide::load(field.last));
        std::int64_t index[3];
        const Wide cell = Wide::min(x, Wide::load(field.last_cell)).truncated(index);
        (x - cell).narrow().store(batch.fraction[i]);
        batch.node[i] = index[0] + index[1] * field.row + index[2] * field.slice;
    }

    /// Velocity, and its slopes along the cell's axes where tangents are carried.
    struct Sample {
        Quad value, along_x, along_y, along_z;
    };

    static Row
    row(const StoredPair& field, std::int64_t node, const Row& earlier, const Row& later) {
        if constexpr (Unsteady)
            return Row::load(field.velocity0 + 3 * node) * earlier +
                   Row::load(field.velocity1 + 3 * node) * later;
        else
            return Row::load(field.velocity0 + 3 * node);
    }

    static Sample sample(const StoredPair& field, const Rk4Batch& batch, std::size_t i, int time) {
        const Row later = Row::all(batch.later[time][i]);
        const Row earlier = Row::all(batch.earlier[time][i]);
        const std::int64_t node = batch.node[i];
        const Row r00 = row(field, node, earlier, later);
        const Row r10 = row(field, node + field.row, earlier, later);
        const Row r01 = row(field, node + field.slice, earlier, later);
        const Row r11 = row(field, node + field.slice + field.row, earlier, later);
        const Row fy = Row::all(batch.fraction[i][1]);
        const Row fz = Row::all(batch.fraction[i][2]);
        const Quad fx = Quad::all(batch.fraction[i][0]);
        const Row y0 = r10 - r00;
        const Row y1 = r11 - r01;
        const Row low = r00 + fy * y0;
        const Row along_z = r01 + fy * y1 - low;
        const Row whole = low + fz * along_z;
        const Quad first = whole.first();
        const Quad along_x = whole.second() - first;
        Sample result;
        result.value = first + fx * along_x;
        if constexpr (Tangents) {
            const Row along_y = y0 + fz * (y1 - y0);
            result.along_x = along_x;
            result.along_y = along_y.first() + fx * (along_y.second() - along_y.first());
            result.along_z = along_z.first() + fx * (along_z.second() - along_z.first());
        }
        return result;
    }

    /// (grad v) w for both tangents, w in length units.
    static Row derivative(const StoredPair& field, const Sample& at, const Row& w) {
        const Quad per_spacing = Wide::load(field.per_spacing).narrow();
        const Row cells = w * Row::twice(per_spacing);
        return Row::twice(at.along_x) * cells.template each<0>() +
               Row::twice(at.along_y) * cells.template each<1>() +
               Row::twice(at.along_z) * cells.template each<2>();
    }

    template <int Stage>
    static void stage(const StoredPair& field, Rk4Batch& batch) {
        constexpr float weight = Stage == 0 || Stage == 3 ? 1.0f : 2.0f;
        constexpr float reach = Stage == 2 ? 1.0f : 0.5f; // of the next stage
        constexpr int time = (Stage + 1) / 2;
        if constexpr (Stage > 0)
            for (std::size_t i = 0; i < batch.count; ++i)
                locate(field, batch, i,
                       Wide::load(batch.cell_position[i]) + Quad::load(batch.increment[i]).widen());
        for (std::size_t i = 0; i < batch.count; ++i) {
            const Sample at = sample(field, batch, i, time);
            if constexpr (Stage == 0)
                at.value.store(batch.sum[i]);
            else
                (Quad::load(batch.sum[i]) + Quad::all(weight) * at.value).store(batch.sum[i]);
            if constexpr (Stage < 3)
                (at.value * (Quad::all(reach) * Quad::load(batch.scale[i])))
                    .store(batch.increment[i]);
            if constexpr (Stage == 0)
                batch.slow[i] = !((at.value * at.value).sum3() > field.stagnation2);
            if constexpr (Tangents) {
                Row w = Row::load(batch.tangent0[i]);
                if constexpr (Stage > 0)
                    w = w + Row::load(batch.tangent_increment[i]);
                const Row change = derivative(field, at, w);
                if constexpr (Stage == 0)
                    change.store(batch.tangent_sum[i]);
                else
                    (Row::load(batch.tangent_sum[i]) + Row::all(weight) * change)
                        .store(batch.tangent_sum[i]);
                if constexpr (Stage < 3)
                    (change * Row::all(reach * batch.step[i])).store(batch.tangent_increment[i]);
            }
        }
    }

    static void finish(const StoredPair& field, Rk4Batch& batch) {
        const Wide low = Wide::load(field.low);
        const Wide high = Wide::load(field.high);
        for (std::size_t i = 0; i < batch.count; ++i) {
            const Wide sixth = Wide::all(batch.dt[i] / 6.0);
            const Wide next =
                Wide::load(batch.position[i]) + sixth * Quad::load(batch.sum[i]).widen();
            next.store(batch.next[i]);
            batch.outside[i] = !Wide::between(low, next, high);
            if constexpr (Tangents)
                for (std::size_t w = 0; w < 8; w += 4)
                    (Wide::load(batch.tangent[i] + w) +
                     sixth * Quad::load(batch.tangent_sum[i] + w).widen())
                        .store(batch.next_tangent[i] + w);
        }
        if (field.cell == nullptr)
            return;
        const Wide origin = Wide::load(field.origin);
        const Wide per_spacing = Wide::load(field.per_spacing);
        for (std::size_t i = 0; i < batch.count; ++i) {
            locate(field, batch, i, (Wide::load(batch.next[i]) - origin) * per_spacing);
            if (field.cell[batch.node[i]] != 0)
                batch.outside[i] = true;
        }
    }
};

template <class Lanes>
void rk4_step(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    if (field.velocity1 != nullptr)
        tangents ? Rk4KernelOf<Lanes, true, true>::step(field, batch)
                 : Rk4KernelOf<Lanes, true, false>::step(field, batch);
    else
        tangents ? Rk4KernelOf<Lanes, false, true>::step(field, batch)
                 : Rk4KernelOf<Lanes, false, false>::step(field, batch);
}

} // namespace wakesurf::core
