// A stream surface as it grows: its vertices in the order of their time since release, so that any first part of them is a surface
// on its way to the whole.
#pragma once

#include "core/surface/keyed_mesh.hpp"
#include "protocol/wire_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace wakesurf::bench {

class RowByRow {
  public:
    explicit RowByRow(core::QuadComplex mesh)
        : mesh_(std::move(mesh)), order_(mesh_.vertices()), newest_(mesh_.cells.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        std::ranges::sort(order_, {},
                          [&](core::VertexId v) { return std::pair(mesh_.t[v], mesh_.s[v]); });
        rank_.resize(order_.size());
        for (std::uint32_t i = 0; i < order_.size(); ++i)
            rank_[order_[i]] = i;
        cell_order_.resize(mesh_.cells.size());
        std::iota(cell_order_.begin(), cell_order_.end(), 0u);
        for (std::size_t i = 0; i < newest_.size(); ++i) {
            const core::CellPolygon outline = core::polygon(mesh_.cells[i]);
            for (std::uint32_t k = 0; k < outline.count; ++k)
                newest_[i] = std::max(newest_[i], rank_[outline.vertex[k]]);
        }
        std::ranges::stable_sort(cell_order_, {}, [&](std::uint32_t i) { return newest_[i]; });
    }

    std::size_t vertices() const { return order_.size(); }

    /// The surface of about the first so many vertices, with lasting ids.
    core::KeyedMesh first(std::size_t count) const {
        core::KeyedMesh part;
        for (std::size_t i = 0; i < count; ++i) {
            part.vertex_id.push_back(static_cast<std::uint32_t>(i));
            part.mesh.position.push_back(mesh_.position[order_[i]]);
            part.mesh.s.push_back(mesh_.s[order_[i]]);
            part.mesh.t.push_back(mesh_.t[order_[i]]);
            part.mesh.velocity.push_back(mesh_.velocity[order_[i]]);
        }
        for (std::uint32_t i = 0; i < cell_order_.size() && newest_[cell_order_[i]] < count; ++i) {
            core::Cell cell = mesh_.cells[cell_order_[i]];
            for (auto* vertices : {&cell.corner, &cell.mid})
                for (core::VertexId& v : *vertices)
                    v = v == core::no_vertex ? v : rank_[v];
            part.cell_id.push_back(i);
            part.mesh.cells.push_back(cell);
        }
        return part;
    }

    /// Of speed, s and t of all of it.
    std::vector<protocol::AttributeRange> ranges() const {
        double fastest = 0.0;
        for (core::VertexId v = 0; v < mesh_.vertices(); ++v)
            fastest = std::max(fastest, mesh_.speed(v));
        return {{0.0f, static_cast<float>(fastest)},
                {0.0f, 1.0f},
                {static_cast<float>(std::ranges::min(mesh_.t)),
                 static_cast<float>(std::ranges::max(mesh_.t))}};
    }

  private:
    core::QuadComplex mesh_;
    std::vector<core::VertexId> order_, rank_;
    std::vector<std::uint32_t> newest_; ///< rank of a cell's newest vertex
    std::vector<std::uint32_t> cell_order_;
};

} // namespace wakesurf::bench
