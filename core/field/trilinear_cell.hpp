// Stored data the way a particle meets it: cell by cell. Within a cell the trilinear field is a polynomial, so the
// particle's path has a Taylor series whose terms follow from one another. Across a face the field only is continuous, so a series
// serves up to the face. Source of the recurrences: Hairer, Norsett, Wanner, Solving ODEs I, I.8.
#pragma once

#include "core/field/grid_sampler.hpp"
#include "core/integrate/advance_through_cells.hpp"

#include <array>
#include <cstddef>

namespace wakesurf::core {

/// Coefficients of 1, x, y, xy, z, xz, yz, xyz; x, y, z run from 0 to 1 through the cell.
struct TrilinearPolynomial {
    std::array<std::array<double, 4>, 8> c{}; ///< fourth component unused: pairs of doubles

    TrilinearPolynomial() = default;

    TrilinearPolynomial(const float* velocity,
                        const std::array<std::size_t, 8>& node,
                        const Vec3& scale) {
        for (std::size_t i = 0; i < 8; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                c[i][k] =
                    static_cast<double>(velocity[3 * node[i] + k]) * scale[static_cast<int>(k)];
        for (const std::size_t bit : {1u, 2u, 4u})
            for (std::size_t i = 0; i < 8; ++i)
                if (i & bit)
                    for (std::size_t k = 0; k < 4; ++k)
                        c[i][k] -= c[i ^ bit][k];
    }
};

/// A cursor over the cells of a sampler's grid. Positions within a cell are in units of the cell; time runs in units of the
/// field's, downstream or upstream.
class TrilinearCell {
  public:
    using Index = std::array<std::ptrdiff_t, 3>;

    /// @param sign  +1 downstream, -1 upstream
    TrilinearCell(const GridSampler& field, double sign)
        : field_(field), scale_(sign / field.grid->spacing) {
        const auto& n = field.grid->dimensions;
        cells_ = {std::ptrdiff_t{n[0]} - 1, std::ptrdiff_t{n[1]} - 1, std::ptrdiff_t{n[2]} - 1};
        rate_ = field.velocity1 ? sign / field.interval : 0.0;
    }

    Index index_of(const Vec3& p) const {
        Index index;
        for (int axis = 0; axis < 3; ++axis) {
            const double x = (p[axis] - field_.grid->origin[axis]) / field_.grid->spacing[axis];
            const auto i = static_cast<std::size_t>(axis);
            index[i] = std::clamp(static_cast<std::ptrdiff_t>(x), std::ptrdiff_t{0}, cells_[i] - 1);
        }
        return index;
    }

    bool inside(const Index& index) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (index[i] < 0 || index[i] >= cells_[i])
                return false;
        return true;
    }

    void enter(const Index& index) {
        const auto dy = static_cast<std::ptrdiff_t>(field_.grid->dimensions[0]);
        const auto dz = dy * static_cast<std::ptrdiff_t>(field_.grid->dimensions[1]);
        const auto node = static_cast<std::size_t>(index[0] + dy * index[1] + dz * index[2]);
        if (node == node_)
            return;
        node_ = node;
        const auto y = static_cast<std::size_t>(dy);
        const auto z = static_cast<std::size_t>(dz);
        const std::array<std::size_t, 8> corner{node,         node + 1,        node + y,
                                                node + y + 1, node + z,        node + z + 1,
                                                node + z + y, node + z + y + 1};
        now_ = TrilinearPolynomial(field_.velocity0, corner, scale_);
        if (field_.velocity1) {
            change_ = TrilinearPolynomial(field_.velocity1, corner, scale_);
            for (std::size_t i = 0; i < 8; ++i)
                for (std::size_t k = 0; k < 4; ++k)
                    change_.c[i][k] -= now_.c[i][k];
        }
        lo_ = field_.grid->origin + field_.grid->spacing * Vec3(index[0], index[1], index[2]);
    }

    const Vec3& lo() const { return lo_; }

    const Vec3& size() const { return field_.grid->spacing; }

    /// False: all of the cell is fluid.
    bool obstacle() const { return field_.cells->state(node_) != CellMask::Fluid; }

    /// The path of a particle at `u` in the cell at field time `t`.
    PathSeries series(const Vec3& u, double t) const {
        return rate_ == 0.0 ? expand<false>(u, 0.0)
                            : expand<true>(u, (t - field_.time0) / field_.interval);
    }

  private:
    template <bool Unsteady>
    PathSeries expand(const Vec3& u, double part) const {
        PathSeries path;
        auto& a = path.term;
        for (std::size_t k = 0; k < 3; ++k)
            a[0][k] = u[static_cast<int>(k)];
        a[0][3] = 0.0;
        double xy[5], xz[5], yz[5], xyz[5];
        std::array<double, 4> changed{};
        for (std::size_t order = 0; order < 5; ++order) {
            xy[order] = xz[order] = yz[order] = xyz[order] = 0.0;
            for (std::size_t j = 0; j <= order; ++j) {
                xy[order] += a[j][0] * a[order - j][1];
                xz[order] += a[j][0] * a[order - j][2];
                yz[order] += a[j][1] * a[order - j][2];
            }
            for (std::size_t j = 0; j <= order; ++j)
                xyz[order] += xy[j] * a[order - j][2];
            const double m[7] = {a[order][0], a[order][1], xy[order], a[order][2],
                                 xz[order],   yz[order],   xyz[order]};
            std::array<double, 4> v = sum(now_, m, order == 0);
            if constexpr (Unsteady) {
                const std::array<double, 4> change = sum(change_, m, order == 0);
                for (std::size_t k = 0; k < 4; ++k)
                    v[k] += part * change[k] + rate_ * changed[k];
                changed = change;
            }
            const double share = 1.0 / static_cast<double>(order + 1);
            for (std::size_t k = 0; k < 4; ++k)
                a[order + 1][k] = v[k] * share;
        }
        return path;
    }

    static std::array<double, 4>
    sum(const TrilinearPolynomial& p, const double (&m)[7], bool constant) {
        std::array<double, 4> v;
        for (std::size_t k = 0; k < 4; ++k)
            v[k] = (constant ? p.c[0][k] : 0.0) + (p.c[1][k] * m[0] + p.c[2][k] * m[1]) +
                   (p.c[3][k] * m[2] + p.c[4][k] * m[3]) + (p.c[5][k] * m[4] + p.c[6][k] * m[5]) +
                   p.c[7][k] * m[6];
        return v;
    }

    const GridSampler& field_;
    Vec3 scale_;
    Index cells_;
    double rate_;
    std::size_t node_ = ~std::size_t{0};
    Vec3 lo_{0.0};
    TrilinearPolynomial now_, change_;
};

/// A sampler whose curves are traced cell by cell.
struct CellwiseSampler : GridSampler {
    TrilinearCell cells(double sign) const { return TrilinearCell(*this, sign); }
};

} // namespace wakesurf::core
