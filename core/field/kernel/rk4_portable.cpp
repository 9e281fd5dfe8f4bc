// The batch kernel on vectors of 16 bytes in the compiler's own notation (GCC's vector extensions, which
// clang has too): it makes instructions of the baseline processor of them, or of any other one. With arrays
// and loops in their place this file took 283 s of a processor to compile, and 68 s so.
#include "core/field/kernel/rk4_kernel.hpp"

#include <utility>

namespace wakesurf::core {

namespace {

/// Element-by-element arithmetic for `Self`, which derives from this: `Parts` vectors of 16 bytes.
template <class Self, class T, std::size_t Parts>
struct Vectors {
    using Part [[gnu::vector_size(16)]] = T;
    static constexpr std::size_t in_part = 16 / sizeof(T);
    static constexpr std::size_t size = Parts * in_part;

    Part part[Parts];

    /// Returns the vector of `value` of each part's number. Without a loop: the compiler takes half as long.
    template <class Value>
    static Self made_of(const Value& value) {
        return [&]<std::size_t... I>(std::index_sequence<I...>) {
            return Self{{{value(I)...}}};
        }
        (std::make_index_sequence<Parts>());
    }

    /// Returns the vector of `value` of each element's number.
    template <class Value>
    static Self each_made_of(const Value& value) {
        return made_of([&](std::size_t i) {
            return [&]<std::size_t... K>(std::index_sequence<K...>) {
                return Part{value(in_part * i + K)...};
            }
            (std::make_index_sequence<in_part>());
        });
    }

    static Self load(const T* from) {
        return made_of([&](std::size_t i) {
            Part r;
            __builtin_memcpy(&r, from + in_part * i, sizeof r);
            return r;
        });
    }

    static Self all(T value) {
        return each_made_of([&](std::size_t) { return value; });
    }

    void store(T* to) const { __builtin_memcpy(to, part, sizeof part); }

    T at(std::size_t i) const { return part[i / in_part][i % in_part]; }

    static Self min(const Self& a, const Self& b) {
        return made_of(
            [&](std::size_t i) { return a.part[i] < b.part[i] ? a.part[i] : b.part[i]; });
    }

    static Self max(const Self& a, const Self& b) {
        return made_of(
            [&](std::size_t i) { return a.part[i] > b.part[i] ? a.part[i] : b.part[i]; });
    }

    friend Self operator+(const Self& a, const Self& b) {
        return made_of([&](std::size_t i) { return a.part[i] + b.part[i]; });
    }

    friend Self operator-(const Self& a, const Self& b) {
        return made_of([&](std::size_t i) { return a.part[i] - b.part[i]; });
    }

    friend Self operator*(const Self& a, const Self& b) {
        return made_of([&](std::size_t i) { return a.part[i] * b.part[i]; });
    }

    friend Self operator/(const Self& a, const Self& b) {
        return made_of([&](std::size_t i) { return a.part[i] / b.part[i]; });
    }
};

struct PortableLanes {
    static constexpr std::size_t together = 1;

    struct Wide;

    struct Quad : Vectors<Quad, float, 1> {
        /// Returns the elements from `N` of this and the next one together.
        template <int N>
        Quad from(const Quad& next) const {
            return {{{__builtin_shufflevector(part[0], next.part[0], N, N + 1, N + 2, N + 3)}}};
        }

        Wide widen() const {
            return Wide::each_made_of([&](std::size_t i) { return double{at(i)}; });
        }
    };

    using Vector = Quad;

    static Quad quad(const Vector* of) { return of[0]; }

    using FourNodes = NodesInTwo<PortableLanes>;

    struct Floats : Vectors<Floats, float, 2> {
        static Floats both(const Quad& low, const Quad& high) {
            return {{{low.part[0], high.part[0]}}};
        }

        /// Loads a row for each particle.
        static Floats rows(const float* from, const std::int64_t* at) { return load(from + at[0]); }

        /// Spreads a particle's number over its row, and over its vectors in either half.
        static Floats each_of(const float* number) { return all(number[0]); }

        static Floats each_of_quads(const float* number) { return all(number[0]); }

        static Floats twice(const Quad& q) { return both(q, q); }

        static Floats twice_of(float x, float y, float z) {
            return twice(Quad{{{{x, y, z, 0.0f}}}});
        }

        Quad low() const { return {{{part[0]}}}; }

        Quad high() const { return {{{part[1]}}}; }

        /// Returns the nodes of a row.
        Quad first() const { return low(); }

        Quad second() const { return low().from<3>(high()); }

        /// Returns the first nodes of two rows; seconds() the second ones.
        static Floats firsts(const Floats& a, const Floats& b) { return both(a.low(), b.low()); }

        static Floats seconds(const Floats& a, const Floats& b) {
            return both(a.second(), b.second());
        }

        Floats low_twice() const { return twice(low()); }

        Floats high_twice() const { return twice(high()); }

        /// Spreads component `I` of either half over all of that half.
        template <int I>
        Floats each() const {
            return made_of([&](std::size_t i) {
                return __builtin_shufflevector(part[i], part[i], I, I, I, I);
            });
        }

        /// Computes x, y and z of eight vectors.
        static void components(const float (*from)[4], Floats (&to)[3]) {
            for (std::size_t half = 0; half < 2; ++half) {
                const auto row = [&](std::size_t i) {
                    return Quad::load(from[4 * half + i]).part[0];
                };
                const Part a = row(0), b = row(1), c = row(2), d = row(3);
                const Part ab = __builtin_shufflevector(a, b, 0, 4, 1, 5); // x x y y
                const Part cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
                to[0].part[half] = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
                to[1].part[half] = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
                const Part ab_z = __builtin_shufflevector(a, b, 2, 6, 3, 7);
                const Part cd_z = __builtin_shufflevector(c, d, 2, 6, 3, 7);
                to[2].part[half] = __builtin_shufflevector(ab_z, cd_z, 0, 1, 4, 5);
            }
        }

        /// Rounds down. REQUIRES: values that an int32 holds.
        Floats floor() const {
            using Integers [[gnu::vector_size(16)]] = std::int32_t;
            return made_of([&](std::size_t i) {
                const Part towards_zero =
                    __builtin_convertvector(__builtin_convertvector(part[i], Integers), Part);
                return towards_zero > part[i] ? towards_zero - 1.0f : towards_zero;
            });
        }

        /// Returns the bits of the elements where a > b.
        static unsigned above(const Floats& a, const Floats& b) {
            unsigned bits = 0;
            for (std::size_t i = 0; i < size; ++i)
                bits |= (a.at(i) > b.at(i) ? 1u : 0u) << i;
            return bits;
        }

        static Floats where_zero(const Floats& test, const Floats& a, const Floats& b) {
            return made_of(
                [&](std::size_t i) { return test.part[i] == 0.0f ? a.part[i] : b.part[i]; });
        }

        static Floats
        where_above(const Floats& a, const Floats& b, const Floats& then, const Floats& otherwise) {
            return made_of([&](std::size_t i) {
                return a.part[i] > b.part[i] ? then.part[i] : otherwise.part[i];
            });
        }
    };

    struct Wide : Vectors<Wide, double, 2> {
        /// Returns the bits of the elements where a <= b.
        static unsigned not_above(const Wide& a, const Wide& b) {
            unsigned bits = 0;
            for (std::size_t i = 0; i < size; ++i)
                bits |= (a.at(i) <= b.at(i) ? 1u : 0u) << i;
            return bits;
        }

        Wide truncated() const {
            return each_made_of([&](std::size_t i) {
                return static_cast<double>(static_cast<std::int64_t>(at(i)));
            });
        }

        void integers(std::int64_t* to) const {
            for (std::size_t i = 0; i < size; ++i)
                to[i] = static_cast<std::int64_t>(at(i));
        }

        Quad narrow() const {
            return Quad::each_made_of([&](std::size_t i) { return static_cast<float>(at(i)); });
        }
    };

    static Floats narrow(const double* from) {
        return Floats::each_made_of([&](std::size_t i) { return static_cast<float>(from[i]); });
    }
};

} // namespace

void rk4_portable(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    rk4_step<PortableLanes>(field, batch, tangents);
}

} // namespace wakesurf::core
