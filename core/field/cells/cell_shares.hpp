// How much of each node of a cell the value at a place in it is made of.
#pragma once

#include "core/field/cells/cell_geometry.hpp"
#include "core/field/node_shares.hpp"

namespace wakesurf::core {

/// @param geometry  the cell's
inline NodeShares
shares_in_cell(const MeshCell& cell, const CellGeometry& geometry, const Vec3& local) {
    NodeShares shares;
    shares.status = PointStatus::Inside;
    shares.count = node_count(cell.shape);
    for (std::size_t i = 0; i < shares.count; ++i) {
        // What the node's value is multiplied by is what a field returns that is one there and zero at the others.
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
