#include "core/field/kernel/series_kernel.hpp"

#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace wakesurf::core {

namespace {

using TwoDoubles = double __attribute__((vector_size(16)));
using TwoIntegers = std::int64_t __attribute__((vector_size(16)));

struct PortableLanes : VectorLanes<TwoDoubles, TwoIntegers, 2> {
    static Number root(Number of) {
        return Number::make([&](std::size_t i) -> TwoDoubles {
#if defined(__SSE2__)
            return _mm_sqrt_pd(of.part[i]);
#else
            return {std::sqrt(of.part[i][0]), std::sqrt(of.part[i][1])};
#endif
        });
    }
};

} // namespace

const SeriesKernel series_portable{
    [](SeriesBatch& batch) { SeriesOfFour<PortableLanes>(batch).expand(); },
    [](SeriesBatch& batch) { SeriesOfFour<PortableLanes>(batch).step(); }};

const SeriesKernel& series_kernel(Simd simd) {
#if defined(__x86_64__)
    if (const SeriesKernel* avx2 = series_avx2();
        simd != Simd::Portable && avx2 != nullptr && __builtin_cpu_supports("avx2") != 0)
        return *avx2;
#endif
    return series_portable;
}

} // namespace wakesurf::core
