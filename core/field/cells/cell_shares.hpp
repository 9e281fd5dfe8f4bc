// The weights of a cell's nodes in the value at a point in it.
#pragma once

#include "core/base/node_shares.hpp"
#include "core/field/cells/cell_geometry.hpp"

namespace wakesurf::core {

/// @param geometry  the cell's
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
