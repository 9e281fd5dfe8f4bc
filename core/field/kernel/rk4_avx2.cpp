// The batch kernel on AVX2 vectors. The only file compiled for x86-64-v3: it includes nothing that has functions.
#include "core/field/kernel/rk4_kernel.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace wakesurf::core {

#if defined(__AVX2__)

namespace {

struct Avx2Lanes {
    struct Wide;

    struct Quad {
        __m128 v;

        static Quad load(const float* from) { return {_mm_loadu_ps(from)}; }

        static Quad all(float value) { return {_mm_set1_ps(value)}; }

        void store(float* to) const { _mm_storeu_ps(to, v); }

        float sum3() const {
            const __m128 xy = _mm_add_ss(v, _mm_movehdup_ps(v));
            return _mm_cvtss_f32(_mm_add_ss(xy, _mm_movehl_ps(v, v)));
        }

        Wide widen() const;

        friend Quad operator+(Quad a, Quad b) { return {_mm_add_ps(a.v, b.v)}; }

        friend Quad operator-(Quad a, Quad b) { return {_mm_sub_ps(a.v, b.v)}; }

        friend Quad operator*(Quad a, Quad b) { return {_mm_mul_ps(a.v, b.v)}; }
    };

    struct Row {
        __m256 v;

        static Row load(const float* from) { return {_mm256_loadu_ps(from)}; }

        static Row all(float value) { return {_mm256_set1_ps(value)}; }

        static Row twice(Quad q) { return {_mm256_set_m128(q.v, q.v)}; }

        void store(float* to) const { _mm256_storeu_ps(to, v); }

        Quad first() const { return {_mm256_castps256_ps128(v)}; }

        Quad second() const {
            const __m128i low = _mm_castps_si128(_mm256_castps256_ps128(v));
            const __m128i high = _mm_castps_si128(_mm256_extractf128_ps(v, 1));
            return {_mm_castsi128_ps(_mm_alignr_epi8(high, low, 12))};
        }

        template <std::size_t I>
        Row each() const {
            return {_mm256_permute_ps(v, static_cast<int>(I * 0x55))};
        }

        friend Row operator+(Row a, Row b) { return {_mm256_add_ps(a.v, b.v)}; }

        friend Row operator-(Row a, Row b) { return {_mm256_sub_ps(a.v, b.v)}; }

        friend Row operator*(Row a, Row b) { return {_mm256_mul_ps(a.v, b.v)}; }
    };

    struct Wide {
        __m256d v;

        static Wide load(const double* from) { return {_mm256_loadu_pd(from)}; }

        static Wide all(double value) { return {_mm256_set1_pd(value)}; }

        static Wide min(Wide a, Wide b) { return {_mm256_min_pd(a.v, b.v)}; }

        static Wide max(Wide a, Wide b) { return {_mm256_max_pd(a.v, b.v)}; }

        static bool between(Wide low, Wide x, Wide high) {
            const __m256d above = _mm256_cmp_pd(low.v, x.v, _CMP_LE_OQ);
            const __m256d below = _mm256_cmp_pd(x.v, high.v, _CMP_LE_OQ);
            return (_mm256_movemask_pd(_mm256_and_pd(above, below)) & 7) == 7;
        }

        void store(double* to) const { _mm256_storeu_pd(to, v); }

        Wide truncated(std::int64_t (&index)[3]) const {
            const __m128i cell = _mm256_cvttpd_epi32(v);
            const auto xy = static_cast<std::uint64_t>(_mm_cvtsi128_si64(cell));
            index[0] = static_cast<std::int64_t>(xy & 0xffffffffu);
            index[1] = static_cast<std::int64_t>(xy >> 32);
            index[2] = _mm_extract_epi32(cell, 2);
            return {_mm256_cvtepi32_pd(cell)};
        }

        Quad narrow() const { return {_mm256_cvtpd_ps(v)}; }

        friend Wide operator+(Wide a, Wide b) { return {_mm256_add_pd(a.v, b.v)}; }

        friend Wide operator-(Wide a, Wide b) { return {_mm256_sub_pd(a.v, b.v)}; }

        friend Wide operator*(Wide a, Wide b) { return {_mm256_mul_pd(a.v, b.v)}; }
    };

    static Row narrow(const double* from) {
        return {_mm256_set_m128(_mm256_cvtpd_ps(_mm256_loadu_pd(from + 4)),
                                _mm256_cvtpd_ps(_mm256_loadu_pd(from)))};
    }
};

inline Avx2Lanes::Wide Avx2Lanes::Quad::widen() const {
    return {_mm256_cvtps_pd(v)};
}

} // namespace

void rk4_avx2(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    rk4_step<Avx2Lanes>(field, batch, tangents);
}

bool avx2_compiled() {
    return true;
}

#else

void rk4_avx2(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    rk4_portable(field, batch, tangents);
}

bool avx2_compiled() {
    return false;
}

#endif

} // namespace wakesurf::core
