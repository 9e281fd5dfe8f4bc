// Stored data the way a particle meets it: cell by cell. Within a cell the trilinear field is a polynomial,
// so the particle's path has a Taylor series whose terms follow from one another. Across a face the field
// only is continuous, so a series serves up to the face. Source of the recurrences: Hairer, Norsett, Wanner,
// Solving ODEs I, I.8.
#pragma once

#include "core/base/components.hpp"
#include "core/field/grid_sampler.hpp"
#include "core/integrate/path_series.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace wakesurf::core {

/// The coefficients of 1, x, y, xy, z, xz, yz, xyz; x, y, z run from 0 to 1 through the cell.
struct TrilinearPolynomial {
    std::array<Components, 8> c;

    TrilinearPolynomial() = default;

    TrilinearPolynomial(const float* velocity,
                        const std::array<std::size_t, 8>& node,
                        const Vec3& scale) {
        for (std::size_t i = 0; i < 8; ++i) {
            const float* v = velocity + 3 * node[i];
            c[i].xy = Components::Pair{v[0], v[1]} * Components::Pair{scale.x, scale.y};
            c[i].z = Components::Pair{v[2] * scale.z, 0.0};
        }
        for (const std::size_t bit : {1u, 2u, 4u})
            for (std::size_t i = 0; i < 8; ++i)
                if (i & bit)
                    c[i] = c[i] - c[i ^ bit];
    }

    /// Evaluates without the constant: m are the values of x, y, xy, z, xz, yz, xyz.
    Components rest(const double (&m)[7]) const {
        return ((c[1] * m[0] + c[2] * m[1]) + (c[3] * m[2] + c[4] * m[3])) +
               ((c[5] * m[4] + c[6] * m[5]) + c[7] * m[6]);
    }
};

/// Moves over the cells of a sampler's grid. Positions within a cell are in units of the cell; time runs in
/// units of the field's, downstream or upstream.
template <class Grid>
class TrilinearCell {
  public:
    using Index = std::array<std::ptrdiff_t, 3>;

    /// @param sign    +1 downstream, -1 upstream
    /// @param frozen  the field stays as it is at the time series() is asked for
    TrilinearCell(const GridSampler<Grid>& field, double sign, bool frozen)
        : field_(field), sign_(sign) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            cells_[axis] = std::ptrdiff_t{dimensions(*field.grid)[axis]} - 1;
        rate_ = field.velocity1 && !frozen ? sign / field.interval : 0.0;
        measure({0, 0, 0});
    }

    Index index_of(const Vec3& p) const {
        Index index;
        for (std::size_t axis = 0; axis < 3; ++axis)
            index[axis] = static_cast<std::ptrdiff_t>(
                along(*field_.grid, axis, p[static_cast<int>(axis)]).cell);
        return index;
    }

    /// False beyond the border, and where a node has no velocity.
    bool inside(const Index& index) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (index[i] < 0 || index[i] >= cells_[i])
                return false;
        return !field_.gaps || !field_.gap(unsigned_of(index));
    }

    void enter(const Index& index) {
        const auto cell = unsigned_of(index);
        const std::size_t node = field_.first_node(cell);
        if (node == node_)
            return;
        node_ = node;
        cell_ = cell;
        if constexpr (!std::is_same_v<Grid, UniformGrid>)
            measure(cell);
        const auto stored = field_.stored_cell(cell, node);
        const auto corner = cell_nodes(stored.strides, 0);
        now_ = TrilinearPolynomial(field_.at_first(field_.velocity0, stored), corner, scale_);
        if (field_.velocity1) {
            change_ =
                TrilinearPolynomial(field_.at_first(field_.velocity1, stored), corner, scale_);
            for (std::size_t i = 0; i < 8; ++i)
                change_.c[i] = change_.c[i] - now_.c[i];
        }
        lo_ = cell_origin(*field_.grid, cell);
    }

    const Vec3& lo() const { return lo_; }

    const Vec3& size() const { return size_; }

    const Vec3& per_size() const { return per_size_; }

    /// Returns the shortest side, in units of length.
    double finest() const { return finest_; }

    /// Returns false if all of the cell is fluid.
    bool obstacle() const { return field_.cells->state(cell_, node_) != CellMask::Fluid; }

    /// Returns the path of a particle at `u` in the cell at field time `t`.
    PathSeries series(const Vec3& u, double t) const {
        return field_.velocity1 ? expand<true>(u, (t - field_.time0) / field_.interval)
                                : expand<false>(u, 0.0);
    }

  private:
    template <bool Unsteady>
    PathSeries expand(const Vec3& u, double part) const {
        PathSeries path;
        double x[5], y[5], z[5], xy[5], xz[5], yz[5], xyz[5];
        x[0] = u.x;
        y[0] = u.y;
        z[0] = u.z;
        path.term[0] = {u.x, u.y, u.z};
        Components changed;
#pragma GCC unroll 5
        for (std::size_t order = 0; order < 5; ++order) {
            xy[order] = xz[order] = yz[order] = xyz[order] = 0.0;
            for (std::size_t j = 0; j <= order; ++j) {
                xy[order] += x[j] * y[order - j];
                xz[order] += x[j] * z[order - j];
                yz[order] += y[j] * z[order - j];
            }
            for (std::size_t j = 0; j <= order; ++j)
                xyz[order] += xy[j] * z[order - j];
            const double m[7] = {x[order],  y[order],  xy[order], z[order],
                                 xz[order], yz[order], xyz[order]};
            Components v = now_.rest(m);
            if (order == 0)
                v = v + now_.c[0];
            if constexpr (Unsteady) {
                Components change = change_.rest(m);
                if (order == 0)
                    change = change + change_.c[0];
                v = v + change * part + changed * rate_;
                changed = change;
            }
            const Components next = v * (1.0 / static_cast<double>(order + 1));
            path.term[order + 1] = {next.xy[0], next.xy[1], next.z[0]};
            if (order < 4) {
                x[order + 1] = next.xy[0];
                y[order + 1] = next.xy[1];
                z[order + 1] = next.z[0];
            }
        }
        return path;
    }

    static std::array<std::size_t, 3> unsigned_of(const Index& index) {
        return {static_cast<std::size_t>(index[0]), static_cast<std::size_t>(index[1]),
                static_cast<std::size_t>(index[2])};
    }

    void measure(const std::array<std::size_t, 3>& cell) {
        size_ = cell_size(*field_.grid, cell);
        per_size_ = 1.0 / size_;
        scale_ = sign_ / size_;
        finest_ = std::min({size_.x, size_.y, size_.z});
    }

    const GridSampler<Grid>& field_;
    Index cells_;
    double sign_;
    double rate_; ///< of the share of the second time-step; 0: frozen
    Vec3 size_, per_size_, scale_;
    double finest_;
    std::array<std::size_t, 3> cell_{};
    std::size_t node_ = ~std::size_t{0};
    Vec3 lo_{0.0};
    TrilinearPolynomial now_, change_;
};

} // namespace wakesurf::core
