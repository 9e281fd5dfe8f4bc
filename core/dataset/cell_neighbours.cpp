#include "core/dataset/cell_neighbours.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

namespace wakesurf::core {

namespace {

constexpr std::uint32_t no_node = 0xffffffffu;

/// A face as one number: the cell's times eight, plus its own.
using FaceNumber = std::uint32_t;

bool has_area(const std::array<std::uint32_t, 4>& nodes) {
    return nodes[2] != no_node;
}

/// The faces whose lowest node is k are those from first[k] to first[k + 1], by cell.
struct FacesByNode {
    std::vector<std::size_t> first;
    std::vector<FaceNumber> face;
};

template <class Visit>
void visit_faces(const CellMesh& mesh, const Visit& visit) {
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
        for (std::size_t f = 0; f < face_count(mesh.cells[i].shape); ++f)
            if (const auto nodes = face_nodes(mesh.cells[i], f); has_area(nodes))
                visit(nodes[0], static_cast<FaceNumber>(8 * i + f));
}

FacesByNode faces_by_node(const CellMesh& mesh) {
    FacesByNode faces;
    faces.first.assign(mesh.points.size() + 2, 0);
    visit_faces(mesh, [&](std::uint32_t node, FaceNumber) { ++faces.first[node + 2]; });
    for (std::size_t k = 2; k < faces.first.size(); ++k)
        faces.first[k] += faces.first[k - 1];
    faces.face.resize(faces.first.back());
    visit_faces(mesh, [&](std::uint32_t node, FaceNumber face) {
        faces.face[faces.first[node + 1]++] = face;
    });
    return faces;
}

struct Candidate {
    std::array<std::uint32_t, 4> nodes;
    FaceNumber face;

    bool operator<(const Candidate& other) const {
        return nodes != other.nodes ? nodes < other.nodes : face < other.face;
    }
};

/// Of faces sorted by nodes and number. Two faces of one cell are no neighbours.
void join(std::vector<MeshCell>& cells, const std::vector<Candidate>& faces) {
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1;
        std::size_t other = 0;
        for (; end < faces.size() && faces[end].nodes == faces[i].nodes; ++end)
            if (other == 0 && faces[end].face / 8 != faces[i].face / 8)
                other = end;
        if (other != 0) {
            const FaceNumber a = faces[i].face;
            const FaceNumber b = faces[other].face;
            cells[a / 8].beyond[a % 8] = b / 8;
            cells[b / 8].beyond[b % 8] = a / 8;
        }
        i = end;
    }
}

} // namespace

std::array<std::uint32_t, 4> face_nodes(const MeshCell& cell, std::size_t number) {
    const CellFace corners = face(cell.shape, number);
    std::array<std::uint32_t, 4> nodes{no_node, no_node, no_node, no_node};
    for (std::size_t i = 0; i < corners.count; ++i)
        nodes[i] = cell.node[corners.node[i]];
    std::sort(nodes.begin(), nodes.end());
    std::fill(std::unique(nodes.begin(), nodes.end()), nodes.end(), no_node);
    return nodes;
}

void connect_cells(CellMesh& mesh) {
    if (mesh.cells.size() > (std::size_t{1} << 29))
        throw std::length_error("a mesh has at most 2^29 cells");
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.cells.size()), [&](const auto& some) {
        for (std::size_t i = some.begin(); i != some.end(); ++i) {
            MeshCell& cell = mesh.cells[i];
            for (std::size_t k = 0; k < node_count(cell.shape); ++k)
                if (cell.node[k] >= mesh.points.size())
                    throw std::out_of_range("a cell's node has no point");
            cell.beyond.fill(beyond_domain);
        }
    });
    const FacesByNode faces = faces_by_node(mesh);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, mesh.points.size(), 4096), [&](const auto& some) {
            std::vector<Candidate> candidates;
            for (std::size_t node = some.begin(); node != some.end(); ++node) {
                candidates.clear();
                for (std::size_t i = faces.first[node]; i < faces.first[node + 1]; ++i)
                    candidates.push_back(
                        {face_nodes(mesh.cells[faces.face[i] / 8], faces.face[i] % 8),
                         faces.face[i]});
                std::sort(candidates.begin(), candidates.end());
                join(mesh.cells, candidates);
            }
        });
}

std::vector<BoundaryFace> boundary_faces(const CellMesh& mesh) {
    std::vector<BoundaryFace> found;
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
        for (std::size_t f = 0; f < face_count(mesh.cells[i].shape); ++f)
            if (mesh.cells[i].beyond[f] >= beyond_wall && has_area(face_nodes(mesh.cells[i], f)))
                found.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(f)});
    return found;
}

} // namespace wakesurf::core
