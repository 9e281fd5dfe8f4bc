// One cell's map from local coordinates to space, and its inverse by Newton's iteration. The inverse of the
// Jacobian is kept from point to point: successive points are close to each other, so most take one or two
// corrections with the same matrix. In parallelepipeds and tetrahedra the first is exact.
#pragma once

#include "core/base/node_shares.hpp"
#include "core/field/cells/cell_polynomial.hpp"
#include "core/field/cells/local_coordinates.hpp"

#include <cmath>
#include <limits>

namespace wakesurf::core {

class CellGeometry {
  public:
    void enter(const CellMesh& mesh, std::uint32_t number) {
        const MeshCell& cell = mesh.cells[number];
        shape_ = cell.shape;
        // Relative to a node: differences of nodes are exact, or nearly.
        origin_ = mesh.points[cell.node[0]];
        position_.fit(
            shape_, [&](std::size_t i) { return Components(mesh.points[cell.node[i]] - origin_); });
        const Vec3 centre = cell_centre(shape_);
        solved_ = Vec3(std::numeric_limits<double>::quiet_NaN());
        const auto side = position_.slopes(pyramid(), centre);
        least_volume_ = 1e-10 * glm::length(side[0].vector()) * glm::length(side[1].vector()) *
                        glm::length(side[2].vector());
        flat_ = !turn_round(centre);
        if (flat_)
            return;
        least_volume_ *= 1e-4; // towards sides that are collapsed to a line
        bend_ = 0.0;
        for (const std::size_t k : {3u, 5u, 6u, 7u})
            bend_ += largest(inverse_ * position_.c[k].vector());
        linear_ = bend_ < 1e-13;
    }

    CellShape shape() const { return shape_; }

    bool pyramid() const { return shape_ == CellShape::Pyramid; }

    /// True where the cell has no volume to speak of, or coordinates that are no numbers: it contains
    /// nothing, and nothing else may be asked of it.
    bool flat() const { return flat_; }

    /// Returns true if a test from the centre shows that the cell does not contain `p`. Call it first for a
    /// cell that has just been entered and is not flat.
    bool surely_outside(const Vec3& p) const {
        const Vec3 centre = turned_;
        const Vec3 change = inverse_ * (p - origin_ - position_.at(pyramid(), centre).vector());
        const auto beyond = beyond_faces(shape_, centre + change);
        // The Jacobian's change on the way from the centre to anywhere in the cell hides a quarter of this.
        return *std::max_element(beyond.begin(), beyond.end()) > bend_ + face_tolerance;
    }

    /// Finds the local coordinates of a point. Where the point is outside they may only give the direction.
    /// @param u  a guess; clamped to the cell where it is far outside Returns false where the iteration did
    ///           not end, which says that the point is outside of all but very distorted cells.
    bool invert(const Vec3& p, Vec3& u) {
        const Vec3 relative = p - origin_;
        if (linear_) {
            u = inverse_ * relative; // node 0 is the origin of both
            return true;
        }
        // The residual at the last solution is known.
        Vec3 residual =
            relative - (u == solved_ ? solved_at_ : position_.at(pyramid(), u).vector());
        double error = 0.0; // what is left, about
        double before = 1e300;
        for (int i = 0; i < 16; ++i) {
            double far = largest(u - turned_);
            // A new matrix costs as much as two corrections with the old one.
            if (far * bend_ > 0.03 || error * far * bend_ > precise) {
                if (!turn_round(u))
                    return !(largest(residual) > 1e-12 * largest(position_.c[4].vector()));
                far = 0.0;
            }
            const Vec3 change = inverse_ * residual;
            u += change;
            const double step = largest(change);
            // The Jacobian's change on the way, and no more than the last step shows.
            error = bend_ * (far + step) * step;
            if (step <= 1e-14 || (error <= precise && step <= 0.5 * before)) {
                solved_ = u;
                solved_at_ = relative;
                return true;
            }
            before = step;
            if (!(step <= 0.5)) {
                if (!(step <= 1e3))
                    break;
                u = glm::clamp(u, Vec3(-2.0), Vec3(3.0));
            }
            residual = relative - position_.at(pyramid(), u).vector();
        }
        return false;
    }

    /// Returns the change of the local coordinates along `w` at `u`.
    Vec3 along(const Vec3& u, const Vec3& w) {
        if (!linear_ && largest(u - turned_) > 0.0)
            turn_round(u);
        return inverse_ * w;
    }

    Vec3 position(const Vec3& u) const { return origin_ + position_.at(pyramid(), u).vector(); }

    const CellPolynomial& polynomial() const { return position_; }

    const Vec3& origin() const { return origin_; }

  private:
    static constexpr double precise = 1e-13; ///< of local coordinates

    /// The rows of the Jacobian's inverse.
    struct Inverse {
        Vec3 u, v, w;

        Vec3 operator*(const Vec3& x) const {
            return {glm::dot(u, x), glm::dot(v, x), glm::dot(w, x)};
        }
    };

    static double largest(const Vec3& x) {
        return std::max(std::max(std::abs(x.x), std::abs(x.y)), std::abs(x.z));
    }

    /// Computes the inverse at `u`. Returns false, and leaves it, where there is no volume.
    bool turn_round(const Vec3& u) {
        const auto slope = position_.slopes(pyramid(), u);
        const Vec3 a = slope[0].vector(), b = slope[1].vector(), c = slope[2].vector();
        const Vec3 bc = glm::cross(b, c);
        const double volume = glm::dot(a, bc);
        const double scale = 1.0 / volume;
        if (!(std::abs(volume) > least_volume_ && std::abs(scale) < 1e300))
            return false;
        inverse_ = {scale * bc, scale * glm::cross(c, a), scale * glm::cross(a, b)};
        turned_ = u;
        return true;
    }

    CellPolynomial position_; ///< relative to the origin
    Inverse inverse_;
    Vec3 origin_{0.0};
    Vec3 turned_{0.0}; ///< where the inverse is that of
    Vec3 solved_{0.0}; ///< the last solution, and the point it is for, relative to the origin
    Vec3 solved_at_{0.0};
    double least_volume_ = 0.0;
    double bend_ = 0.0; ///< by how much, about, the Jacobian changes from side to side
    CellShape shape_ = CellShape::Tetrahedron;
    bool linear_ = false;
    bool flat_ = true;
};

/// Returns the weights of a cell's nodes in the value at a point in it. @param geometry  the cell's
inline NodeShares
shares_in_cell(const MeshCell& cell, const CellGeometry& geometry, const Vec3& local) {
    NodeShares shares;
    shares.status = PointStatus::Inside;
    shares.count = node_count(cell.shape);
    for (std::size_t i = 0; i < shares.count; ++i) {
        // The weight of node i is the interpolant of the field that is 1 at i and 0 elsewhere.
        CellPolynomial one_here;
        one_here.fit(cell.shape, [&](std::size_t node) {
            Components value;
            value.z[0] = node == i ? 1.0 : 0.0;
            return value;
        });
        shares.node[i] = cell.node[i];
        shares.share[i] = one_here.at(geometry.pyramid(), local).z[0];
    }
    return shares;
}

} // namespace wakesurf::core
