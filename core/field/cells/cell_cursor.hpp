// Follows one particle from cell to cell: the same cell, else the cell beyond the face the point is farthest
// beyond, else the locator's. Outside of all it stays in the last cell, at the nearest place in it. Where it
// begins, beyond by rounding is inside.
#pragma once

#include "core/base/point_status.hpp"
#include "core/field/cells/cell_domain.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace wakesurf::core {

/// Follows one particle on one thread. Answers depend on the points asked before only to rounding, and at
/// walls, which the cursor does not pass. Cost: 50 ns where the point is in the same cell, 150 more for
/// another one, 1 us for the locator.
class CellCursor {
  public:
    static constexpr std::uint32_t nowhere = BoxTree::none();

    explicit CellCursor(const CellDomain& domain) : domain_(&domain) {}

    /// @param stays  the particle has come to `p`: walls are tested from there on. Else it only asks.
    /// @param usable  usable(cell): false where the cell has no velocity, which is outside
    template <class Usable>
    PointStatus locate(const Vec3& p, bool stays, const Usable& usable) {
        if (!(p == asked_)) {
            asked_ = p;
            on_side_ = false;
            status_ = search(p, usable);
        }
        if (status_ == PointStatus::Inside && (stays || anchor_cell_ == nowhere)) {
            anchor_ = on_side();
            anchor_cell_ = cell_;
        }
        return status_;
    }

    /// Returns the last point, or the place on the side that a particle slides along if it was beyond that by rounding.
    Vec3 on_side() const { return on_side_ ? here_.position(local_) : asked_; }

    /// Begins with another particle: it answers as a new cursor, to the bit unless cells overlap, but finds
    /// the first point at once where that is well inside one cell.
    /// @param guess  that cell; `nowhere`: the one in which the particle before began
    void restart(std::uint32_t guess = nowhere) {
        if (domain_->one_piece && guess != begun_ && guess < domain_->mesh.cells.size())
            entered_.enter(domain_->mesh, begun_ = guess);
        cell_ = anchor_cell_ = nowhere;
        asked_ = Vec3(std::numeric_limits<double>::quiet_NaN());
        status_ = PointStatus::OutsideDomain;
    }

    /// Returns the cell of the last point, or for one outside that of the nearest place in the last cell. It
    /// is `nowhere` before the first.
    std::uint32_t cell() const { return cell_; }

    const Vec3& local() const { return local_; }

    CellGeometry& geometry() { return here_; }

    const CellGeometry& geometry() const { return here_; }

  private:
    static constexpr int most_moves = 32;

    /// Compares along each axis.
    static bool within(const Vec3& by, const Vec3& most) {
        return std::abs(by.x) <= most.x && std::abs(by.y) <= most.y && std::abs(by.z) <= most.z;
    }

    /// Says whether a point is no farther out than rounding.
    bool beside(const Vec3& off) const {
        return within(off, domain_->rounding) || glm::length(off) <= domain_->rounding_across;
    }

    template <class Usable>
    PointStatus search(const Vec3& p, const Usable& usable) {
        if (!finite(p))
            return PointStatus::OutsideDomain;
        if (cell_ == nowhere)
            return begin(p, usable);
        Vec3 u = local_;
        if (here_.invert(p, u) && inside_cell(here_.shape(), u)) {
            if (through_wall(cell_, p))
                return PointStatus::InObstacle; // the cell is bent round the wall's end
            local_ = u;
            return PointStatus::Inside;
        }
        local_ = clamp_to_cell(here_.shape(), u);
        return walk(p, u, usable, true);
    }

    /// Walks from the present cell, where `p` is at `u`, outside. @param elsewhere  false: the locator knows
    /// it in no cell
    template <class Usable>
    PointStatus walk(const Vec3& p, Vec3 u, const Usable& usable, bool elsewhere) {
        PointStatus beyond = PointStatus::OutsideDomain;
        std::uint32_t at = cell_;
        std::uint32_t before = nowhere;
        CellShape shape = here_.shape();
        bool border = false;
        for (int moves = 0; moves < most_moves; ++moves) {
            const std::uint32_t next = domain_->mesh.cells[at].beyond[most_violated(shape, u)];
            border = next >= beyond_wall;
            if (border)
                beyond = next == beyond_wall ? PointStatus::InObstacle : PointStatus::OutsideDomain;
            if (border || next == before) // to and fro: no way
                break;
            before = at;
            at = next;
            there_.enter(domain_->mesh, at);
            if (there_.flat())
                break;
            shape = there_.shape();
            u = cell_centre(shape);
            if (there_.invert(p, u) && inside_cell(shape, u))
                return move({at, u}, p, usable);
        }
        const CellPlace edge{at, u};
        // A cursor without a path searches from the nearest place in the last cell.
        const Vec3 from = anchor_cell_ != nowhere ? anchor_ : here_.position(local_);
        const bool crossed = !domain_->walls.empty() && domain_->walls.crossed(from, p);
        if (elsewhere && !crossed) {
            if (const auto found = domain_->locator.find(p, there_))
                return move(*found, p, usable);
            if (const auto found = across_crack(p, from))
                return move(*found, p, usable);
        }
        if (border && elsewhere && usable(at) && slides(edge, p, from))
            return PointStatus::Inside;
        if (border && at != cell_ &&
            usable(at)) { // the velocity continues from where the walk ended
            here_.enter(domain_->mesh, at);
            cell_ = at;
            local_ = clamp_to_cell(shape, edge.local);
        }
        return crossed ? PointStatus::InObstacle : beyond;
    }

    /// Goes to the nearest place in the last cell of a walk, if the particle leaves that by no more than 32-bit points and
    /// velocities are rounded by: along a side that is parallel to no axis they point out of the fluid as often as into
    /// it. A particle that does leave is a step later farther out than that.
    bool slides(const CellPlace& edge, const Vec3& p, const Vec3& from) {
        CellGeometry& cell = edge.cell == cell_ ? here_ : there_;
        if (edge.cell != cell_)
            cell.enter(domain_->mesh, edge.cell);
        const Vec3 nearest = clamp_to_cell(cell.shape(), edge.local);
        const Vec3 off = p - cell.position(nearest);
        const double size = glm::length(cell.position(clamp_to_cell(cell.shape(), Vec3(1.0))) -
                                        cell.position(Vec3(0.0)));
        const double slope = 0x1p-20 + glm::length(domain_->rounding) / size;
        if (!beside(off) || !(glm::length(off) <= slope * glm::length(p - from)))
            return false;
        if (edge.cell != cell_)
            std::swap(here_, there_);
        cell_ = edge.cell;
        local_ = nearest;
        on_side_ = true;
        return true;
    }

    /// The nearest place in the cell beyond a crack as wide as a rounding, in which `p` is: cells of
    /// different sizes that meet leave some, as the nodes of the small ones are not those of the large ones.
    /// @param from  where the particle comes from
    std::optional<CellPlace> across_crack(const Vec3& p, const Vec3& from) {
        const Vec3 widest = 2.0 * domain_->rounding;
        for (const Vec3& way : {p - here_.position(local_), p - from}) {
            const Vec3 parts = glm::abs(way) / widest;
            const double longest = std::max(std::max(parts.x, parts.y), parts.z);
            if (!(longest > 0.0))
                continue;
            const Vec3 beyond = p + way / longest;
            auto found = domain_->locator.find(beyond, there_);
            if (!found || (!domain_->walls.empty() && domain_->walls.crossed(from, beyond)))
                continue;
            there_.invert(p, found->local);
            found->local = clamp_to_cell(there_.shape(), found->local);
            if (within(there_.position(found->local) - p, widest))
                return found;
        }
        return std::nullopt;
    }

    template <class Usable>
    PointStatus begin(const Vec3& p, const Usable& usable) {
        if (begun_ != nowhere) {
            CellPlace place{begun_, {}};
            there_ = entered_;
            if (contains(there_, p, place.local) && well_inside_cell(there_.shape(), place.local))
                return move(place, p, usable);
        }
        if (auto found = domain_->locator.find(p, there_)) {
            // Entered again, so that later results do not depend on the cells that were searched before.
            entered_.enter(domain_->mesh, found->cell);
            there_ = entered_;
            contains(there_, p, found->local);
            begun_ = domain_->one_piece ? found->cell : nowhere;
            return move(*found, p, usable);
        }
        const auto near = domain_->locator.near(p);
        if (!near || !usable(*near))
            return PointStatus::OutsideDomain;
        here_.enter(domain_->mesh, *near);
        if (here_.flat())
            return PointStatus::OutsideDomain;
        cell_ = *near;
        Vec3 u = cell_centre(here_.shape());
        here_.invert(p, u);
        local_ = clamp_to_cell(here_.shape(), u);
        const PointStatus met = walk(p, u, usable, false);
        on_side_ = beside(p - here_.position(local_));
        return on_side_ ? PointStatus::Inside : met;
    }

    /// Takes the place that `there_` is the geometry of, unless something is in the way.
    template <class Usable>
    PointStatus move(const CellPlace& place, const Vec3& p, const Usable& usable) {
        if (!usable(place.cell))
            return PointStatus::OutsideDomain;
        if (through_wall(place.cell, p))
            return PointStatus::InObstacle;
        std::swap(here_, there_);
        cell_ = place.cell;
        local_ = place.local;
        return PointStatus::Inside;
    }

    /// Returns whether the way from the anchor to `p` in `cell` goes through a wall. It is seldom asked: not
    /// within a cell, nor between two that share a face, unless a wall begins at one of their nodes.
    bool through_wall(std::uint32_t cell, const Vec3& p) const {
        const CellWalls& walls = domain_->walls;
        if (walls.empty() || anchor_cell_ == nowhere || anchor_cell_ == cell)
            return false;
        if (!walls.beside(anchor_cell_) && !walls.beside(cell))
            for (const std::uint32_t next : domain_->mesh.cells[anchor_cell_].beyond)
                if (next == cell)
                    return false;
        return walls.crossed(into(anchor_cell_, anchor_), into(cell, p));
    }

    /// A place farther into a cell by rounding: a way along a wall does not go through it.
    Vec3 into(std::uint32_t number, const Vec3& p) const {
        const MeshCell& cell = domain_->mesh.cells[number];
        const std::size_t nodes = node_count(cell.shape);
        Vec3 centre(0.0);
        for (std::size_t i = 0; i < nodes; ++i)
            centre += domain_->mesh.points[cell.node[i]] / static_cast<double>(nodes);
        const double far = glm::length(centre - p);
        return p + std::min(1.0, 2.0 * glm::length(domain_->rounding) / far) * (centre - p);
    }

    const CellDomain* domain_;
    std::uint32_t cell_ = nowhere;
    std::uint32_t anchor_cell_ = nowhere; ///< where the particle last stayed
    std::uint32_t begun_ = nowhere; ///< the first cell to search for the beginning of a particle
    Vec3 local_{0.0};
    Vec3 anchor_{0.0};
    Vec3 asked_{std::numeric_limits<double>::quiet_NaN()};
    PointStatus status_ = PointStatus::OutsideDomain;
    bool on_side_ = false; ///< the last point is taken for that at `local_`
    CellGeometry here_;
    CellGeometry there_;
    CellGeometry entered_; ///< of `begun_`, as it was before any point
};

} // namespace wakesurf::core
