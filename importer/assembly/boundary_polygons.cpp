#include "importer/assembly/boundary_polygons.hpp"

#include <algorithm>

namespace wakesurf::importer {

std::vector<std::uint32_t>
source_polygon(const GridAssembly& assembly, const core::MeshCell& cell, std::size_t face) {
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t node : core::face_nodes(cell, face)) {
        if (node == no_node)
            break;
        if (node < assembly.source_nodes) {
            nodes.push_back(node);
            continue;
        }
        const std::size_t added = node - assembly.source_nodes;
        const auto at = [&](std::size_t i) {
            return assembly.added.node.begin() +
                   static_cast<std::ptrdiff_t>(assembly.added.first[i]);
        };
        nodes.insert(nodes.end(), at(added), at(added + 1));
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

} // namespace wakesurf::importer
