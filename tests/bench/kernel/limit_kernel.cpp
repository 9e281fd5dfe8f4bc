#include "tests/bench/kernel/limit_kernel.hpp"

#include <immintrin.h>

#include <algorithm>

namespace wakesurf::bench {

bool limit_kernel_runs_here() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

namespace {

/// Stage by stage over as many particles as keep the loads of one in flight while another computes: 26 instead of
/// 18 million vertex-steps/s (docs/measurements.md, The limit of the kernel).
constexpr std::size_t batch = 8;

struct Constants {
    const float* first;
    const float* second;
    std::ptrdiff_t y, z; ///< floats from a node to the next
    __m128 highest;      ///< last node of each axis
    __m128i last_cell;
    __m128 to_cells; ///< from velocity to cells a time unit
};

/// Places to sample at: floats from the field's start to the cell's lowest node, and the fractions.
struct Located {
    alignas(16) float fraction[batch][4];
    std::ptrdiff_t offset[batch];
};

[[gnu::target("avx2,fma"), gnu::always_inline]] inline void
locate(const Constants& c, const __m128* at, Located& out) {
    for (std::size_t i = 0; i < batch; ++i) {
        const __m128 p = _mm_min_ps(_mm_max_ps(at[i], _mm_setzero_ps()), c.highest);
        const __m128i cell = _mm_min_epi32(_mm_cvttps_epi32(p), c.last_cell);
        _mm_store_ps(out.fraction[i], _mm_sub_ps(p, _mm_cvtepi32_ps(cell)));
        out.offset[i] = 3 * std::ptrdiff_t{_mm_cvtsi128_si32(cell)} +
                        c.y * _mm_extract_epi32(cell, 1) + c.z * _mm_extract_epi32(cell, 2);
    }
}

/// Two neighbouring nodes of a row, six floats, blended in time.
[[gnu::target("avx2,fma"), gnu::always_inline]] inline __m256
row(const Constants& c, std::ptrdiff_t offset, __m256 early, __m256 late) {
    return _mm256_fmadd_ps(late, _mm256_loadu_ps(c.second + offset),
                           _mm256_mul_ps(early, _mm256_loadu_ps(c.first + offset)));
}

[[gnu::target("avx2,fma"), gnu::always_inline]] inline __m256
between(__m256 a, __m256 b, __m256 part) {
    return _mm256_fmadd_ps(part, _mm256_sub_ps(b, a), a);
}

/// Displacements in cells of `time` at the places `at`; `late` is the weight of the second time-step.
[[gnu::target("avx2,fma"), gnu::always_inline]] inline void
slopes(const Constants& c, const __m128* at, float late, __m128* out) {
    Located located;
    locate(c, at, located);
    const __m256 w1 = _mm256_set1_ps(late);
    const __m256 w0 = _mm256_set1_ps(1.0f - late);
    const __m256i second_node_up = _mm256_setr_epi32(0, 1, 2, 2, 3, 4, 5, 5);
    for (std::size_t i = 0; i < batch; ++i) {
        const std::ptrdiff_t o = located.offset[i];
        const __m256 fy = _mm256_broadcast_ss(&located.fraction[i][1]);
        const __m256 fz = _mm256_broadcast_ss(&located.fraction[i][2]);
        const __m256 low = between(row(c, o, w0, w1), row(c, o + c.y, w0, w1), fy);
        const __m256 high = between(row(c, o + c.z, w0, w1), row(c, o + c.y + c.z, w0, w1), fy);
        const __m256 pair = _mm256_permutevar8x32_ps(between(low, high, fz), second_node_up);
        const __m128 a = _mm256_castps256_ps128(pair);
        const __m128 b = _mm256_extractf128_ps(pair, 1);
        const __m128 fx = _mm_broadcast_ss(&located.fraction[i][0]);
        out[i] = _mm_mul_ps(c.to_cells, _mm_fmadd_ps(fx, _mm_sub_ps(b, a), a));
    }
}

[[gnu::target("avx2,fma"), gnu::always_inline]] inline void
ahead(const __m128* from, const __m128* slope, float dt, __m128* out) {
    for (std::size_t i = 0; i < batch; ++i)
        out[i] = _mm_fmadd_ps(_mm_set1_ps(dt), slope[i], from[i]);
}

[[gnu::target("avx2,fma")]] void
carry(const Constants& c, CellPosition* particles, float interval, int steps) {
    __m128 at[batch], probe[batch], k1[batch], k2[batch], k3[batch], k4[batch];
    for (std::size_t i = 0; i < batch; ++i)
        at[i] = _mm_load_ps(&particles[i].x);
    const float part = 1.0f / static_cast<float>(steps);
    const float dt = interval * part;
    for (int step = 0; step < steps; ++step) {
        const float late = static_cast<float>(step) * part;
        slopes(c, at, late, k1);
        ahead(at, k1, 0.5f * dt, probe);
        slopes(c, probe, late + 0.5f * part, k2);
        ahead(at, k2, 0.5f * dt, probe);
        slopes(c, probe, late + 0.5f * part, k3);
        ahead(at, k3, dt, probe);
        slopes(c, probe, late + part, k4);
        for (std::size_t i = 0; i < batch; ++i) {
            const __m128 inner = _mm_add_ps(k2[i], k3[i]);
            const __m128 sum = _mm_add_ps(_mm_add_ps(k1[i], k4[i]), _mm_add_ps(inner, inner));
            at[i] = _mm_fmadd_ps(_mm_set1_ps(dt / 6.0f), sum, at[i]);
        }
    }
    for (std::size_t i = 0; i < batch; ++i)
        _mm_store_ps(&particles[i].x, at[i]);
}

} // namespace

[[gnu::target("avx2,fma")]] void advance_at_the_limit(const LimitField& field,
                                                      std::span<CellPosition> particles,
                                                      double interval,
                                                      int steps) {
    const auto [nx, ny, nz] = field.grid.dimensions;
    const auto cells = [](std::uint32_t nodes) { return static_cast<int>(nodes) - 1; };
    const auto per_cell = [&](int axis) {
        return static_cast<float>(1.0 / field.grid.spacing[axis]);
    };
    Constants c;
    c.first = field.first;
    c.second = field.second;
    c.y = std::ptrdiff_t{3} * nx;
    c.z = c.y * ny;
    c.last_cell = _mm_setr_epi32(cells(nx) - 1, cells(ny) - 1, cells(nz) - 1, 0);
    c.highest = _mm_setr_ps(static_cast<float>(cells(nx)), static_cast<float>(cells(ny)),
                            static_cast<float>(cells(nz)), 0.0f);
    c.to_cells = _mm_setr_ps(per_cell(0), per_cell(1), per_cell(2), 0.0f);
    const std::size_t whole = particles.size() / batch * batch;
    for (std::size_t i = 0; i < whole; i += batch)
        carry(c, &particles[i], static_cast<float>(interval), steps);
    if (whole < particles.size()) {
        CellPosition rest[batch] = {};
        std::copy(particles.begin() + static_cast<std::ptrdiff_t>(whole), particles.end(), rest);
        carry(c, rest, static_cast<float>(interval), steps);
        std::copy_n(rest, particles.size() - whole,
                    particles.begin() + static_cast<std::ptrdiff_t>(whole));
    }
}

} // namespace wakesurf::bench
