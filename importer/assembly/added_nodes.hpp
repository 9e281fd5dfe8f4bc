// Nodes a mesh has besides the points of its source: the apex of a polyhedron, the centre of a face of five
// corners or more. Their values are weighted means of other nodes'.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wakesurf::importer {

/// Holds the added nodes: node i has the number `nodes of the source` + i and the parts first[i] .. first[i +
/// 1].
struct AddedNodes {
    std::vector<std::size_t> first{0};
    std::vector<std::uint32_t> node; ///< of the source
    std::vector<double> weight;      ///< of a node's parts: sums to 1

    std::size_t size() const { return first.size() - 1; }
};

} // namespace wakesurf::importer
