#include "core/dataset/cell_neighbours.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace wakesurf::core {

namespace {

constexpr std::uint32_t no_node = 0xffffffffu;

/// Numbers a face: eight times the cell's number, plus the face's own.
using FaceNumber = std::uint32_t;

// The faces of the four shapes, in one table because every face of a mesh is looked up several times.
struct FaceTable {
    std::array<std::size_t, 4> count{};
    std::array<std::array<CellFace, 6>, 4> face{};
};

const FaceTable table = [] {
    FaceTable made;
    for (std::size_t shape = 0; shape < made.count.size(); ++shape) {
        made.count[shape] = face_count(static_cast<CellShape>(shape));
        for (std::size_t f = 0; f < made.count[shape]; ++f)
            made.face[shape][f] = face(static_cast<CellShape>(shape), f);
    }
    return made;
}();

std::size_t faces_of(const MeshCell& cell) {
    return table.count[static_cast<std::size_t>(cell.shape)];
}

bool has_area(const std::array<std::uint32_t, 4>& nodes) {
    return nodes[2] != no_node;
}

/// The faces whose lowest node is k are those from first[k] to first[k + 1], by cell.
struct FacesByNode {
    std::vector<std::size_t> first;
    std::vector<FaceNumber> face;
};

/// Calls visit(lowest node, face) for every face, also those without an area.
template <class Visit>
void visit_faces(const CellMesh& mesh, const Visit& visit) {
    for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
        const MeshCell& cell = mesh.cells[i];
        for (std::size_t f = 0; f < faces_of(cell); ++f) {
            const CellFace& corners = table.face[static_cast<std::size_t>(cell.shape)][f];
            std::uint32_t lowest = cell.node[corners.node[0]];
            for (std::size_t k = 1; k < corners.count; ++k)
                lowest = std::min(lowest, cell.node[corners.node[k]]);
            visit(lowest, static_cast<FaceNumber>(8 * i + f));
        }
    }
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

/// Joins cells at faces that are sorted by nodes and number. Two faces of one cell are no neighbours.
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
    const CellFace& corners = table.face[static_cast<std::size_t>(cell.shape)][number];
    std::array<std::uint32_t, 4> nodes{no_node, no_node, no_node, no_node};
    for (std::size_t i = 0; i < corners.count; ++i)
        nodes[i] = cell.node[corners.node[i]];
    const auto order = [&](std::size_t a, std::size_t b) {
        const auto [low, high] =
            std::pair(std::min(nodes[a], nodes[b]), std::max(nodes[a], nodes[b]));
        nodes[a] = low;
        nodes[b] = high;
    };
    order(0, 1); // a sorting network: no branch to mispredict
    order(2, 3);
    order(0, 2);
    order(1, 3);
    order(1, 2);
    if (nodes[0] != nodes[1] && nodes[1] != nodes[2] && nodes[2] != nodes[3])
        return nodes;
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
                    throw std::out_of_range("a cell names a node that does not exist");
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
                    if (const auto nodes =
                            face_nodes(mesh.cells[faces.face[i] / 8], faces.face[i] % 8);
                        has_area(nodes))
                        candidates.push_back({nodes, faces.face[i]});
                std::sort(candidates.begin(), candidates.end());
                join(mesh.cells, candidates);
            }
        });
}

std::vector<BoundaryFace> boundary_faces(const CellMesh& mesh) {
    std::vector<BoundaryFace> found;
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
        for (std::size_t f = 0; f < faces_of(mesh.cells[i]); ++f)
            if (mesh.cells[i].beyond[f] >= beyond_wall && has_area(face_nodes(mesh.cells[i], f)))
                found.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(f)});
    return found;
}

} // namespace wakesurf::core
