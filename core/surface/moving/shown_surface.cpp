#include "core/surface/moving/shown_surface.hpp"

#include <algorithm>

namespace wakesurf::core {

void mirror_cells(QuadComplex& mesh) {
    for (Cell& cell : mesh.cells)
        cell = mirror(cell);
}

void count(SurfaceStatistics& statistics, const QuadComplex& mesh) {
    statistics.quads = mesh.cells.size();
    statistics.vertices = mesh.vertices();
    statistics.approximated = static_cast<std::uint64_t>(
        std::count(mesh.approximated.begin(), mesh.approximated.end(), 1));
    statistics.max_edge = longest_edge(mesh);
    statistics.error = stated_error(mesh, statistics.separation);
}

} // namespace wakesurf::core
