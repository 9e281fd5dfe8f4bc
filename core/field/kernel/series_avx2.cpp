// The kernel of Taylor series on AVX2 vectors. Compiled for processors that have them: it includes nothing
// that has functions.
#include "core/field/kernel/series_kernel.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace wakesurf::core {

#if defined(__AVX2__)

namespace {

using FourDoubles = double __attribute__((vector_size(32)));
using FourIntegers = std::int64_t __attribute__((vector_size(32)));

struct Avx2Series : VectorLanes<FourDoubles, FourIntegers, 1> {
    static Number root(Number of) { return {{_mm256_sqrt_pd(of.part[0])}}; }

    static Number select(Mask where, Number a, Number b) {
        return {{_mm256_blendv_pd(b.part[0], a.part[0], FourDoubles(where.part[0]))}};
    }

    static std::uint32_t bits(Mask mask) {
        return static_cast<std::uint32_t>(_mm256_movemask_pd(FourDoubles(mask.part[0])));
    }
};

constexpr SeriesKernel kernel{[](SeriesBatch& batch) { SeriesOfFour<Avx2Series>(batch).expand(); },
                              [](SeriesBatch& batch) { SeriesOfFour<Avx2Series>(batch).step(); }};

} // namespace

const SeriesKernel* series_avx2() {
    return &kernel;
}

#else

const SeriesKernel* series_avx2() {
    return nullptr;
}

#endif

} // namespace wakesurf::core
