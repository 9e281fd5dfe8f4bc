// RK4 steps of a batch of particles through stored data, written once for vectors of any make. `Lanes` says
// how many particles are sampled `together`, 1 or 2, and offers for each of them: in Floats 8 floats, a row
// of two nodes or one number of 8 particles; in Quad 4, one vector; in Wide 4 doubles. Every operation is the
// same IEEE operation in the same order whatever the make, so all give the same bits. What samples the field
// is a class of its own.
#pragma once

#include "core/field/kernel/cubic_sampling.hpp"
#include "core/field/kernel/linear_sampling.hpp"
#include "core/field/kernel/rectilinear_places.hpp"
#include "core/field/kernel/stored_states.hpp"

namespace wakesurf::core {

template <class Lanes, class Places, class Sampling, bool Tangents>
class Rk4KernelOf {
    using Floats = typename Lanes::Floats;
    using Quad = typename Lanes::Quad;
    using Wide = typename Lanes::Wide;
    using Bits = Rk4Batch::Bits;
    static constexpr std::size_t most = Rk4Batch::most;

    /// A bit for each element of a vector.
    template <class Vector>
    static constexpr unsigned all_of = (1u << Vector::size) - 1u;

  public:
    /// Flattened: with calls between the stages the constants of a batch leave their registers.
    [[gnu::flatten]] static void carry(const StoredPair& field, Rk4Batch& batch) {
        Rk4KernelOf kernel(field, batch);
        kernel.set_out();
        kernel.places_.begin(field, batch.position, kernel.end_);
        if (batch.velocity_only) {
            kernel.find_velocities();
            return;
        }
        const bool straight = batch.straight != 0;
        auto& next = straight ? batch.position : batch.next;
        auto& next_tangent = straight ? batch.tangent : batch.next_tangent;
        std::size_t i = 0;
        do {
            if (batch.share_of_steps != nullptr)
                kernel.share(batch.share_of_steps + 12 * i);
            kernel.step(next, next_tangent);
            const bool walls = field.cell.whole != nullptr || field.cell.bricks != nullptr;
            if (straight || walls)
                kernel.places_.begin(field, next, kernel.end_);
            if (walls)
                kernel.look_for_walls();
            for (std::size_t g = 0; straight && g < kernel.end_; g += Wide::size)
                (Wide::load(batch.taken + g) + Wide::all(1.0)).store(batch.taken + g);
        } while (++i < batch.straight);
    }

  private:
    Rk4KernelOf(const StoredPair& field, Rk4Batch& batch)
        : field_(field), batch_(batch),
          end_((batch.count + Floats::size - 1) / Floats::size * Floats::size) {}

    void set_out() {
        batch_.slow = batch_.outside = batch_.last = batch_.missing = 0;
        for (std::size_t g = 0; g < end_; g += Wide::size) {
            const Wide dt = Wide::load(batch_.dt + g);
            dt.narrow().store(dt_ + g);
            (dt / Wide::all(6.0)).store(sixth_ + g);
            for (std::size_t axis = 0; axis < 3; ++axis)
                (Wide::all(field_.per_spacing[axis]) * dt).narrow().store(scale_[axis] + g);
        }
    }

    void stay() {
        sampling_.begin(field_, batch_, end_);
        for (std::size_t g = 0; g < end_; g += Floats::size)
            places_.stay(g, [&](const auto& cell, const auto& fraction) {
                sampling_.place(field_, batch_, places_, g, cell, fraction);
            });
    }

    void find_velocities() {
        if (batch_.share_of_steps != nullptr)
            share(batch_.share_of_steps);
        stay();
        const auto sampling = sampling_.stage(field_, batch_, 0);
        for (std::size_t i = 0; i < batch_.count; i += Lanes::together)
            sampling.sample(i).value.store(batch_.velocity[i]);
    }

    /// Takes a step from the places where the particles are. @param next may be where they are now
    void step(double (&next)[3][most], double (&next_tangent)[most][8]) {
        stay();
        if constexpr (Tangents)
            for (std::size_t i = 0; i < batch_.count; i += Lanes::together)
                Lanes::narrow(batch_.tangent[i]).store(tangent_[i]);
        stage<0>();
        stage<1>();
        stage<2>();
        stage<3>();
        finish(next, next_tangent);
    }

    /// Sets the shares of the time-steps, the same for all.
    void share(const float* shares) {
        for (std::size_t at = 0; at < 3; ++at)
            for (std::size_t step = 0; step < 4; ++step)
                for (std::size_t g = 0; g < end_; g += Floats::size)
                    Floats::all(shares[4 * at + step]).store(batch_.share[at][step] + g);
    }

    template <int Stage>
    void stage() {
        constexpr float weight = Stage == 0 || Stage == 3 ? 1.0f : 2.0f;
        constexpr float reach = Stage == 2 ? 1.0f : 0.5f; // of the next stage
        const auto sampling = sampling_.stage(field_, batch_, (Stage + 1) / 2);
        // Places follow from samples of a vector of particles: while they wait for the last of these, the
        // next are sampled.
        for (std::size_t g = 0; g < end_; g += Floats::size) {
            const std::size_t end =
                g + Floats::size < batch_.count ? g + Floats::size : batch_.count;
            for (std::size_t i = g; i < end; i += Lanes::together) {
                const KernelSample<Lanes> at = sampling.sample(i);
                at.value.store(value_[i]);
                if constexpr (Tangents)
                    carry_tangents<Stage>(i, at, weight, reach);
            }
            Floats v[3];
            Floats::components(&value_[g], v);
            if constexpr (Stage == 0)
                batch_.slow |= Bits{~Floats::above(v[0] * v[0] + v[1] * v[1] + v[2] * v[2],
                                                   Floats::all(field_.stagnation2)) &
                                    all_of<Floats>}
                               << g;
            Floats by[3];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if constexpr (Stage == 0)
                    v[axis].store(sum_[axis] + g);
                else
                    (Floats::load(sum_[axis] + g) + Floats::all(weight) * v[axis])
                        .store(sum_[axis] + g);
                by[axis] = v[axis] * (Floats::all(reach) * Floats::load(scale_[axis] + g));
            }
            if constexpr (Stage < 3)
                places_.move(field_, g, by, [&](const auto& cell, const auto& fraction) {
                    sampling_.place(field_, batch_, places_, g, cell, fraction);
                });
        }
    }

    /// Both tangents w of particles that go together: w' = (grad v) w, w in length units.
    template <int Stage>
    void carry_tangents(std::size_t i, const KernelSample<Lanes>& at, float weight, float reach) {
        Floats w = Floats::load(tangent_[i]);
        if constexpr (Stage > 0)
            w = w + Floats::load(tangent_increment_[i]);
        Floats cells[3];
        places_.in_cells(w, i, cells);
        const Floats change = Floats::twice(at.along_x) * cells[0] +
                              at.along_yz.low_twice() * cells[1] +
                              at.along_yz.high_twice() * cells[2];
        if constexpr (Stage == 1)
            take_divergence(i, at);
        if constexpr (Stage == 0)
            change.store(tangent_sum_[i]);
        else
            (Floats::load(tangent_sum_[i]) + Floats::all(weight) * change).store(tangent_sum_[i]);
        if constexpr (Stage < 3)
            (change * (Floats::all(reach) * Floats::each_of(dt_ + i))).store(tangent_increment_[i]);
    }

    /// The midpoint rule is enough: errors grow by it, and need not be known to many digits.
    void take_divergence(std::size_t i, const KernelSample<Lanes>& at) {
        alignas(64) float along_x[Lanes::together][4], along_yz[2][Lanes::together][4];
        at.along_x.store(along_x[0]);
        at.along_yz.store(along_yz[0][0]);
        for (std::size_t k = 0; k < Lanes::together; ++k)
            divergence_[i + k] = along_x[k][0] * places_.per_length(0, i + k) +
                                 along_yz[0][k][1] * places_.per_length(1, i + k) +
                                 along_yz[1][k][2] * places_.per_length(2, i + k);
    }

    void finish(double (&next)[3][most], double (&next_tangent)[most][8]) {
        for (std::size_t g = 0; g < end_; g += Wide::size) {
            const Wide sixth = Wide::load(sixth_ + g);
            unsigned inside = all_of<Wide>;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Wide there = Wide::load(batch_.position[axis] + g) +
                                   sixth * Quad::load(sum_[axis] + g).widen();
                there.store(next[axis] + g);
                inside &= Wide::not_above(Wide::all(field_.low[axis]), there) &
                          Wide::not_above(there, Wide::all(field_.high[axis]));
            }
            batch_.outside |= Bits{~inside & all_of<Wide>} << g;
            const Wide taken = Wide::load(batch_.taken + g) + Wide::all(1.0);
            batch_.last |= Bits{Wide::not_above(Wide::load(batch_.steps + g), taken)} << g;
        }
        if constexpr (Tangents)
            for (std::size_t i = 0; i < batch_.count; ++i)
                tangent_sum_[i][3] = 6.0f * divergence_[i];
        if constexpr (Tangents)
            for (std::size_t w = 0; w < 8 * batch_.count; w += Wide::size)
                (Wide::load(batch_.tangent[w / 8] + w % 8) +
                 Wide::all(sixth_[w / 8]) * Quad::load(tangent_sum_[w / 8] + w % 8).widen())
                    .store(next_tangent[w / 8] + w % 8);
    }

    /// Tests for walls at the places that were taken last.
    void look_for_walls() {
        const Floats none = Floats::all(0.0f);
        for (std::size_t g = 0; g < end_; g += Floats::size)
            batch_.outside |=
                Bits{lanes_with_state<Lanes>(field_, field_.cell, places_, g, {none, none, none})}
                << g;
    }

    const StoredPair& field_;
    Rk4Batch& batch_;
    std::size_t end_; ///< lanes computed
    Places places_;
    Sampling sampling_;
    alignas(64) float scale_[3][most]; ///< velocity to cells a step
    alignas(64) float sum_[3][most];   ///< of the stages' velocities
    alignas(64) float dt_[most];
    alignas(64) double sixth_[most]; ///< of the step
    alignas(64) float value_[most][4] = {};
    alignas(64) float tangent_[Tangents ? most : 1][8];
    alignas(64) float tangent_increment_[Tangents ? most : 1][8];
    alignas(64) float tangent_sum_[Tangents ? most : 1][8];
    alignas(64) float divergence_[Tangents ? most : 1];
};

template <class Lanes, bool Tangents>
void rk4_step_with(const StoredPair& field, Rk4Batch& batch) {
    const bool unsteady = field.velocity1 != nullptr || field.bricks1.at != nullptr;
    const auto linear_in = [&]<class Places, class Nodes>() {
        if (unsteady)
            Rk4KernelOf<Lanes, Places, LinearSampling<Lanes, Places, Nodes, true, Tangents>,
                        Tangents>::carry(field, batch);
        else
            Rk4KernelOf<Lanes, Places, LinearSampling<Lanes, Places, Nodes, false, Tangents>,
                        Tangents>::carry(field, batch);
    };
    const auto linear = [&]<class Places>() {
        if (field.in_bricks)
            linear_in.template operator()<Places, BrickNodes<Lanes>>();
        else
            linear_in.template operator()<Places, WholeNodes<Lanes>>();
    };
    using Uniform = UniformPlaces<Lanes>;
    const auto cubic = [&]<std::size_t Times, class Blocks>() {
        Rk4KernelOf<Lanes, Uniform, CubicSampling<Lanes, Times, Blocks, Tangents>, Tangents>::carry(
            field, batch);
    };
    if (field.axis != nullptr)
        linear.template operator()<RectilinearPlaces<Lanes, Tangents>>();
    else if (!field.smooth)
        linear.template operator()<Uniform>();
    else if (unsteady && field.in_bricks)
        cubic.template operator()<4, BrickBlocks<Lanes, 4>>();
    else if (unsteady)
        cubic.template operator()<4, WholeBlocks<Lanes, 4>>();
    else if (field.in_bricks)
        cubic.template operator()<1, BrickBlocks<Lanes, 1>>();
    else
        cubic.template operator()<1, WholeBlocks<Lanes, 1>>();
}

template <class Lanes>
void rk4_step(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    tangents ? rk4_step_with<Lanes, true>(field, batch) : rk4_step_with<Lanes, false>(field, batch);
}

} // namespace wakesurf::core
