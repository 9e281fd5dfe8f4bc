#include "tests/support/mesh_delta.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace wakesurf::tests {

using core::KeyedMesh;
using core::no_vertex;
using core::QuadComplex;
using core::VertexId;

namespace {

MeshDelta::Vertex vertex_of(const KeyedMesh& from, std::size_t i) {
    const QuadComplex& m = from.mesh;
    return {from.vertex_id[i],
            m.position[i],
            m.s[i],
            m.t[i],
            m.velocity[i],
            m.deformation.empty() ? 0.0f : m.deformation[i],
            m.component[i],
            m.approximated[i]};
}

/// Returns the cell with ids for slots; absent mids stay absent.
MeshDelta::KeyedCell cell_of(const KeyedMesh& from, std::size_t i) {
    MeshDelta::KeyedCell keyed{from.cell_id[i], from.mesh.cells[i]};
    for (auto* ids : {&keyed.cell.corner, &keyed.cell.mid})
        for (VertexId& v : *ids)
            if (v != no_vertex)
                v = from.vertex_id[v];
    return keyed;
}

/// Walks two ascending lists of ids: `gone` for those only in the first, `come` only in the second, `both`
/// for those in both.
template <class Gone, class Come, class Both>
void compare(std::span<const std::uint32_t> a,
             std::span<const std::uint32_t> b,
             Gone gone,
             Come come,
             Both both) {
    for (std::size_t i = 0, k = 0; i < a.size() || k < b.size();) {
        if (k == b.size() || (i < a.size() && a[i] < b[k]))
            gone(i++);
        else if (i == a.size() || b[k] < a[i])
            come(k++);
        else
            both(i++, k++);
    }
}

void append(KeyedMesh& mesh, const MeshDelta::Vertex& v, bool deformation) {
    mesh.vertex_id.push_back(v.id);
    mesh.mesh.position.push_back(v.position);
    mesh.mesh.s.push_back(v.s);
    mesh.mesh.t.push_back(v.t);
    mesh.mesh.velocity.push_back(v.velocity);
    if (deformation)
        mesh.mesh.deformation.push_back(v.deformation);
    mesh.mesh.component.push_back(v.component);
    mesh.mesh.approximated.push_back(v.approximated);
}

/// Returns old entries without the removed ones, changed ones replaced, with the added ones: all three ascend
/// by id.
template <class Entry, class Take>
void merge(std::vector<Entry> old,
           const std::vector<std::uint32_t>& removed,
           const std::vector<Entry>& changed,
           const std::vector<Entry>& added,
           Take take) {
    std::size_t r = 0, c = 0, a = 0;
    const auto by_id = [&](const Entry& entry) {
        for (; a < added.size() && added[a].id < entry.id; ++a)
            take(added[a]);
        if (a < added.size() && added[a].id == entry.id)
            throw std::logic_error("a delta adds something the mesh has already");
        if (r < removed.size() && removed[r] == entry.id) {
            ++r;
            return;
        }
        take(c < changed.size() && changed[c].id == entry.id ? changed[c++] : entry);
    };
    for (const Entry& entry : old)
        by_id(entry);
    for (; a < added.size(); ++a)
        take(added[a]);
    if (r != removed.size() || c != changed.size())
        throw std::logic_error("a delta names something the mesh does not have");
}

class Fnv {
  public:
    template <class T>
    void add(const T& value) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
        for (std::size_t i = 0; i < sizeof(T); ++i)
            state_ = (state_ ^ bytes[i]) * 0x100000001b3ull;
    }

    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0xcbf29ce484222325ull;
};

} // namespace

MeshDelta difference(const KeyedMesh& before, const KeyedMesh& after) {
    MeshDelta delta;
    delta.time = after.time;
    delta.deformation = !after.mesh.deformation.empty();
    compare(
        before.vertex_id, after.vertex_id,
        [&](std::size_t i) { delta.vertices_removed.push_back(before.vertex_id[i]); },
        [&](std::size_t k) { delta.vertices_added.push_back(vertex_of(after, k)); },
        [&](std::size_t i, std::size_t k) {
            if (const auto now = vertex_of(after, k); !(now == vertex_of(before, i)))
                delta.vertices_moved.push_back(now);
        });
    compare(
        before.cell_id, after.cell_id,
        [&](std::size_t i) { delta.cells_removed.push_back(before.cell_id[i]); },
        [&](std::size_t k) { delta.cells_added.push_back(cell_of(after, k)); },
        [&](std::size_t i, std::size_t k) {
            if (const auto now = cell_of(after, k); !(now == cell_of(before, i)))
                delta.cells_changed.push_back(now);
        });
    delta.hash = hash(after);
    return delta;
}

KeyedMesh fold(const KeyedMesh& before, const MeshDelta& delta) {
    KeyedMesh after;
    after.time = delta.time;
    std::vector<MeshDelta::Vertex> vertices;
    for (std::size_t i = 0; i < before.vertex_id.size(); ++i)
        vertices.push_back(vertex_of(before, i));
    merge(std::move(vertices), delta.vertices_removed, delta.vertices_moved, delta.vertices_added,
          [&](const MeshDelta::Vertex& v) { append(after, v, delta.deformation); });
    std::vector<MeshDelta::KeyedCell> cells;
    for (std::size_t i = 0; i < before.cell_id.size(); ++i)
        cells.push_back(cell_of(before, i));
    const auto slot = [&](std::uint32_t id) {
        const auto found = std::lower_bound(after.vertex_id.begin(), after.vertex_id.end(), id);
        if (found == after.vertex_id.end() || *found != id)
            throw std::logic_error("a delta's cell names a vertex the mesh does not have");
        return static_cast<VertexId>(found - after.vertex_id.begin());
    };
    merge(std::move(cells), delta.cells_removed, delta.cells_changed, delta.cells_added,
          [&](MeshDelta::KeyedCell keyed) {
              for (auto* ids : {&keyed.cell.corner, &keyed.cell.mid})
                  for (VertexId& v : *ids)
                      if (v != no_vertex)
                          v = slot(v);
              after.cell_id.push_back(keyed.id);
              after.mesh.cells.push_back(keyed.cell);
          });
    return after;
}

std::uint64_t hash(const KeyedMesh& mesh) {
    Fnv sum;
    for (std::size_t i = 0; i < mesh.vertex_id.size(); ++i) {
        sum.add(mesh.vertex_id[i]);
        sum.add(mesh.mesh.position[i]);
        sum.add(mesh.mesh.s[i]);
        sum.add(mesh.mesh.t[i]);
    }
    for (std::size_t i = 0; i < mesh.cell_id.size(); ++i) {
        const MeshDelta::KeyedCell keyed = cell_of(mesh, i);
        sum.add(keyed.id);
        sum.add(keyed.cell.corner);
        sum.add(keyed.cell.mid);
    }
    return sum.value();
}

} // namespace wakesurf::tests
