// The batch kernel on plain arrays, which the compiler turns into whatever vectors the baseline processor
// has.
#include "core/field/kernel/rk4_kernel.hpp"

namespace wakesurf::core {

namespace {

/// Element-by-element arithmetic for `Self`, which derives from this.
template <class Self, class T, std::size_t N>
struct Array {
    static constexpr std::size_t size = N;

    T at[N];

    template <class Value>
    static Self made_of(const Value& value) {
        Self r;
        for (std::size_t i = 0; i < N; ++i)
            r.at[i] = value(i);
        return r;
    }

    static Self load(const T* from) {
        return made_of([&](std::size_t i) { return from[i]; });
    }

    static Self all(T value) {
        return made_of([&](std::size_t) { return value; });
    }

    void store(T* to) const {
        for (std::size_t i = 0; i < N; ++i)
            to[i] = at[i];
    }

    friend Self operator+(const Self& a, const Self& b) {
        return made_of([&](std::size_t i) { return a.at[i] + b.at[i]; });
    }

    friend Self operator-(const Self& a, const Self& b) {
        return made_of([&](std::size_t i) { return a.at[i] - b.at[i]; });
    }

    friend Self operator*(const Self& a, const Self& b) {
        return made_of([&](std::size_t i) { return a.at[i] * b.at[i]; });
    }
};

struct PortableLanes {
    static constexpr std::size_t together = 1;

    struct Wide;

    struct Quad : Array<Quad, float, 4> {
        /// Returns the elements from `N` of this and the next one together.
        template <std::size_t N>
        Quad from(const Quad& next) const {
            return made_of(
                [&](std::size_t i) { return i + N < 4 ? at[i + N] : next.at[i + N - 4]; });
        }

        Wide widen() const {
            return Wide::made_of([&](std::size_t i) { return double{at[i]}; });
        }
    };

    using Vector = Quad;

    static Quad quad(const Vector* of) { return of[0]; }

    using FourNodes = NodesInTwo<PortableLanes>;

    struct Floats : Array<Floats, float, 8> {
        static Floats both(const Quad& low, const Quad& high) {
            return made_of([&](std::size_t i) { return i < 4 ? low.at[i] : high.at[i - 4]; });
        }

        /// Loads a row for each particle.
        static Floats rows(const float* from, const std::int64_t* at) { return load(from + at[0]); }

        /// Spreads a particle's number over its row, and over its vectors in either half.
        static Floats each_of(const float* number) { return all(number[0]); }

        static Floats each_of_quads(const float* number) { return all(number[0]); }

        static Floats twice(const Quad& q) { return both(q, q); }

        static Floats twice_of(float x, float y, float z) {
            return {{{x, y, z, 0.0f, x, y, z, 0.0f}}};
        }

        Quad low() const { return Quad::load(at); }

        Quad high() const { return Quad::load(at + 4); }

        /// Returns the nodes of a row.
        Quad first() const { return low(); }

        Quad second() const { return Quad::load(at + 3); }

        /// Returns the first nodes of two rows; seconds() the second ones.
        static Floats firsts(const Floats& a, const Floats& b) { return both(a.low(), b.low()); }

        static Floats seconds(const Floats& a, const Floats& b) {
            return both(a.second(), b.second());
        }

        Floats low_twice() const { return twice(low()); }

        Floats high_twice() const { return twice(high()); }

        /// Spreads component `I` of either half over all of that half.
        template <std::size_t I>
        Floats each() const {
            return made_of([&](std::size_t i) { return at[i / 4 * 4 + I]; });
        }

        /// Computes x, y and z of eight vectors.
        static void components(const float (*from)[4], Floats (&to)[3]) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                to[axis] = made_of([&](std::size_t i) { return from[i][axis]; });
        }

        static Floats min(const Floats& a, const Floats& b) {
            return made_of([&](std::size_t i) { return a.at[i] < b.at[i] ? a.at[i] : b.at[i]; });
        }

        static Floats max(const Floats& a, const Floats& b) {
            return made_of([&](std::size_t i) { return a.at[i] > b.at[i] ? a.at[i] : b.at[i]; });
        }

        /// Rounds down. REQUIRES: values that an int32 holds.
        Floats floor() const {
            return made_of([&](std::size_t i) {
                const auto towards_zero = static_cast<float>(static_cast<std::int32_t>(at[i]));
                return towards_zero > at[i] ? towards_zero - 1.0f : towards_zero;
            });
        }

        /// Returns the bits of the elements where a > b.
        static unsigned above(const Floats& a, const Floats& b) {
            unsigned bits = 0;
            for (std::size_t i = 0; i < 8; ++i)
                bits |= (a.at[i] > b.at[i] ? 1u : 0u) << i;
            return bits;
        }

        static Floats where_zero(const Floats& test, const Floats& a, const Floats& b) {
            return made_of([&](std::size_t i) { return test.at[i] == 0.0f ? a.at[i] : b.at[i]; });
        }

        static Floats
        where_above(const Floats& a, const Floats& b, const Floats& then, const Floats& otherwise) {
            return made_of(
                [&](std::size_t i) { return a.at[i] > b.at[i] ? then.at[i] : otherwise.at[i]; });
        }
    };

    struct Wide : Array<Wide, double, 4> {
        static Wide min(const Wide& a, const Wide& b) {
            return made_of([&](std::size_t i) { return a.at[i] < b.at[i] ? a.at[i] : b.at[i]; });
        }

        static Wide max(const Wide& a, const Wide& b) {
            return made_of([&](std::size_t i) { return a.at[i] > b.at[i] ? a.at[i] : b.at[i]; });
        }

        /// Returns the bits of the elements where a <= b.
        static unsigned not_above(const Wide& a, const Wide& b) {
            unsigned bits = 0;
            for (std::size_t i = 0; i < 4; ++i)
                bits |= (a.at[i] <= b.at[i] ? 1u : 0u) << i;
            return bits;
        }

        Wide truncated() const {
            return made_of([&](std::size_t i) {
                return static_cast<double>(static_cast<std::int64_t>(at[i]));
            });
        }

        void integers(std::int64_t* to) const {
            for (std::size_t i = 0; i < 4; ++i)
                to[i] = static_cast<std::int64_t>(at[i]);
        }

        Quad narrow() const {
            return Quad::made_of([&](std::size_t i) { return static_cast<float>(at[i]); });
        }

        friend Wide operator/(const Wide& a, const Wide& b) {
            return made_of([&](std::size_t i) { return a.at[i] / b.at[i]; });
        }
    };

    static Floats narrow(const double* from) {
        return Floats::made_of([&](std::size_t i) { return static_cast<float>(from[i]); });
    }
};

} // namespace

void rk4_portable(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    rk4_step<PortableLanes>(field, batch, tangents);
}

} // namespace wakesurf::core
