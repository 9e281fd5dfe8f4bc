// The batch kernel on AVX2 vectors. Compiled for processors that have them: it includes nothing that has
// functions.
#include "core/field/kernel/rk4_kernel.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace wakesurf::core {

#if defined(__AVX2__)

namespace {

struct Avx2Lanes {
    static constexpr std::size_t together = 1;

    struct Wide;

    struct Quad {
        static constexpr std::size_t size = 4;

        __m128 v;

        static Quad load(const float* from) { return {_mm_loadu_ps(from)}; }

        static Quad all(float value) { return {_mm_set1_ps(value)}; }

        void store(float* to) const { _mm_storeu_ps(to, v); }

        /// Returns the elements from `N` of this and the next one together.
        template <int N>
        Quad from(Quad next) const {
            return {_mm_castsi128_ps(
                _mm_alignr_epi8(_mm_castps_si128(next.v), _mm_castps_si128(v), 4 * N))};
        }

        Wide widen() const;

        friend Quad operator+(Quad a, Quad b) { return {_mm_add_ps(a.v, b.v)}; }

        friend Quad operator-(Quad a, Quad b) { return {_mm_sub_ps(a.v, b.v)}; }

        friend Quad operator*(Quad a, Quad b) { return {_mm_mul_ps(a.v, b.v)}; }
    };

    struct Floats {
        static constexpr std::size_t size = 8;

        __m256 v;

        static Floats load(const float* from) { return {_mm256_loadu_ps(from)}; }

        static Floats all(float value) { return {_mm256_set1_ps(value)}; }

        static Floats both(Quad low, Quad high) { return {_mm256_set_m128(high.v, low.v)}; }

        /// Loads a row for each particle.
        static Floats rows(const float* from, const std::int64_t* at) { return load(from + at[0]); }

        /// Spreads a particle's number over its row, and over its vectors in either half.
        static Floats each_of(const float* number) { return all(number[0]); }

        static Floats each_of_quads(const float* number) { return all(number[0]); }

        static Floats twice(Quad q) { return both(q, q); }

        static Floats twice_of(float x, float y, float z) {
            return {_mm256_setr_ps(x, y, z, 0.0f, x, y, z, 0.0f)};
        }

        void store(float* to) const { _mm256_storeu_ps(to, v); }

        Quad low() const { return {_mm256_castps256_ps128(v)}; }

        Quad high() const { return {_mm256_extractf128_ps(v, 1)}; }

        /// Returns the nodes of a row.
        Quad first() const { return low(); }

        Quad second() const { return low().template from<3>(high()); }

        /// Returns the first nodes of two rows; seconds() the second ones.
        static Floats firsts(Floats a, Floats b) {
            return {_mm256_permute2f128_ps(a.v, b.v, 0x20)};
        }

        static Floats seconds(Floats a, Floats b) {
            const __m256 rest = _mm256_permute2f128_ps(a.v, b.v, 0x31);
            return {_mm256_castsi256_ps(_mm256_alignr_epi8(
                _mm256_castps_si256(rest), _mm256_castps_si256(firsts(a, b).v), 12))};
        }

        Floats low_twice() const { return {_mm256_permute2f128_ps(v, v, 0x00)}; }

        Floats high_twice() const { return {_mm256_permute2f128_ps(v, v, 0x11)}; }

        template <std::size_t I>
        Floats each() const {
            return {_mm256_permute_ps(v, static_cast<int>(I * 0x55))};
        }

        /// Computes x, y and z of eight vectors.
        static void components(const float (*from)[4], Floats (&to)[3]) {
            const auto pair = [&](std::size_t i) {
                return _mm256_set_m128(_mm_load_ps(from[i + 4]), _mm_load_ps(from[i]));
            };
            const __m256 a = pair(0), b = pair(1), c = pair(2), d = pair(3);
            const __m256 ab = _mm256_unpacklo_ps(a, b); // x x y y
            const __m256 cd = _mm256_unpacklo_ps(c, d);
            to[0].v = _mm256_shuffle_ps(ab, cd, 0x44);
            to[1].v = _mm256_shuffle_ps(ab, cd, 0xee);
            to[2].v = _mm256_shuffle_ps(_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d), 0x44);
        }

        static Floats min(Floats a, Floats b) { return {_mm256_min_ps(a.v, b.v)}; }

        static Floats max(Floats a, Floats b) { return {_mm256_max_ps(a.v, b.v)}; }

        Floats floor() const { return {_mm256_floor_ps(v)}; }

        /// Returns the bits of the elements where a > b.
        static unsigned above(Floats a, Floats b) {
            return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)));
        }

        static Floats where_zero(Floats test, Floats a, Floats b) {
            return {
                _mm256_blendv_ps(b.v, a.v, _mm256_cmp_ps(test.v, _mm256_setzero_ps(), _CMP_EQ_OQ))};
        }

        static Floats where_above(Floats a, Floats b, Floats then, Floats otherwise) {
            return {_mm256_blendv_ps(otherwise.v, then.v, _mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ))};
        }

        friend Floats operator+(Floats a, Floats b) { return {_mm256_add_ps(a.v, b.v)}; }

        friend Floats operator-(Floats a, Floats b) { return {_mm256_sub_ps(a.v, b.v)}; }

        friend Floats operator*(Floats a, Floats b) { return {_mm256_mul_ps(a.v, b.v)}; }
    };

    struct Wide {
        static constexpr std::size_t size = 4;

        __m256d v;

        static Wide load(const double* from) { return {_mm256_loadu_pd(from)}; }

        static Wide all(double value) { return {_mm256_set1_pd(value)}; }

        static Wide min(Wide a, Wide b) { return {_mm256_min_pd(a.v, b.v)}; }

        static Wide max(Wide a, Wide b) { return {_mm256_max_pd(a.v, b.v)}; }

        /// Returns the bits of the elements where a <= b.
        static unsigned not_above(Wide a, Wide b) {
            return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)));
        }

        void store(double* to) const { _mm256_storeu_pd(to, v); }

        Wide truncated() const {
            return {_mm256_round_pd(v, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC)};
        }

        /// Stores integers below 2^51 in size: added to 3 * 2^51, they are the last bits of the sum.
        void integers(std::int64_t* to) const {
            const __m256d base = _mm256_set1_pd(6755399441055744.0);
            const __m256i bits = _mm256_sub_epi64(_mm256_castpd_si256(_mm256_add_pd(v, base)),
                                                  _mm256_castpd_si256(base));
            _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), bits);
        }

        Quad narrow() const { return {_mm256_cvtpd_ps(v)}; }

        friend Wide operator+(Wide a, Wide b) { return {_mm256_add_pd(a.v, b.v)}; }

        friend Wide operator-(Wide a, Wide b) { return {_mm256_sub_pd(a.v, b.v)}; }

        friend Wide operator*(Wide a, Wide b) { return {_mm256_mul_pd(a.v, b.v)}; }

        friend Wide operator/(Wide a, Wide b) { return {_mm256_div_pd(a.v, b.v)}; }
    };

    using Vector = Quad;

    static Quad quad(const Vector* of) { return of[0]; }

    using FourNodes = NodesInTwo<Avx2Lanes>;

    static Floats narrow(const double* from) {
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
