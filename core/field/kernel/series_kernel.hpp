// The computation of a batch of Taylor series, written once for all vectors. Every operation is that of the
// functions for one particle (trilinear_steps.hpp, path_series.hpp), in their order.
#pragma once

#include "core/field/kernel/series_batch.hpp"

namespace wakesurf::core {

/// @tparam Lanes  Number: four doubles in vectors, with load, store, all and root; Mask: what comparing them
///                gives, with bits
template <class Lanes>
class SeriesOfFour {
    using Number = typename Lanes::Number;
    using Mask = typename Lanes::Mask;

    static constexpr std::size_t order = 5;

    struct Exit {
        Number time, axis, step;
    };

  public:
    explicit SeriesOfFour(SeriesBatch& batch) : batch_(batch) {}

    void expand() {
        if (batch_.unsteady)
            find_terms<true>();
        else
            find_terms<false>();
        load_size();
        Lanes::store(length(1), batch_.speed);
        const Exit exit = leaves_cell();
        Lanes::store(exit.time, batch_.exit_time);
        Lanes::store(exit.axis, batch_.exit_axis);
        Lanes::store(exit.step, batch_.exit_step);
    }

    void step() {
        for (std::size_t k = 0; k <= order; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis)
                term_[k][axis] = Lanes::load(batch_.term[k][axis]);
        load_size();
        const Number t = Lanes::load(batch_.time);
        const Number square2 = square(2), square3 = square(3), square4 = square(4);
        const Number last_square = square(5);
        const Number last = Lanes::root(last_square);
        const Number third_length = Lanes::root(square3);
        const Number fourth_or_last = third_length * last;
        Mask shorter = too_inexact(t, last_square, last, square4, fourth_or_last);
        find_output(t);
        shorter = shorter | find_arc(t);
        batch_.shorter = Lanes::bits(shorter);

        const Number fourth = larger(Lanes::root(square4), Lanes::root(fourth_or_last));
        const Number third = larger(third_length, Lanes::root(Lanes::root(square2) * fourth));
        const Number growth = t * larger(last / fourth, fourth / third);
        const Number power = t * t * t * t;
        const Number error = growth * larger(last * t, fourth * growth) * power /
                             larger(all(1.0) - growth, all(0.1));
        Lanes::store(Lanes::select((third > all(0.0)) & (fourth > all(0.0)), error, all(0.0)),
                     batch_.error);
    }

  private:
    static Number all(double value) { return Lanes::all(value); }

    /// std::max and std::min, also of what is no number.
    static Number larger(Number a, Number b) { return Lanes::select(a < b, b, a); }

    template <bool Unsteady>
    void find_terms() {
        Number x[order], y[order], z[order], xy[order], xz[order], yz[order];
        x[0] = Lanes::load(batch_.place[0]);
        y[0] = Lanes::load(batch_.place[1]);
        z[0] = Lanes::load(batch_.place[2]);
        Number changed[3] = {all(0.0), all(0.0), all(0.0)};
        Number part{}, rate{};
        if constexpr (Unsteady) {
            part = Lanes::load(batch_.part);
            rate = Lanes::load(batch_.rate);
        }
        const auto keep = [&](std::size_t k, std::size_t axis, Number value) {
            term_[k][axis] = value;
            Lanes::store(value, batch_.term[k][axis]);
        };
        keep(0, 0, x[0]);
        keep(0, 1, y[0]);
        keep(0, 2, z[0]);
        for (std::size_t k = 0; k < order; ++k) {
            xy[k] = xz[k] = yz[k] = all(0.0);
            Number xyz = all(0.0);
            for (std::size_t j = 0; j <= k; ++j) {
                xy[k] = xy[k] + x[j] * y[k - j];
                xz[k] = xz[k] + x[j] * z[k - j];
                yz[k] = yz[k] + y[j] * z[k - j];
            }
            for (std::size_t j = 0; j <= k; ++j)
                xyz = xyz + xy[j] * z[k - j];
            const Number m[7] = {x[k], y[k], xy[k], z[k], xz[k], yz[k], xyz};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Number v = rest(batch_.now, axis, m);
                if (k == 0)
                    v = v + Lanes::load(batch_.now[0][axis]);
                if constexpr (Unsteady) {
                    Number change = rest(batch_.change, axis, m);
                    if (k == 0)
                        change = change + Lanes::load(batch_.change[0][axis]);
                    v = v + change * part + changed[axis] * rate;
                    changed[axis] = change;
                }
                keep(k + 1, axis, v * all(1.0 / static_cast<double>(k + 1)));
            }
            if (k + 1 < order) {
                x[k + 1] = term_[k + 1][0];
                y[k + 1] = term_[k + 1][1];
                z[k + 1] = term_[k + 1][2];
            }
        }
    }

    static Number
    rest(const SeriesBatch::Numbers (&c)[8][3], std::size_t axis, const Number (&m)[7]) {
        const auto product = [&](std::size_t i) { return Lanes::load(c[i][axis]) * m[i - 1]; };
        return ((product(1) + product(2)) + (product(3) + product(4))) +
               ((product(5) + product(6)) + product(7));
    }

    void load_size() {
        for (std::size_t axis = 0; axis < 3; ++axis)
            size_[axis] = Lanes::load(batch_.size[axis]);
    }

    Number square(std::size_t k) const {
        const Number x = term_[k][0] * size_[0];
        const Number y = term_[k][1] * size_[1];
        const Number z = term_[k][2] * size_[2];
        return (x * x + y * y) + z * z;
    }

    Number length(std::size_t k) const { return Lanes::root(square(k)); }

    /// The path along one axis, of each lane's own.
    struct Along {
        Number term[order + 1];

        Number at(Number t) const {
            Number sum = term[order];
            for (std::size_t k = order; k-- > 0;)
                sum = sum * t + term[k];
            return sum;
        }

        Number slope(Number t) const {
            Number sum = all(order) * term[order];
            for (std::size_t k = order; k-- > 1;)
                sum = sum * t + all(static_cast<double>(k)) * term[k];
            return sum;
        }
    };

    Along along(std::size_t axis) const {
        Along one;
        for (std::size_t k = 0; k <= order; ++k)
            one.term[k] = term_[k][axis];
        return one;
    }

    Along along(Number axis) const {
        const Mask first = axis < all(0.5);
        const Mask second = axis < all(1.5);
        Along one;
        for (std::size_t k = 0; k <= order; ++k)
            one.term[k] =
                Lanes::select(first, term_[k][0], Lanes::select(second, term_[k][1], term_[k][2]));
        return one;
    }

    Exit roughly_leaves(std::size_t axis) const {
        const Number zero = all(0.0), one = all(1.0);
        const Number u = term_[0][axis];
        const Number direction = Lanes::select(term_[1][axis] < zero, all(-1.0), one);
        const Number behind = larger(Lanes::select(direction > zero, u, one - u), zero);
        const Number ahead = larger(one - behind, zero);
        const Number v = Lanes::select(term_[1][axis] < zero, -term_[1][axis], term_[1][axis]);
        const Number a = direction * term_[2][axis];
        const Number square = v * v + all(4.0) * a * ahead;
        const Number sum = v + Lanes::root(square);
        const Number back = (v + Lanes::root(v * v - all(4.0) * a * behind)) / (all(-2.0) * a);
        const Mask goes = (square >= zero) & (sum > zero);
        const Mask rests = (square >= zero) & !(sum > zero) & !(a < zero);
        const Mask rises = a > zero;
        Exit exit;
        exit.time = Lanes::select(
            goes, all(2.0) * ahead / sum,
            Lanes::select(rests, Lanes::select(rises, zero, all(__builtin_inf())), back));
        exit.axis = all(static_cast<double>(axis));
        exit.step =
            Lanes::select(goes, direction,
                          Lanes::select(rests, Lanes::select(rises, direction, zero), -direction));
        return exit;
    }

    static void replace(Exit& exit, Mask where, const Exit& by) {
        exit.time = Lanes::select(where, by.time, exit.time);
        exit.axis = Lanes::select(where, by.axis, exit.axis);
        exit.step = Lanes::select(where, by.step, exit.step);
    }

    static void sharpen(const Along& path, Exit& exit, Mask some) {
        const Number zero = all(0.0);
        const Number face = Lanes::select(exit.step > zero, all(1.0), zero);
        for (int i = 0; i < 5; ++i) {
            const Number slope = path.slope(exit.time);
            some = some & !(slope * exit.step <= zero);
            if (Lanes::bits(some) == 0)
                return;
            const Number change = (path.at(exit.time) - face) / slope;
            exit.time = Lanes::select(some, larger(exit.time - change, zero), exit.time);
            const Number size = Lanes::select(change < zero, -change, change);
            some = some & !(size <= all(5e-3) * exit.time);
        }
    }

    Exit leaves_cell() const {
        const Number zero = all(0.0);
        Exit first{all(__builtin_inf()), zero, zero};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Exit exit = roughly_leaves(axis);
            replace(first, exit.time < first.time, exit);
        }
        const Mask moves = (first.step < zero) | (first.step > zero);
        sharpen(along(first.axis), first, moves);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Along path = along(axis);
            const Number here = all(static_cast<double>(axis));
            const Number u = path.at(first.time);
            const Mask other = (first.axis < here) | (first.axis > here);
            const Mask beyond = moves & other & !((u <= all(1.0 + 1e-5)) & (u >= all(-1e-5)));
            if (Lanes::bits(beyond) == 0)
                continue;
            Exit earlier{first.time, here, Lanes::select(u > all(1.0), all(1.0), all(-1.0))};
            sharpen(path, earlier, beyond);
            replace(first, beyond & (earlier.time < first.time), earlier);
        }
        return first;
    }

    /// Returns where a step of `t` errs by more than is allowed.
    Mask too_inexact(Number t,
                     Number last_square,
                     Number last,
                     Number fourth_square,
                     Number fourth_or_last) const {
        const Number allowed = Lanes::load(batch_.allowed);
        const Number power = t * t * t * t;
        const Mask sure = last_square * power * power <= allowed * allowed;
        const Number before = Lanes::root(larger(fourth_square, fourth_or_last));
        const Number ratio = Lanes::select(before > all(0.0), last / before, all(0.0));
        const Number square = t * t;
        const Number error = last * square * square * (all(0.0025) + ratio * t);
        return (t > Lanes::load(batch_.least)) & !sure & !(error <= allowed);
    }

    /// Finds the output's positions.
    void find_output(Number t) {
        constexpr double quartic[5] = {0.0, -0.07725424859373686, 0.7317627457812106,
                                       -2.1545084971874737, 2.5};
        const Number t5 = t * t * t * t * t;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Number last = term_[order][axis] * size_[axis] * t5;
            Number m[5];
            Number power = all(1.0);
            for (std::size_t k = 0; k < 5; ++k) {
                m[k] = term_[k][axis] * size_[axis] * power + all(quartic[k]) * last;
                power = power * t;
            }
            // From 0, as -x is of a vector: of terms that are 0 it stays +0.
            const Number second = all(0.0) - m[2] - m[3] - m[4];
            Lanes::store(m[0] + Lanes::load(batch_.low[axis]), batch_.output[0][axis]);
            Lanes::store(m[1] - second, batch_.output[1][axis]);
            Lanes::store(second, batch_.output[2][axis]);
            Lanes::store(all(0.0) - m[3] - all(2.0) * m[4], batch_.output[3][axis]);
            Lanes::store(m[4], batch_.output[4][axis]);
        }
    }

    Number speed_at(Number t) const {
        const Number x = along(std::size_t{0}).slope(t) * size_[0];
        const Number y = along(std::size_t{1}).slope(t) * size_[1];
        const Number z = along(std::size_t{2}).slope(t) * size_[2];
        return Lanes::root((x * x + y * y) + z * z);
    }

    /// Finds the output's arc lengths. Returns where they would not rise.
    Mask find_arc(Number t) {
        const Number v0 = speed_at(all(0.0));
        const Number v1 = speed_at(t);
        const Number length = t / all(6.0) * (v0 + all(4.0) * speed_at(all(0.5) * t) + v1);
        const Number second = t * v0 - length;
        Lanes::store(Lanes::load(batch_.arc), batch_.output[0][3]);
        Lanes::store(length, batch_.output[1][3]);
        Lanes::store(second, batch_.output[2][3]);
        Lanes::store(length - t * v1 - second, batch_.output[3][3]);
        Lanes::store(all(0.0), batch_.output[4][3]);
        return larger(v0, v1) * t > all(2.9) * length;
    }

    SeriesBatch& batch_;
    Number term_[order + 1][3];
    Number size_[3];
};

/// Four doubles in vectors of the compiler's.
/// @tparam Parts  as many vectors
template <class Vector, class Bits, std::size_t Parts>
struct VectorLanes {
    static constexpr std::size_t each = SeriesBatch::lanes / Parts;

    struct Mask {
        Bits part[Parts];

        friend Mask operator&(Mask a, Mask b) {
            return make([&](std::size_t i) { return a.part[i] & b.part[i]; });
        }

        friend Mask operator|(Mask a, Mask b) {
            return make([&](std::size_t i) { return a.part[i] | b.part[i]; });
        }

        friend Mask operator!(Mask a) {
            return make([&](std::size_t i) { return ~a.part[i]; });
        }

        template <class Each>
        static Mask make(const Each& each) {
            Mask out;
            for (std::size_t i = 0; i < Parts; ++i)
                out.part[i] = each(i);
            return out;
        }
    };

    struct Number {
        Vector part[Parts];

        template <class Each>
        static Number make(const Each& each) {
            Number out;
            for (std::size_t i = 0; i < Parts; ++i)
                out.part[i] = each(i);
            return out;
        }

        friend Number operator+(Number a, Number b) {
            return make([&](std::size_t i) { return a.part[i] + b.part[i]; });
        }

        friend Number operator-(Number a, Number b) {
            return make([&](std::size_t i) { return a.part[i] - b.part[i]; });
        }

        friend Number operator-(Number a) {
            return make([&](std::size_t i) { return -a.part[i]; });
        }

        friend Number operator*(Number a, Number b) {
            return make([&](std::size_t i) { return a.part[i] * b.part[i]; });
        }

        friend Number operator/(Number a, Number b) {
            return make([&](std::size_t i) { return a.part[i] / b.part[i]; });
        }

        friend Mask operator<(Number a, Number b) {
            return Mask::make([&](std::size_t i) { return Bits(a.part[i] < b.part[i]); });
        }

        friend Mask operator>(Number a, Number b) { return b < a; }

        friend Mask operator<=(Number a, Number b) {
            return Mask::make([&](std::size_t i) { return Bits(a.part[i] <= b.part[i]); });
        }

        friend Mask operator>=(Number a, Number b) { return b <= a; }
    };

    static Number load(const double* from) {
        return Number::make([&](std::size_t i) {
            Vector part;
            __builtin_memcpy(&part, from + i * each, sizeof part);
            return part;
        });
    }

    static void store(Number value, double* to) { __builtin_memcpy(to, &value, sizeof value); }

    static Number all(double value) {
        return Number::make([&](std::size_t) { return value - Vector{}; });
    }

    static Number select(Mask where, Number a, Number b) {
        return Number::make([&](std::size_t i) {
            return Vector((where.part[i] & Bits(a.part[i])) | (~where.part[i] & Bits(b.part[i])));
        });
    }

    static std::uint32_t bits(Mask mask) {
        std::uint32_t out = 0;
        for (std::size_t i = 0; i < SeriesBatch::lanes; ++i)
            out |= (mask.part[i / each][i % each] != 0 ? 1u : 0u) << i;
        return out;
    }
};

} // namespace wakesurf::core
