// Surfaces that move, grow, tear, hang nodes on and come back, for the wire's tests: made with +, -, * and /
// alone, so that every machine makes the same bits.
#pragma once

#include "core/surface/quad_complex.hpp"
#include "tests/protocol/wire/sample_meshes.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace wakesurf::protocol::samples {

/// A sheet whose rows are released one after the other and carried through a smooth unsteady field.
class RandomSurface {
  public:
    explicit RandomSurface(std::uint32_t seed, std::uint32_t columns = 12)
        : random_(seed), columns_(columns) {}

    /// Returns the next state: most often moved, sometimes torn, emptied, an old one or unchanged.
    core::KeyedMesh next() {
        time_ += 0.1;
        const auto kind = random_() % 64;
        if (kind == 0)
            surface_ = {};
        else if (kind == 1)
            tear(2);
        else if (kind < 4 && !past_.empty())
            surface_ = past_[random_() % past_.size()];
        else if (kind < 8)
            jump();
        if (kind > 10)
            carry();
        if (random_() % 3 == 0)
            release();
        if (random_() % 4 == 0)
            hang();
        if (random_() % 8 == 0)
            tear(20);
        if (random_() % 16 == 0)
            past_.push_back(surface_);
        return mesh();
    }

  private:
    struct Vertex {
        core::Vec3 position;
        double s, t;
    };

    struct Surface {
        std::map<std::uint32_t, Vertex> vertices;
        std::map<std::uint32_t, core::Cell> cells; ///< of ids
        std::vector<std::uint32_t> row;            ///< the newest
    };

    core::Vec3 velocity(const core::Vec3& p) const {
        const double sway = 1.0 / (1.0 + 0.1 * time_);
        return {1.0 - 0.1 * p.y * p.y, 0.3 * sway * p.z, -0.3 * p.y + 0.05 * p.x};
    }

    static core::Vec3 inside(const core::Vec3& p) { return glm::clamp(p, domain.lo, domain.hi); }

    void carry() {
        for (auto& [id, v] : surface_.vertices)
            v.position = inside(v.position + 0.1 * velocity(v.position));
    }

    void jump() {
        for (auto& [id, v] : surface_.vertices)
            if (random_() % 5 == 0)
                v.position = inside(v.position + core::Vec3(0.5, -0.25, 0.125));
    }

    void release() {
        std::vector<std::uint32_t> row;
        for (std::uint32_t c = 0; c < columns_; ++c) {
            const double s = c / (columns_ - 1.0);
            row.push_back(next_id_++);
            surface_.vertices[row.back()] = {{-0.5, 2.0 * s - 1.0, s * s - 0.5}, s, time_};
        }
        for (std::size_t c = 0; c + 1 < surface_.row.size(); ++c) {
            core::Cell cell;
            cell.corner = {row[c], row[c + 1], surface_.row[c + 1], surface_.row[c]};
            surface_.cells[next_cell_id_++] = cell;
        }
        surface_.row = std::move(row);
    }

    void hang() {
        for (auto& [id, cell] : surface_.cells) {
            const std::size_t side = random_() % 4;
            if (random_() % 8 != 0 || cell.mid[side] != core::no_vertex)
                continue;
            const Vertex& a = surface_.vertices.at(cell.corner[side]);
            const Vertex& b = surface_.vertices.at(cell.corner[(side + 1) % 4]);
            cell.mid[side] = next_id_;
            surface_.vertices[next_id_++] = {0.5 * (a.position + b.position), 0.5 * (a.s + b.s),
                                             0.5 * (a.t + b.t)};
        }
    }

    void tear(std::uint32_t one_in) {
        std::erase_if(surface_.cells, [&](const auto&) { return random_() % one_in == 0; });
    }

    core::KeyedMesh mesh() const {
        std::map<std::uint32_t, std::uint32_t> place;
        for (const auto& [id, cell] : surface_.cells)
            for (const auto* vertices : {&cell.corner, &cell.mid})
                for (const std::uint32_t v : *vertices)
                    if (v != core::no_vertex)
                        place[v] = 0;
        core::KeyedMesh keyed;
        keyed.time = time_;
        for (auto& [id, at] : place) {
            at = static_cast<std::uint32_t>(keyed.vertex_id.size());
            const Vertex& v = surface_.vertices.at(id);
            keyed.vertex_id.push_back(id);
            keyed.mesh.position.push_back(v.position);
            keyed.mesh.s.push_back(v.s);
            keyed.mesh.t.push_back(v.t);
            keyed.mesh.velocity.push_back(core::Vec3f(velocity(v.position)));
        }
        for (const auto& [id, cell] : surface_.cells) {
            core::Cell placed = cell;
            for (auto* vertices : {&placed.corner, &placed.mid})
                for (std::uint32_t& v : *vertices)
                    if (v != core::no_vertex)
                        v = place.at(v);
            keyed.cell_id.push_back(id);
            keyed.mesh.cells.push_back(placed);
        }
        return keyed;
    }

    std::mt19937 random_;
    std::uint32_t columns_;
    Surface surface_;
    std::vector<Surface> past_;
    double time_ = 0.0;
    std::uint32_t next_id_ = 0;
    std::uint32_t next_cell_id_ = 0;
};

/// Computes the places of vertices and cells by the wire's rule, in the simplest way: those that stay keep
/// their order, new vertices follow by id, those of a KEY by s and t, new cells by their first corners.
class PlacesTwin {
  public:
    void follow(const core::KeyedMesh& mesh, bool key) {
        follow(vertices_, mesh.vertex_id, key);
        const std::size_t stayed = follow(cells_, mesh.cell_id, key);
        const auto vertex = [&](std::uint32_t id) { return index(mesh.vertex_id, id); };
        if (key)
            std::ranges::stable_sort(vertices_, {}, [&](std::uint32_t id) {
                return std::pair(mesh.mesh.s[vertex(id)], mesh.mesh.t[vertex(id)]);
            });
        std::map<std::size_t, std::size_t> place;
        for (const std::uint32_t id : vertices_)
            place.emplace(vertex(id), place.size());
        std::ranges::stable_sort(cells_.begin() + static_cast<std::ptrdiff_t>(stayed), cells_.end(),
                                 {}, [&](std::uint32_t id) {
                                     return place.at(
                                         mesh.mesh.cells[index(mesh.cell_id, id)].corner[0]);
                                 });
    }

    const std::vector<std::uint32_t>& vertices() const { return vertices_; }

    const std::vector<std::uint32_t>& cells() const { return cells_; }

  private:
    static std::size_t index(const std::vector<std::uint32_t>& ids, std::uint32_t id) {
        return static_cast<std::size_t>(std::ranges::lower_bound(ids, id) - ids.begin());
    }

    /// Returns how many of the earlier ones stay.
    static std::size_t
    follow(std::vector<std::uint32_t>& held, const std::vector<std::uint32_t>& ids, bool key) {
        if (key)
            held.clear();
        std::erase_if(held, [&](std::uint32_t id) { return !std::ranges::binary_search(ids, id); });
        std::vector<std::uint32_t> known = held;
        std::ranges::sort(known);
        for (const std::uint32_t id : ids)
            if (!std::ranges::binary_search(known, id))
                held.push_back(id);
        return known.size();
    }

    std::vector<std::uint32_t> vertices_;
    std::vector<std::uint32_t> cells_;
};

inline EncodedUpdate
next(MeshStream& stream, const core::KeyedMesh& mesh, const UpdateOptions& options = {}) {
    auto update = stream.next(mesh, options);
    EXPECT_TRUE(update.has_value()) << (update ? "" : update.error().message);
    return update ? std::move(*update) : EncodedUpdate{};
}

} // namespace wakesurf::protocol::samples
