// The parts of a quad complex and the curves that bound it, by edges: parts that touch only at a vertex are
// separate.
#pragma once

#include "core/surface/quad_complex.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace wakesurf::tests {

/// Holds the edges of all cells, so that each finds its reverse.
class DirectedEdges {
  public:
    explicit DirectedEdges(const core::QuadComplex& mesh) {
        for (std::uint32_t c = 0; c < mesh.cells.size(); ++c) {
            const core::CellPolygon outline = core::polygon(mesh.cells[c]);
            for (std::uint32_t i = 0; i < outline.count; ++i)
                all_.push_back({outline.vertex[i], outline.vertex[(i + 1) % outline.count], c});
        }
        std::sort(all_.begin(), all_.end());
    }

    struct Edge {
        core::VertexId from, to;
        std::uint32_t cell;

        auto operator<=>(const Edge&) const = default;
    };

    const std::vector<Edge>& all() const { return all_; }

    /// Returns the edge between two vertices; null if there is none.
    const Edge* find(core::VertexId from, core::VertexId to) const {
        const auto at = std::lower_bound(all_.begin(), all_.end(), Edge{from, to, 0});
        return at != all_.end() && at->from == from && at->to == to ? &*at : nullptr;
    }

    bool border(const Edge& edge) const { return find(edge.to, edge.from) == nullptr; }

    std::size_t index(const Edge& edge) const {
        return static_cast<std::size_t>(&edge - all_.data());
    }

  private:
    std::vector<Edge> all_;
};

/// Returns the edges that only one cell has.
inline std::vector<std::pair<core::VertexId, core::VertexId>>
border_edges(const core::QuadComplex& mesh) {
    const DirectedEdges edges(mesh);
    std::vector<std::pair<core::VertexId, core::VertexId>> border;
    for (const auto& edge : edges.all())
        if (edges.border(edge))
            border.emplace_back(edge.from, edge.to);
    return border;
}

/// Returns the number of quads of each part of the surface that is connected by edges; parts that touch at a
/// vertex are two.
inline std::vector<std::size_t> component_sizes(const core::QuadComplex& mesh) {
    const DirectedEdges edges(mesh);
    std::vector<std::uint32_t> parent(mesh.cells.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t c) {
        while (parent[c] != c)
            c = parent[c] = parent[parent[c]];
        return c;
    };
    for (const auto& edge : edges.all())
        if (const auto* back = edges.find(edge.to, edge.from))
            parent[root(edge.cell)] = root(back->cell);
    std::vector<std::size_t> quads(mesh.cells.size(), 0);
    for (std::uint32_t c = 0; c < mesh.cells.size(); ++c)
        ++quads[root(c)];
    std::erase(quads, 0u);
    return quads;
}

/// Counts the closed curves of the border; two that touch at a vertex are two.
inline std::size_t border_loops(const core::QuadComplex& mesh) {
    const DirectedEdges edges(mesh);
    const auto after = [&](const DirectedEdges::Edge& edge) {
        const core::CellPolygon outline = core::polygon(mesh.cells[edge.cell]);
        const auto at = static_cast<std::size_t>(
            std::find(outline.vertex.begin(), outline.vertex.end(), edge.to) -
            outline.vertex.begin());
        return edges.find(edge.to, outline.vertex[(at + 1) % outline.count]);
    };
    std::vector<bool> seen(edges.all().size(), false);
    std::size_t loops = 0;
    for (const auto& first : edges.all()) {
        if (seen[edges.index(first)] || !edges.border(first))
            continue;
        ++loops;
        const auto* edge = &first;
        while (!seen[edges.index(*edge)]) {
            seen[edges.index(*edge)] = true;
            edge = after(*edge);
            while (const auto* back = edges.find(edge->to, edge->from))
                edge = after(*back);
        }
    }
    return loops;
}

} // namespace wakesurf::tests
