// Particles on their way through stored data in the lanes of a batch, step by step: each with a time and a
// number of steps of its own. Those that start together are carried in lockstep first (LockstepBatch in
// advance_stored.cpp), and come here if they may end.
#pragma once

#include "core/field/advance_particles.hpp"
#include "core/field/cubic_sampler.hpp"
#include "core/field/kernel/rk4_batch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>
#include <utility>

namespace wakesurf::core {

/// Returns the lanes that miss a brick, which the field's view notes.
template <class Field>
Rk4Batch::Bits note_missing(const Field& view, const Rk4Batch& batch) {
    const Rk4Batch::Bits all = (Rk4Batch::Bits{1} << batch.count) - 1u;
    for (Rk4Batch::Bits some = all & batch.missing; some != 0; some &= some - 1u)
        view.note_missing(batch.missing_brick[std::countr_zero(some)]);
    return all & batch.missing;
}

/// Carries particles of one range in the lanes of a batch. A particle takes a lane for all its steps, and
/// then leaves the lane to the next: particles with more steps delay no others.
/// @tparam Field  computes in double the steps in which particles end
template <class Field>
class RefillBatch {
  public:
    RefillBatch(const Field& field,
                const StoredPair& pair,
                Rk4Kernel kernel,
                const Particles& particles,
                double to,
                const AdvanceOptions& options)
        : field_(field), pair_(pair), kernel_(kernel), particles_(particles), to_(to),
          options_(options) {}

    bool full() const { return batch_.count == Rk4Batch::most; }

    bool empty() const { return batch_.count == 0; }

    void enqueue(std::size_t particle) {
        const std::size_t lane = batch_.count++;
        put(lane, take_out(particles_, particle).carried);
        const double whole = to_ - particles_.time[particle];
        if (whole != whole_) { // most set out together: saves 4 % of a one-step advance
            whole_ = whole;
            steps_ = rk4_steps(whole, options_);
            dt_ = whole / steps_;
        }
        batch_.start[lane] = particles_.time[particle];
        batch_.dt[lane] = dt_;
        batch_.taken[lane] = 0.0;
        batch_.steps[lane] = steps_;
        particle_[lane] = particle;
    }

    /// Takes one step with all, and lets those that have arrived or ended leave.
    void step() {
        if constexpr (smooth)
            share_time_steps();
        kernel_(pair_, batch_, particles_.tangents());
        const Rk4Batch::Bits all = (Rk4Batch::Bits{1} << batch_.count) - 1u;
        Rk4Batch::Bits present = all & ~note_missing(field_, batch_);
        Rk4Batch::Bits alone = present & (batch_.slow | (gaps() ? present : batch_.outside));
        for (Rk4Batch::Bits some = alone & ~batch_.slow; some != 0; some &= some - 1u) {
            const Rk4Batch::Bits bit = some & -some;
            if (inside(first_of(some)))
                alone &= ~bit;
            if (take_missed(field_))
                present &= ~bit;
        }
        alone &= present;
        // Those that miss something leave as they came, and go again once it is there.
        ended_ = all & ~present;
        Rk4Batch::Bits leaving = present & batch_.last;
        if (alone == 0) {
            go_on();
        } else {
            for (std::size_t lane = 0; lane < batch_.count; ++lane)
                if ((alone >> lane & 1u) == 0)
                    go_on(lane);
                else if (!step_alone(lane))
                    leaving &= ~(Rk4Batch::Bits{1} << lane);
        }
        for (Rk4Batch::Bits some = leaving; some != 0; some &= some - 1u)
            arrive(first_of(some));
        leaving |= std::exchange(ended_, Rk4Batch::Bits{0});
        while (leaving != 0) { // the last first: none that moves has still to leave
            const auto lane = static_cast<std::size_t>(std::bit_width(leaving)) - 1;
            leaving &= ~(Rk4Batch::Bits{1} << lane);
            leave(lane);
        }
    }

  private:
    static constexpr bool smooth = std::is_same_v<Field, CubicSampler>;

    static std::size_t first_of(Rk4Batch::Bits lanes) {
        return static_cast<std::size_t>(std::countr_zero(lanes));
    }

    bool gaps() const {
        if constexpr (smooth)
            return false;
        else
            return field_.gaps;
    }

    bool inside(std::size_t lane) const {
        return field_.status({batch_.next[0][lane], batch_.next[1][lane], batch_.next[2][lane]}) ==
               PointStatus::Inside;
    }

    /// Most lanes are at the same time.
    void share_time_steps() requires smooth {
        for (std::size_t lane = 0; lane < batch_.count; ++lane) {
            const double time = batch_.start[lane] + batch_.taken[lane] * batch_.dt[lane];
            const double dt = batch_.dt[lane];
            if (time != shared_time_ || dt != shared_dt_) {
                shared_time_ = time;
                shared_dt_ = dt;
                for (std::size_t at = 0; at < 3; ++at)
                    shares_[at] = field_.shares(time + 0.5 * static_cast<double>(at) * dt);
            }
            for (std::size_t at = 0; at < 3; ++at)
                for (std::size_t step = 0; step < 4; ++step)
                    batch_.share[at][step][lane] = static_cast<float>(shares_[at][step]);
        }
    }

    void put(std::size_t lane, const Carried& at) {
        double* tangent = batch_.tangent[lane];
        for (int axis = 0; axis < 3; ++axis) {
            batch_.position[axis][lane] = at.position[axis];
            tangent[axis] = at.along_s[axis];
            tangent[4 + axis] = at.along_t[axis];
        }
        tangent[3] = at.expansion;
        tangent[7] = 0.0;
    }

    ParticleState state(std::size_t lane) const {
        const auto& p = batch_.position;
        const double* w = batch_.tangent[lane];
        return {
            {{p[0][lane], p[1][lane], p[2][lane]}, {w[0], w[1], w[2]}, {w[4], w[5], w[6]}, w[3]},
            batch_.start[lane] + batch_.taken[lane] * batch_.dt[lane],
            CurveEnd::Running};
    }

    void go_on() {
        std::copy_n(&batch_.next[0][0], 3 * Rk4Batch::most, &batch_.position[0][0]);
        if (particles_.tangents())
            std::copy_n(&batch_.next_tangent[0][0], 8 * batch_.count, &batch_.tangent[0][0]);
        for (double& taken : batch_.taken)
            taken += 1.0;
    }

    void go_on(std::size_t lane) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            batch_.position[axis][lane] = batch_.next[axis][lane];
        if (particles_.tangents())
            std::copy_n(batch_.next_tangent[lane], 8, batch_.tangent[lane]);
        batch_.taken[lane] += 1.0;
    }

    /// The step in double, which finds where the particle ends. False: it has, and is back among the others,
    /// or has to wait.
    bool step_alone(std::size_t lane) {
        ParticleState at = state(lane);
        rk4_particle_step(field_, at, batch_.dt[lane], options_, particles_.tangents());
        if (take_missed(field_)) {
            ended_ |= Rk4Batch::Bits{1} << lane;
            return false;
        }
        if (at.end != CurveEnd::Running) {
            put_back(particles_, particle_[lane], at);
            ended_ |= Rk4Batch::Bits{1} << lane;
            return false;
        }
        put(lane, at.carried);
        batch_.taken[lane] += 1.0;
        return true;
    }

    void arrive(std::size_t lane) {
        ParticleState at = state(lane);
        at.time = to_;
        put_back(particles_, particle_[lane], at);
    }

    /// Moves the last lane here.
    void leave(std::size_t lane) {
        const std::size_t last = --batch_.count;
        if (lane == last)
            return;
        for (auto& along_axis : batch_.position)
            along_axis[lane] = along_axis[last];
        std::copy_n(batch_.tangent[last], 8, batch_.tangent[lane]);
        batch_.start[lane] = batch_.start[last];
        batch_.dt[lane] = batch_.dt[last];
        batch_.taken[lane] = batch_.taken[last];
        batch_.steps[lane] = batch_.steps[last];
        particle_[lane] = particle_[last];
    }

    const Field& field_;
    const StoredPair& pair_;
    Rk4Kernel kernel_;
    const Particles& particles_;
    double to_;
    const AdvanceOptions& options_;
    double whole_ = 0.0; ///< time the one enqueued last had to go, and its steps
    double steps_ = 1.0;
    double dt_ = 0.0;
    double shared_time_ = 0.0; ///< when the shares hold
    double shared_dt_ = 0.0;
    std::array<std::array<double, 4>, 3> shares_{};
    Rk4Batch::Bits ended_ = 0; ///< in this step, bits of lanes
    Rk4Batch batch_;
    std::array<std::size_t, Rk4Batch::most> particle_;
};

} // namespace wakesurf::core
