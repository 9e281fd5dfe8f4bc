#include "core/field/advance_stored.hpp"

#include "core/field/convoy.hpp"
#include "core/field/passage.hpp"
#include "core/field/stored_pair.hpp"
#include "core/field/velocity_look.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

template <class Field>
bool advance_in_batches(const Field& field,
                        Rk4Kernel kernel,
                        const Particles& particles,
                        double to,
                        int sign,
                        const AdvanceOptions& options,
                        const std::stop_token& stop) {
    const bool straight = !field.gaps; // with them every step is computed alone
    const auto some = [&](const Field& view, std::size_t begin, std::size_t end) {
        const StoredPair pair = stored_pair(view, options);
        Passage<Field> passage(view, pair, kernel, particles, to, options);
        Convoy<Field> convoy(view, pair, kernel, particles, to, options);
        const auto board = [&](std::size_t particle) {
            while (passage.full())
                passage.step();
            passage.board(particle);
        };
        for (; begin != end; ++begin) {
            if (!still_to_go(particles, begin, to, sign))
                continue;
            if (!straight || !convoy.join(begin))
                board(begin);
            if (convoy.full())
                convoy.go(board);
        }
        if (!convoy.empty())
            convoy.go(board);
        while (!passage.empty())
            passage.step();
    };
    return in_blocks(field, particles.count(), stop, some, 16, MissingBricks::Again::Restart,
                     ahead_of(particles, sign));
}

template <class Field>
bool sample_in_batches(const Field& field,
                       Rk4Kernel kernel,
                       std::span<const Vec3> positions,
                       double time,
                       std::span<Vec3f> velocities,
                       const std::stop_token& stop) {
    const auto some = [&](const Field& view, std::size_t begin, std::size_t end) {
        const StoredPair pair = stored_pair(view, {});
        const VelocityLook<Field> find_velocities(view, pair, kernel, time);
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
    return in_blocks(field, positions.size(), stop, some, 1024, MissingBricks::Again::Redo);
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
