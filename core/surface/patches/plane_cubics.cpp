#include "core/surface/patches/plane_cubics.hpp"

#include <cmath>

namespace wakesurf::core {

namespace {

constexpr double ridge = 1e-9; ///< of the largest diagonal element

PlaneCubics::Terms terms_at(double x, double y) {
    return {1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
}

PlaneCubics::Terms terms_by_x(double x, double y) {
    return {0.0, 1.0, 0.0, 2.0 * x, y, 0.0, 3.0 * x * x, 2.0 * x * y, y * y, 0.0};
}

PlaneCubics::Terms terms_by_y(double x, double y) {
    return {0.0, 0.0, 1.0, 0.0, x, 2.0 * y, 0.0, x * x, 2.0 * x * y, 3.0 * y * y};
}

PlaneValues sum(const std::array<PlaneValues, PlaneCubics::terms>& factor,
                const PlaneCubics::Terms& terms) {
    PlaneValues out(0.0);
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i)
        out += terms[i] * factor[i];
    return out;
}

} // namespace

PlaneValues PlaneCubics::value(double x, double y) const {
    return sum(factor, terms_at(x, y));
}

std::array<PlaneValues, 2> PlaneCubics::slope(double x, double y) const {
    return {sum(factor, terms_by_x(x, y)), sum(factor, terms_by_y(x, y))};
}

void PlaneCubicFit::add_value(double x, double y, const PlaneValues& value) {
    add(terms_at(x, y), value);
}

void PlaneCubicFit::add_slope(double x,
                              double y,
                              const PlaneValues& by_x,
                              const PlaneValues& by_y) {
    add(terms_by_x(x, y), by_x);
    add(terms_by_y(x, y), by_y);
}

void PlaneCubicFit::add(const PlaneCubics::Terms& row, const PlaneValues& value) {
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i) {
        right_[i] += row[i] * value;
        for (std::size_t k = 0; k <= i; ++k)
            matrix_[i][k] += row[i] * row[k];
    }
}

/// Solves by Cholesky's decomposition.
PlaneCubics PlaneCubicFit::solve() const {
    auto lower = matrix_;
    double largest = 0.0;
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i)
        largest = std::max(largest, lower[i][i]);
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i) {
        lower[i][i] += ridge * largest;
        for (std::size_t k = 0; k <= i; ++k) {
            double rest = lower[i][k];
            for (std::size_t j = 0; j < k; ++j)
                rest -= lower[i][j] * lower[k][j];
            lower[i][k] = i == k ? std::sqrt(rest) : rest / lower[k][k];
        }
    }
    PlaneCubics out;
    out.factor = right_;
    for (std::size_t i = 0; i < PlaneCubics::terms; ++i) {
        for (std::size_t j = 0; j < i; ++j)
            out.factor[i] -= lower[i][j] * out.factor[j];
        out.factor[i] /= lower[i][i];
    }
    for (std::size_t i = PlaneCubics::terms; i-- > 0;) {
        for (std::size_t j = i + 1; j < PlaneCubics::terms; ++j)
            out.factor[i] -= lower[j][i] * out.factor[j];
        out.factor[i] /= lower[i][i];
    }
    return out;
}

} // namespace wakesurf::core
