#include "core/field/advance_stored.hpp"

#include "core/field/refill_batch.hpp"
#include "core/field/stored_pair.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace wakesurf::core {

namespace {

/// Velocities of up to a batch of particles at one time, by the kernel that carries them: in float, and the
/// same bits on arrival as later. It keeps references. @tparam Field  as of RefillBatch
template <class Field>
class VelocityProbe {
  public:
    VelocityProbe(const Field& field, const StoredPair& pair, Rk4Kernel kernel, double time)
        : pair_(stored_pair_at(field, pair, time)), kernel_(kernel), time_(time) {
        if constexpr (std::is_same_v<Field, CubicSampler>) {
            const auto shares = field.shares(time);
            for (auto& at : share_)
                std::transform(shares.begin(), shares.end(), at.begin(),
                               [](double share) { return static_cast<float>(share); });
        }
    }

    /// Fills batch.velocity where the particles are. Overwrites their start and taken steps.
    void operator()(Rk4Batch& batch) const {
        std::fill_n(batch.start, Rk4Batch::most, time_);
        std::fill_n(batch.taken, Rk4Batch::most, 0.0);
        batch.straight = 1;
        if constexpr (std::is_same_v<Field, CubicSampler>)
            batch.share_of_steps = &share_[0][0];
        batch.velocity_only = true;
        kernel_(pair_, batch, false);
        batch.velocity_only = false;
    }

    static Vec3f of(const Rk4Batch& batch, std::size_t lane) {
        const float* v = batch.velocity[lane];
        return {v[0], v[1], v[2]};
    }

  private:
    StoredPair pair_;
    Rk4Kernel kernel_;
    double time_;
    std::array<std::array<float, 4>, 3> share_{};
};

/// Carries particles that start at the same time for as many steps, all of a surface's, in lockstep: the
/// kernel takes all the steps of a batch of them. A particle that was slow or outside meanwhile may have
/// ended there, and is repeated from its start by a RefillBatch, with the same bits.
/// @tparam Field  as of RefillBatch
template <class Field>
class LockstepBatch {
  public:
    LockstepBatch(const Field& field,
                  const StoredPair& pair,
                  Rk4Kernel kernel,
                  const Particles& particles,
                  double to,
                  const AdvanceOptions& options)
        : field_(field), pair_(pair), kernel_(kernel), particles_(particles), to_(to),
          options_(options), probe_(field, pair, kernel, to) {}

    bool full() const { return batch_.count == at_once; }

    bool empty() const { return batch_.count == 0; }

    /// Returns false if the particle is at another time than those that wait here, or would have to be done
    /// again as most of those before.
    bool try_enqueue(std::size_t particle) {
        if (alone_ > 0) {
            --alone_;
            return false;
        }
        const double time = particles_.time[particle];
        if (empty() && time != start_)
            begin_at(time);
        if (time != start_)
            return false;
        const std::size_t lane = batch_.count++;
        particle_[lane] = particle;
        for (int axis = 0; axis < 3; ++axis)
            batch_.position[axis][lane] = particles_.position[particle][axis];
        if (particles_.tangents())
            for (int axis = 0; axis < 3; ++axis) {
                batch_.tangent[lane][axis] = particles_.along_s[particle][axis];
                batch_.tangent[lane][4 + axis] = particles_.along_t[particle][axis];
            }
        batch_.tangent[lane][3] =
            particles_.expansion.empty() ? 0.0 : double(particles_.expansion[particle]);
        return true;
    }

    /// Carries those that wait to where all go. Calls `redo(particle)` for those that are still where they
    /// were.
    template <class Redo>
    void run(const Redo& redo) {
        Rk4Batch::Bits ended = 0, waiting = 0;
        std::fill_n(batch_.taken, Rk4Batch::most, 0.0);
        for (double left = steps_; left > 0.0 && std::popcount(ended) < count();
             left -= static_cast<double>(most_steps)) {
            batch_.straight = static_cast<std::size_t>(std::min(left, double{most_steps}));
            if constexpr (smooth)
                share_time_steps();
            kernel_(pair_, batch_, particles_.tangents());
            waiting |= note_missing(field_, batch_);
            ended |= (batch_.slow | batch_.outside | waiting) &
                     ((Rk4Batch::Bits{1} << batch_.count) - 1u);
        }
        for (std::size_t lane = 0; lane < batch_.count; ++lane)
            if ((ended >> lane & 1u) == 0)
                arrive(lane);
            else if ((waiting >> lane & 1u) == 0)
                redo(particle_[lane]);
        if (!particles_.velocity.empty())
            measure_velocities(ended);
        if (2 * std::popcount(ended & ~waiting) > count()) // along a wall, say
            alone_ = Rk4Batch::most;
        batch_.count = 0;
    }

  private:
    static constexpr bool smooth = std::is_same_v<Field, CubicSampler>;

    /// The nodes round more particles than these leave the cache between stages.
    static constexpr std::size_t at_once = smooth ? 16 : Rk4Batch::most;

    static constexpr std::uint32_t most_steps = 64; ///< at once

    int count() const { return static_cast<int>(batch_.count); }

    void begin_at(double time) {
        start_ = time;
        const double whole = to_ - time;
        steps_ = rk4_steps(whole, options_);
        std::fill_n(batch_.start, Rk4Batch::most, time);
        std::fill_n(batch_.dt, Rk4Batch::most, whole / steps_);
        shared_from_ = -1.0;
    }

    /// Prepares the steps that come next, unless the last ones had the same time-steps.
    void share_time_steps() {
        batch_.share_of_steps = &share_[0][0][0];
        if (shared_from_ == batch_.taken[0])
            return;
        shared_from_ = batch_.taken[0];
        const double dt = batch_.dt[0];
        for (std::size_t i = 0; i < batch_.straight; ++i) {
            const double time = start_ + (shared_from_ + static_cast<double>(i)) * dt;
            for (std::size_t at = 0; at < 3; ++at) {
                const auto shares = field_.shares(time + 0.5 * static_cast<double>(at) * dt);
                for (std::size_t step = 0; step < 4; ++step)
                    share_[i][at][step] = static_cast<float>(shares[step]);
            }
        }
    }

    /// While what they were carried through is still in the cache.
    void measure_velocities(Rk4Batch::Bits ended) {
        probe_(batch_);
        ended |= note_missing(field_, batch_); // is looked up later
        for (std::size_t lane = 0; lane < batch_.count; ++lane)
            if ((ended >> lane & 1u) == 0) {
                particles_.velocity[particle_[lane]] = VelocityProbe<Field>::of(batch_, lane);
                particles_.sampled[particle_[lane]] = 1;
            }
        std::fill_n(batch_.start, Rk4Batch::most, start_);
    }

    void arrive(std::size_t lane) {
        const auto& p = batch_.position;
        const double* w = batch_.tangent[lane];
        put_back(
            particles_, particle_[lane],
            {{{p[0][lane], p[1][lane], p[2][lane]}, {w[0], w[1], w[2]}, {w[4], w[5], w[6]}, w[3]},
             to_,
             CurveEnd::Running});
    }

    const Field& field_;
    const StoredPair& pair_;
    Rk4Kernel kernel_;
    const Particles& particles_;
    double to_;
    const AdvanceOptions& options_;
    VelocityProbe<Field> probe_;
    double start_ = std::numeric_limits<double>::quiet_NaN(); ///< of those that wait
    double steps_ = 1.0;
    double shared_from_ = -1.0; ///< the step that share_ begins with
    std::array<std::array<std::array<float, 4>, 3>, most_steps> share_;
    std::size_t alone_ = 0; ///< particles that still go alone
    Rk4Batch batch_;
    std::array<std::size_t, Rk4Batch::most> particle_;
};

template <class Field>
bool advance_in_batches(const Field& field,
                        Rk4Kernel kernel,
                        const Particles& particles,
                        double to,
                        int sign,
                        const AdvanceOptions& options,
                        const std::stop_token& stop) {
    const bool straight = !field.gaps; // with them every step is computed alone
    const auto advance_range = [&](const Field& view, std::size_t begin, std::size_t end) {
        const StoredPair pair = stored_pair(view, options);
        RefillBatch<Field> refilled(view, pair, kernel, particles, to, options);
        LockstepBatch<Field> lockstep(view, pair, kernel, particles, to, options);
        const auto enqueue = [&](std::size_t particle) {
            while (refilled.full())
                refilled.step();
            refilled.enqueue(particle);
        };
        for (; begin != end; ++begin) {
            if (!still_to_go(particles, begin, to, sign))
                continue;
            if (!straight || !lockstep.try_enqueue(begin))
                enqueue(begin);
            if (lockstep.full())
                lockstep.run(enqueue);
        }
        if (!lockstep.empty())
            lockstep.run(enqueue);
        while (!refilled.empty())
            refilled.step();
    };
    return in_blocks(field, particles.count(), stop, advance_range, 16,
                     MissingBricks::Again::Restart, ahead_of(particles, sign));
}

template <class Field>
bool sample_in_batches(const Field& field,
                       Rk4Kernel kernel,
                       std::span<const Vec3> positions,
                       double time,
                       std::span<Vec3f> velocities,
                       const std::stop_token& stop) {
    const auto sample_range = [&](const Field& view, std::size_t begin, std::size_t end) {
        const StoredPair pair = stored_pair(view, {});
        const VelocityProbe<Field> find_velocities(view, pair, kernel, time);
        Rk4Batch batch;
        for (; begin != end; begin += batch.count) {
            batch.count = std::min(end - begin, Rk4Batch::most);
            for (std::size_t lane = 0; lane < batch.count; ++lane)
                for (int axis = 0; axis < 3; ++axis)
                    batch.position[axis][lane] = positions[begin + lane][axis];
            find_velocities(batch);
            note_missing(view, batch);
            for (std::size_t lane = 0; lane < batch.count; ++lane)
                velocities[begin + lane] = find_velocities.of(batch, lane);
        }
    };
    return in_blocks(field, positions.size(), stop, sample_range, 1024, MissingBricks::Again::Redo);
}

bool processor_has_avx2() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

/// All that the kernel is compiled for (core/CMakeLists.txt).
bool processor_has_avx512() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512vl") != 0;
#else
    return false;
#endif
}

} // namespace

Rk4Kernel choose_rk4_kernel(Simd simd) {
    if (simd == Simd::Best && avx512_compiled() && processor_has_avx512())
        return rk4_avx512;
    if (simd != Simd::Portable && avx2_compiled() && processor_has_avx2())
        return rk4_avx2;
    return rk4_portable;
}

bool advance_stored(const GridSampler<UniformGrid>& field,
                    Rk4Kernel kernel,
                    const Particles& particles,
                    double to,
                    int sign,
                    const AdvanceOptions& options,
                    const std::stop_token& stop) {
    return advance_in_batches(field, kernel, particles, to, sign, options, stop);
}

bool advance_stored(const GridSampler<RectilinearAxes>& field,
                    Rk4Kernel kernel,
                    const Particles& particles,
                    double to,
                    int sign,
                    const AdvanceOptions& options,
                    const std::stop_token& stop) {
    return advance_in_batches(field, kernel, particles, to, sign, options, stop);
}

bool kernel_samples(const CubicSampler& field) {
    const auto& dimensions = field.linear.grid->dimensions;
    return !field.gaps && *std::min_element(dimensions.begin(), dimensions.end()) >= 4 &&
           (field.linear.mask->empty() || field.round_cells != nullptr);
}

bool advance_stored(const CubicSampler& field,
                    Rk4Kernel kernel,
                    const Particles& particles,
                    double to,
                    int sign,
                    const AdvanceOptions& options,
                    const std::stop_token& stop) {
    return advance_in_batches(field, kernel, particles, to, sign, options, stop);
}

bool sample_stored(const GridSampler<UniformGrid>& field,
                   Rk4Kernel kernel,
                   std::span<const Vec3> positions,
                   double time,
                   std::span<Vec3f> velocities,
                   const std::stop_token& stop) {
    return sample_in_batches(field, kernel, positions, time, velocities, stop);
}

bool sample_stored(const GridSampler<RectilinearAxes>& field,
                   Rk4Kernel kernel,
                   std::span<const Vec3> positions,
                   double time,
                   std::span<Vec3f> velocities,
                   const std::stop_token& stop) {
    return sample_in_batches(field, kernel, positions, time, velocities, stop);
}

bool sample_stored(const CubicSampler& field,
                   Rk4Kernel kernel,
                   std::span<const Vec3> positions,
                   double time,
                   std::span<Vec3f> velocities,
                   const std::stop_token& stop) {
    return sample_in_batches(field, kernel, positions, time, velocities, stop);
}

} // namespace wakesurf::core
