// The batch kernel on AVX-512 vectors: two particles in each. Compiled for processors that have them: it
// includes nothing that has functions. Multiplies and adds apart, as the others do: a fused operation rounds
// once where they round twice.
#include "core/field/kernel/rk4_kernel.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include <immintrin.h>
#endif

namespace wakesurf::core {

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)

namespace {

/// Particles A and B: a row of A's is in the low half of Floats, one of B's in the high half. The vectors of
/// tangents follow each other as in memory: A's along s, A's along t, B's along s, B's along t.
struct Avx512Lanes {
    static constexpr std::size_t together = 2;

    struct Wide;

    /// A vector of one particle.
    struct Vector {
        __m128 v;

        static Vector load(const float* from) { return {_mm_loadu_ps(from)}; }

        static Vector all(float value) { return {_mm_set1_ps(value)}; }

        void store(float* to) const { _mm_storeu_ps(to, v); }

        friend Vector operator+(Vector a, Vector b) { return {_mm_add_ps(a.v, b.v)}; }

        friend Vector operator*(Vector a, Vector b) { return {_mm_mul_ps(a.v, b.v)}; }
    };

    /// A vector of A's and one of B's.
    struct Quad {
        static constexpr std::size_t size = 8;

        __m256 v;

        static Quad load(const float* from) { return {_mm256_loadu_ps(from)}; }

        static Quad all(float value) { return {_mm256_set1_ps(value)}; }

        void store(float* to) const { _mm256_storeu_ps(to, v); }

        Wide widen() const;

        friend Quad operator+(Quad a, Quad b) { return {_mm256_add_ps(a.v, b.v)}; }

        friend Quad operator-(Quad a, Quad b) { return {_mm256_sub_ps(a.v, b.v)}; }

        friend Quad operator*(Quad a, Quad b) { return {_mm256_mul_ps(a.v, b.v)}; }
    };

    struct Floats {
        static constexpr std::size_t size = 16;

        __m512 v;

        static Floats load(const float* from) { return {_mm512_loadu_ps(from)}; }

        static Floats all(float value) { return {_mm512_set1_ps(value)}; }

        static Floats both(Quad low, Quad high) {
            return {_mm512_insertf32x8(_mm512_castps256_ps512(low.v), high.v, 1)};
        }

        /// Loads a row for each particle.
        static Floats rows(const float* from, const std::int64_t* at) {
            return both(Quad::load(from + at[0]), Quad::load(from + at[1]));
        }

        /// Spreads a particle's number over its row: A A B B, by vectors.
        static Floats each_of(const float* number) {
            return {
                _mm512_permutevar_ps(pair_of(number), _mm512_setr_epi32(0, 0, 0, 0, 0, 0, 0, 0, 1,
                                                                        1, 1, 1, 1, 1, 1, 1))};
        }

        /// Spreads it over its vectors in either half: A B A B.
        static Floats each_of_quads(const float* number) {
            return {
                _mm512_permutevar_ps(pair_of(number), _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 0,
                                                                        0, 0, 0, 1, 1, 1, 1))};
        }

        /// Makes A A B B of A B.
        static Floats twice(Quad q) {
            const __m512 ab = _mm512_castps256_ps512(q.v);
            return {_mm512_shuffle_f32x4(ab, ab, 0x50)};
        }

        static Floats twice_of(float x, float y, float z) {
            return {_mm512_broadcast_f32x4(_mm_setr_ps(x, y, z, 0.0f))};
        }

        void store(float* to) const { _mm512_storeu_ps(to, v); }

        Quad low() const { return {_mm512_castps512_ps256(v)}; }

        Quad high() const { return {_mm512_extractf32x8_ps(v, 1)}; }

        /// Returns the nodes of the rows.
        Quad first() const { return {_mm512_castps512_ps256(_mm512_shuffle_f32x4(v, v, 0x08))}; }

        Quad second() const {
            return {_mm512_castps512_ps256(_mm512_permutexvar_ps(
                _mm512_setr_epi32(3, 4, 5, 6, 11, 12, 13, 14, 0, 0, 0, 0, 0, 0, 0, 0), v))};
        }

        /// Returns the first nodes of the rows of a, then of those of b; seconds() the second ones.
        static Floats firsts(Floats a, Floats b) { return {_mm512_shuffle_f32x4(a.v, b.v, 0x88)}; }

        static Floats seconds(Floats a, Floats b) {
            return {_mm512_permutex2var_ps(
                a.v, _mm512_setr_epi32(3, 4, 5, 6, 11, 12, 13, 14, 19, 20, 21, 22, 27, 28, 29, 30),
                b.v)};
        }

        Floats low_twice() const { return {_mm512_shuffle_f32x4(v, v, 0x50)}; }

        Floats high_twice() const { return {_mm512_shuffle_f32x4(v, v, 0xfa)}; }

        /// Spreads component `I` of each vector over all of it.
        template <std::size_t I>
        Floats each() const {
            return {_mm512_permute_ps(v, static_cast<int>(I * 0x55))};
        }

        /// Computes x, y and z of sixteen vectors.
        static void components(const float (*from)[4], Floats (&to)[3]) {
            const auto four = [&](std::size_t i) { // as they were stored, two at a time
                return both(Quad::load(from[i]), Quad::load(from[i + 8])).v;
            };
            const __m512 a = four(0), b = four(2), c = four(4), d = four(6);
            const __m512i in_order =
                _mm512_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7, 8, 12, 9, 13, 10, 14, 11, 15);
            const auto sorted = [&](__m512 some) { return _mm512_permutexvar_ps(in_order, some); };
            const __m512 ab = _mm512_unpacklo_ps(a, b); // x x y y
            const __m512 cd = _mm512_unpacklo_ps(c, d);
            to[0].v = sorted(_mm512_shuffle_ps(ab, cd, 0x44));
            to[1].v = sorted(_mm512_shuffle_ps(ab, cd, 0xee));
            to[2].v =
                sorted(_mm512_shuffle_ps(_mm512_unpackhi_ps(a, b), _mm512_unpackhi_ps(c, d), 0x44));
        }

        static Floats min(Floats a, Floats b) { return {_mm512_min_ps(a.v, b.v)}; }

        static Floats max(Floats a, Floats b) { return {_mm512_max_ps(a.v, b.v)}; }

        Floats floor() const {
            return {_mm512_roundscale_ps(v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
        }

        /// Returns the bits of the elements where a > b.
        static unsigned above(Floats a, Floats b) {
            return _mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ);
        }

        static Floats where_zero(Floats test, Floats a, Floats b) {
            return {_mm512_mask_blend_ps(
                _mm512_cmp_ps_mask(test.v, _mm512_setzero_ps(), _CMP_EQ_OQ), b.v, a.v)};
        }

        static Floats where_above(Floats a, Floats b, Floats then, Floats otherwise) {
            return {_mm512_mask_blend_ps(_mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ), otherwise.v,
                                         then.v)};
        }

        friend Floats operator+(Floats a, Floats b) { return {_mm512_add_ps(a.v, b.v)}; }

        friend Floats operator-(Floats a, Floats b) { return {_mm512_sub_ps(a.v, b.v)}; }

        friend Floats operator*(Floats a, Floats b) { return {_mm512_mul_ps(a.v, b.v)}; }

      private:
        /// Loads numbers of A and B, in each four elements twice.
        static __m512 pair_of(const float* number) {
            return _mm512_broadcast_f32x2(
                _mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(number))));
        }
    };

    struct Wide {
        static constexpr std::size_t size = 8;

        __m512d v;

        static Wide load(const double* from) { return {_mm512_loadu_pd(from)}; }

        static Wide all(double value) { return {_mm512_set1_pd(value)}; }

        static Wide min(Wide a, Wide b) { return {_mm512_min_pd(a.v, b.v)}; }

        static Wide max(Wide a, Wide b) { return {_mm512_max_pd(a.v, b.v)}; }

        /// Returns the bits of the elements where a <= b.
        static unsigned not_above(Wide a, Wide b) {
            return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ);
        }

        void store(double* to) const { _mm512_storeu_pd(to, v); }

        Wide truncated() const {
            return {_mm512_roundscale_pd(v, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC)};
        }

        void integers(std::int64_t* to) const { _mm512_storeu_si512(to, _mm512_cvttpd_epi64(v)); }

        Quad narrow() const { return {_mm512_cvtpd_ps(v)}; }

        friend Wide operator+(Wide a, Wide b) { return {_mm512_add_pd(a.v, b.v)}; }

        friend Wide operator-(Wide a, Wide b) { return {_mm512_sub_pd(a.v, b.v)}; }

        friend Wide operator*(Wide a, Wide b) { return {_mm512_mul_pd(a.v, b.v)}; }

        friend Wide operator/(Wide a, Wide b) { return {_mm512_div_pd(a.v, b.v)}; }
    };

    static Quad quad(const Vector* of) { return {_mm256_set_m128(of[1].v, of[0].v)}; }

    /// Loads four nodes at once, with four floats more: those beyond the last node of a time-step can be read
    /// (Slab).
    struct FourNodes {
        __m512 v;

        static FourNodes none() { return {_mm512_setzero_ps()}; }

        static FourNodes load(const float* from) { return {_mm512_loadu_ps(from)}; }

        void add(float share, FourNodes other) {
            v = _mm512_add_ps(v, _mm512_mul_ps(_mm512_set1_ps(share), other.v));
        }

        /// The fourth element is anything.
        template <std::size_t K>
        Vector node() const {
            if constexpr (K == 0)
                return {_mm512_castps512_ps128(v)};
            else
                return {_mm512_castps512_ps128(_mm512_castsi512_ps(
                    _mm512_alignr_epi32(_mm512_castps_si512(v), _mm512_castps_si512(v), 3 * K)))};
        }
    };

    static Floats narrow(const double* from) {
        return Floats::both(Wide::load(from).narrow(), Wide::load(from + Wide::size).narrow());
    }
};

inline Avx512Lanes::Wide Avx512Lanes::Quad::widen() const {
    return {_mm512_cvtps_pd(v)};
}

} // namespace

void rk4_avx512(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    rk4_step<Avx512Lanes>(field, batch, tangents);
}

bool avx512_compiled() {
    return true;
}

#else

void rk4_avx512(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    rk4_portable(field, batch, tangents);
}

bool avx512_compiled() {
    return false;
}

#endif

} // namespace wakesurf::core
