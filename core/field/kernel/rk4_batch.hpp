// What a batch kernel works on: a pair of time-steps and up to 16 particles, for one RK4 step each. Plain data, because
// one of the kernels is compiled for newer processors: an inline function of a shared header that it emitted could
// replace everybody's (one definition rule) and crash the older ones.
#pragma once

#include <cstddef>
#include <cstdint>

namespace wakesurf::core {

/// Which kernel carries particles through stored data. Both give the same bits.
enum class Simd : std::uint8_t {
    Best,     ///< what the processor offers
    Portable, ///< what every processor offers
};

/// Two time-steps of a uniform grid. Vectors have a fourth, idle component.
struct StoredPair {
    const float* velocity0;
    const float* velocity1;   ///< null: frozen at the first
    const std::uint8_t* cell; ///< CellMask, by lowest node; null: no obstacle
    double time0;
    double per_interval; ///< 1 / time between the two
    alignas(32) double origin[4];
    alignas(32) double per_spacing[4];
    alignas(32) double last[4];      ///< index of the last node on each axis
    alignas(32) double last_cell[4]; ///< of the last cell
    alignas(32) double low[4];       ///< the domain, as Box::contains compares
    alignas(32) double high[4];
    std::int64_t row;   ///< nodes between neighbours in y
    std::int64_t slice; ///< nodes between neighbours in z
    float stagnation2;  ///< a slower particle (speed squared) may stand still
};

/// Particles that take a step together, stage by stage: while one waits for its samples another computes (one at
/// a time is 1.5-1.8 times slower: docs/measurements.md, The limit of the kernel).
struct Rk4Batch {
    static constexpr std::size_t most = 16;

    std::size_t count = 0;

    // A particle between steps, in double so that accuracy does not drift.
    alignas(32) double position[most][4];
    alignas(32) double tangent[most][8]; ///< along_s and along_t, four each
    double start[most];                  ///< time at its first step
    double dt[most];
    double taken[most]; ///< steps

    // What the kernel says.
    alignas(32) double next[most][4];
    alignas(32) double next_tangent[most][8];
    bool slow[most];    ///< may stand still
    bool outside[most]; ///< next is outside the domain, or in a cell with a solid node

    // The kernel's own: what passes from stage to stage.
    alignas(32) double cell_position[most][4]; ///< position in cells
    alignas(32) float fraction[most][4];       ///< in the cell
    alignas(32) float scale[most][4];          ///< velocity to cells a step
    alignas(32) float increment[most][4];      ///< from `position` to the stage, in cells
    alignas(32) float sum[most][4];            ///< of the stages' velocities
    alignas(32) float tangent0[most][8];
    alignas(32) float tangent_increment[most][8];
    alignas(32) float tangent_sum[most][8];
    float step[most];       ///< dt
    float earlier[3][most]; ///< share of the first time-step at the start, middle and end
    float later[3][most];   ///< share of the second
    std::int64_t node[most];
};

/// One step of every particle: fills next, slow and outside.
using Rk4Kernel = void (*)(const StoredPair&, Rk4Batch&, bool tangents);

void rk4_portable(const StoredPair& field, Rk4Batch& batch, bool tangents);

/// For x86-64-v3. REQUIRES: avx2_compiled() and a processor that has it.
void rk4_avx2(const StoredPair& field, Rk4Batch& batch, bool tangents);

bool avx2_compiled();

} // namespace wakesurf::core
