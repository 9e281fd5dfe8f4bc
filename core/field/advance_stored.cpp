#include "core/field/advance_stored.hpp"

#include "core/field/advance_particles.hpp"

#include <array>

namespace wakesurf::core {

namespace {

void fill(double (&to)[4], const Vec3& v, double idle = 0.0) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
    to[3] = idle;
}

StoredPair stored_pair(const GridSampler<UniformGrid>& field, const AdvanceOptions& options) {
    const UniformGrid& grid = *field.grid;
    StoredPair pair;
    pair.velocity0 = field.velocity0;
    pair.velocity1 = field.velocity1;
    pair.cell = field.cells->data();
    pair.time0 = field.time0;
    pair.per_interval = 1.0 / field.interval;
    const Vec3 last(grid.dimensions[0] - 1, grid.dimensions[1] - 1, grid.dimensions[2] - 1);
    const Box box = grid.bounds();
    fill(pair.origin, grid.origin);
    fill(pair.per_spacing, 1.0 / grid.spacing);
    fill(pair.last, last);
    fill(pair.last_cell, last - 1.0);
    fill(pair.low, box.lo);
    fill(pair.high, box.hi);
    pair.row = grid.dimensions[0];
    pair.slice = pair.row * grid.dimensions[1];
    // A little more than the limit: near it, the step in double decides.
    const double speed = 1.00001 * options.stagnation_speed;
    pair.stagnation2 = static_cast<float>(speed * speed);
    return pair;
}

/// Particles of one range in the lanes of a batch. A particle takes a lane, all its steps there, and leaves the lane to
/// the next: those that have more steps to go than others hold no one up.
class Passage {
  public:
    Passage(const GridSampler<UniformGrid>& field,
            const StoredPair& pair,
            Rk4Kernel kernel,
            const Particles& particles,
            double to,
            const AdvanceOptions& options)
        : field_(field), pair_(pair), kernel_(kernel), particles_(particles), to_(to),
          options_(options) {}

    bool full() const { return batch_.count == Rk4Batch::most; }

    bool empty() const { return batch_.count == 0; }

    void board(std::size_t particle) {
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
        lane_[lane] = {particle, steps_};
    }

    /// Takes one step with all, and lets those that have arrived or ended leave.
    void step() {
        kernel_(pair_, batch_, particles_.tangents());
        for (std::size_t lane = batch_.count; lane-- > 0;) {
            const bool doubtful = batch_.outside[lane] || field_.gaps;
            if (batch_.slow[lane] || (doubtful && !inside(batch_.next[lane]))) {
                if (!step_alone(lane))
                    leave(lane);
                continue;
            }
            std::copy_n(batch_.next[lane], 4, batch_.position[lane]);
            if (particles_.tangents())
                std::copy_n(batch_.next_tangent[lane], 8, batch_.tangent[lane]);
            count_step(lane);
        }
    }

  private:
    struct Lane {
        std::size_t particle;
        double steps;
    };

    bool inside(const double (&p)[4]) const {
        return field_.status({p[0], p[1], p[2]}) == PointStatus::Inside;
    }

    void put(std::size_t lane, const Carried& at) {
        fill(batch_.position[lane], at.position);
        double* tangent = batch_.tangent[lane];
        for (int axis = 0; axis < 3; ++axis) {
            tangent[axis] = at.along_s[axis];
            tangent[4 + axis] = at.along_t[axis];
        }
        tangent[3] = tangent[7] = 0.0;
    }

    ParticleState state(std::size_t lane) const {
        const double* p = batch_.position[lane];
        const double* w = batch_.tangent[lane];
        return {{{p[0], p[1], p[2]}, {w[0], w[1], w[2]}, {w[4], w[5], w[6]}},
                batch_.start[lane] + batch_.taken[lane] * batch_.dt[lane],
                CurveEnd::Running};
    }

    /// The step in double, which finds where the particle ends. False: it has, and is back among the others.
    bool step_alone(std::size_t lane) {
        ParticleState at = state(lane);
        rk4_particle_step(field_, at, batch_.dt[lane], options_, particles_.tangents());
        if (at.end != CurveEnd::Running) {
            put_back(particles_, lane_[lane].particle, at);
            return false;
        }
        put(lane, at.carried);
        count_step(lane);
        return true;
    }

    void count_step(std::size_t lane) {
        batch_.taken[lane] += 1.0;
        if (batch_.taken[lane] < lane_[lane].steps)
            return;
        ParticleState at = state(lane);
        at.time = to_;
        put_back(particles_, lane_[lane].particle, at);
        leave(lane);
    }

    /// Moves the last lane here.
    void leave(std::size_t lane) {
        const std::size_t last = --batch_.count;
        std::copy_n(batch_.position[last], 4, batch_.position[lane]);
        std::copy_n(batch_.tangent[last], 8, batch_.tangent[lane]);
        batch_.start[lane] = batch_.start[last];
        batch_.dt[lane] = batch_.dt[last];
        batch_.taken[lane] = batch_.taken[last];
        lane_[lane] = lane_[last];
    }

    const GridSampler<UniformGrid>& field_;
    const StoredPair& pair_;
    Rk4Kernel kernel_;
    const Particles& particles_;
    double to_;
    const AdvanceOptions& options_;
    double whole_ = 0.0; ///< time the last one aboard had to go, and its steps
    double steps_ = 1.0;
    double dt_ = 0.0;
    Rk4Batch batch_;
    std::array<Lane, Rk4Batch::most> lane_;
};

bool processor_has_avx2() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

} // namespace

Rk4Kernel choose_rk4_kernel(Simd simd) {
    return simd == Simd::Best && avx2_compiled() && processor_has_avx2() ? rk4_avx2 : rk4_portable;
}

bool advance_stored(const GridSampler<UniformGrid>& field,
                    Rk4Kernel kernel,
                    const Particles& particles,
                    double to,
                    int sign,
                    const AdvanceOptions& options,
                    const std::stop_token& stop) {
    const StoredPair pair = stored_pair(field, options);
    return in_ranges(particles.count(), stop, [&](std::size_t begin, std::size_t end) {
        Passage passage(field, pair, kernel, particles, to, options);
        while (begin != end || !passage.empty()) {
            for (; begin != end && !passage.full(); ++begin)
                if (still_to_go(particles, begin, to, sign))
                    passage.board(begin);
            if (!passage.empty())
                passage.step();
        }
    });
}

} // namespace wakesurf::core
