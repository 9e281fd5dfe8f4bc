#include "core/surface/patches/side_table.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

template <class Visit>
void for_each_piece(const QuadComplex& mesh, const Visit& visit) {
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        for (std::uint32_t i = 0; i < outline.count; ++i) {
            const VertexId a = outline.vertex[i], b = outline.vertex[(i + 1) % outline.count];
            visit(std::min(a, b), std::max(a, b));
        }
    }
}

} // namespace

SideTable::SideTable(const QuadComplex& mesh) {
    std::vector<std::uint32_t> begin(mesh.vertices() + 1, 0);
    for_each_piece(mesh, [&](VertexId a, VertexId) { ++begin[a + 1]; });
    for (std::size_t v = 1; v < begin.size(); ++v)
        begin[v] += begin[v - 1];
    std::vector<VertexId> all(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for_each_piece(mesh, [&](VertexId a, VertexId b) { all[next[a]++] = b; });
    first_.assign(begin.size(), 0);
    for (VertexId a = 0; a < mesh.vertices(); ++a) {
        const auto from = all.begin() + begin[a], to = all.begin() + begin[a + 1];
        std::sort(from, to);
        for (auto each = from; each != to; ++each)
            if (each != from && *each == to_.back())
                ++cells_.back();
            else {
                to_.push_back(*each);
                cells_.push_back(1);
            }
        first_[a + 1] = static_cast<std::uint32_t>(to_.size());
    }
}

std::size_t SideTable::number(VertexId a, VertexId b) const {
    const VertexId low = std::min(a, b), high = std::max(a, b);
    std::size_t k = first_[low];
    while (to_[k] != high)
        ++k;
    return k;
}

} // namespace wakesurf::core
