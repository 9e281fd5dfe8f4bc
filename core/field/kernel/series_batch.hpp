// Four particles that go through cells by Taylor series at the same time: while the terms of one wait for each
// other, those of the others are computed. Each gets the bits that it would get alone.
#pragma once

#include "core/field/kernel/simd.hpp"

#include <cstddef>
#include <cstdint>

namespace wakesurf::core {

/// The lanes of a batch; what a kernel makes of a lane depends on no other.
struct SeriesBatch {
    static constexpr std::size_t lanes = 4;

    using Numbers = double[lanes];

    // What expand() reads.
    alignas(32)
        Numbers now[8][3]; ///< coefficients of the cell's velocity, as TrilinearPolynomial has them
    alignas(32) Numbers change[8][3]; ///< and by how much they change until the second time-step
    alignas(32) Numbers part;         ///< of the time between the two
    alignas(32) Numbers rate;         ///< of this part
    alignas(32) Numbers place[3];     ///< in the cell
    alignas(32) Numbers size[3];      ///< of the cell
    bool unsteady = false;            ///< `change` counts

    // What it writes.
    alignas(32) Numbers term[6][3]; ///< of the path
    alignas(32) Numbers speed;
    alignas(32) Numbers exit_time; ///< as leaves_cell() finds it
    alignas(32) Numbers exit_axis;
    alignas(32) Numbers exit_step;

    // What step() reads beside these.
    alignas(32) Numbers time;    ///< of the step
    alignas(32) Numbers least;   ///< a step this short may err by more than is allowed
    alignas(32) Numbers allowed; ///< error
    alignas(32) Numbers low[3];  ///< corner of the cell
    alignas(32) Numbers arc;     ///< length until the step

    // What it writes.
    alignas(32) Numbers output[5][4]; ///< CurveStep::c
    alignas(32) Numbers error;        ///< at the step's end
    std::uint32_t shorter =
        0; ///< bits of the lanes whose step has to be shorter: they have none yet
};

/// Computes of every lane what TrilinearCell::series(), leaves_cell() and series_step() do.
struct SeriesKernel {
    void (*expand)(SeriesBatch&);
    void (*step)(SeriesBatch&);
};

/// Returns the kernel for this processor. All of them give the same bits.
const SeriesKernel& series_kernel(Simd simd = Simd::Best);

/// The kernel for every processor.
extern const SeriesKernel series_portable;

/// The kernel compiled with AVX2, without FMA, which rounds otherwise: null if it is not.
const SeriesKernel* series_avx2();

} // namespace wakesurf::core
