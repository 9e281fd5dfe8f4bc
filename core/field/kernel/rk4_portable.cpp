// The batch kernel on plain arrays, which the compiler turns into whatever vectors the baseline processor has.
#include "core/field/kernel/rk4_kernel.hpp"

namespace wakesurf::core {

namespace {

/// `Self` derives from this and so gets arithmetic, element by element.
template <class Self, class T, std::size_t N>
struct Array {
    T at[N];

    template <class Value>
    static Self each_of(const Value& value) {
        Self r;
        for (std::size_t i = 0; i < N; ++i)
            r.at[i] = value(i);
        return r;
    }

    static Self load(const T* from) {
        return each_of([&](std::size_t i) { return from[i]; });
    }

    static Self all(T value) {
        return each_of([&](std::size_t) { return value; });
    }

    void store(T* to) const {
        for (std::size_t i = 0; i < N; ++i)
            to[i] = at[i];
    }

    friend Self operator+(const Self& a, const Self& b) {
        return each_of([&](std::size_t i) { return a.at[i] + b.at[i]; });
    }

    friend Self operator-(const Self& a, const Self& b) {
        return each_of([&](std::size_t i) { return a.at[i] - b.at[i]; });
    }

    friend Self operator*(const Self& a, const Self& b) {
        return each_of([&](std::size_t i) { return a.at[i] * b.at[i]; });
    }
};

struct PortableLanes {
    struct Wide;

    struct Quad : Array<Quad, float, 4> {
        float sum3() const { return at[0] + at[1] + at[2]; }

        Wide widen() const {
            return Wide::each_of([&](std::size_t i) { return double{at[i]}; });
        }
    };

    struct Row : Array<Row, float, 8> {
        static Row twice(const Quad& q) {
            return each_of([&](std::size_t i) { return q.at[i % 4]; });
        }

        Quad first() const { return Quad::load(at); }

        Quad second() const {
            return Quad::each_of([&](std::size_t i) { return at[3 + i]; });
        }

        /// Component `I` of either half, all over that half.
        template <std::size_t I>
        Row each() const {
            return each_of([&](std::size_t i) { return at[i / 4 * 4 + I]; });
        }
    };

    struct Wide : Array<Wide, double, 4> {
        static Wide min(const Wide& a, const Wide& b) {
            return each_of([&](std::size_t i) { return a.at[i] < b.at[i] ? a.at[i] : b.at[i]; });
        }

        static Wide max(const Wide& a, const Wide& b) {
            return each_of([&](std::size_t i) { return a.at[i] > b.at[i] ? a.at[i] : b.at[i]; });
        }

        static bool between(const Wide& low, const Wide& x, const Wide& high) {
            bool all = true;
            for (std::size_t i = 0; i < 3; ++i)
                all = all && low.at[i] <= x.at[i] && x.at[i] <= high.at[i];
            return all;
        }

        Wide truncated(std::int64_t (&index)[3]) const {
            for (std::size_t i = 0; i < 3; ++i)
                index[i] = static_cast<std::int32_t>(at[i]);
            return each_of([&](std::size_t i) {
                return static_cast<double>(static_cast<std::int32_t>(at[i]));
            });
        }

        Quad narrow() const {
            return Quad::each_of([&](std::size_t i) { return static_cast<float>(at[i]); });
        }
    };

    static Row narrow(const double* from) {
        return Row::each_of([&](std::size_t i) { return static_cast<float>(from[i]); });
    }
};

} // namespace

void rk4_portable(const StoredPair& field, Rk4Batch& batch, bool tangents) {
    rk4_step<PortableLanes>(field, batch, tangents);
}

} // namespace wakesurf::core
