#include "core/surface/level/level_triangles.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <compare>
#include <limits>
#include <map>
#include <variant>

namespace wakesurf::core {

namespace {

/// The nodes of an edge within a cell: that below the level, that at or above it.
using CellEdge = std::array<std::uint8_t, 2>;

/// What the level cuts out of a cell, by which of its nodes are at or above it.
struct CellCase {
    std::uint8_t crossings = 0;
    std::uint8_t triangles = 0;
    std::array<CellEdge, 12> crossing{};
    std::array<std::array<std::uint8_t, 3>, 5> triangle{}; ///< of crossings
};

bool share_face(CellShape shape, const CellEdge& a, const CellEdge& b) {
    for (std::size_t f = 0; f < face_count(shape); ++f) {
        const CellFace side = face(shape, f);
        const auto has = [&](std::uint8_t node) {
            return std::find(side.node.begin(), side.node.begin() + side.count, node) !=
                   side.node.begin() + side.count;
        };
        if (has(a[0]) && has(a[1]) && has(b[0]) && has(b[1]))
            return true;
    }
    return false;
}

/// Cuts a polygon into a fan without a diagonal inside a face, where the cell beyond may have the same one.
/// Each polygon of the four shapes has such a fan.
void add_fan(CellCase& out, CellShape shape, const std::vector<CellEdge>& polygon) {
    const std::size_t n = polygon.size();
    const auto good = [&](std::size_t from) {
        for (std::size_t k = 2; k + 1 < n; ++k)
            if (share_face(shape, polygon[from], polygon[(from + k) % n]))
                return false;
        return true;
    };
    std::size_t from = 0;
    while (from + 1 < n && !good(from))
        ++from;
    const std::size_t first = out.crossings;
    for (const CellEdge& edge : polygon)
        out.crossing[out.crossings++] = edge;
    // The side that each shares with the next comes first: of pairs as good, paired_triangles takes the first.
    for (std::size_t k = 1; k + 1 < n; ++k)
        out.triangle[out.triangles++] = {static_cast<std::uint8_t>(first + (from + k + 1) % n),
                                         static_cast<std::uint8_t>(first + from),
                                         static_cast<std::uint8_t>(first + (from + k) % n)};
}

/// On each face the level cuts off every run of neighbouring nodes that are at or above it. That depends on
/// the face alone, ambiguous or not, so that two cells cut the face between them alike.
CellCase cell_case(CellShape shape, unsigned above) {
    const auto is_above = [&](std::uint8_t node) { return (above >> node & 1U) != 0; };
    std::map<CellEdge, CellEdge> next;
    for (std::size_t f = 0; f < face_count(shape); ++f) {
        const CellFace side = face(shape, f);
        for (std::size_t k = 0; k < side.count; ++k) {
            const auto node = [&](std::size_t i) { return side.node[i % side.count]; };
            if (is_above(node(k)) || !is_above(node(k + 1)))
                continue;
            std::size_t last = k + 1;
            while (is_above(node(last + 1)))
                ++last;
            next[{node(k), node(k + 1)}] = {node(last + 1), node(last)};
        }
    }
    CellCase out;
    while (!next.empty()) {
        std::vector<CellEdge> polygon;
        for (auto at = next.begin(); at != next.end(); at = next.find(polygon.back())) {
            polygon.push_back(at->second);
            next.erase(at);
        }
        add_fan(out, shape, polygon);
    }
    return out;
}

constexpr std::array<std::size_t, 4> nodes_of_shape{4, 5, 6, 8};

/// Returns the cases of a shape by the bits of its nodes.
const std::vector<CellCase>& cell_cases(CellShape shape) {
    static const auto all = [] {
        std::array<std::vector<CellCase>, 4> cases;
        for (std::size_t s = 0; s < cases.size(); ++s)
            for (unsigned above = 0; above < 1U << nodes_of_shape[s]; ++above)
                cases[s].push_back(cell_case(static_cast<CellShape>(s), above));
        return cases;
    }();
    return all[static_cast<std::size_t>(shape)];
}

constexpr std::size_t block_size = 4096; ///< cells of a task

/// A value is at or above the level if it is at least the least such number.
float least_above(double level) {
    const auto near = static_cast<float>(level);
    return double{near} < level ? std::nextafter(near, std::numeric_limits<float>::infinity())
                                : near;
}

template <std::size_t size>
bool all_finite(std::span<const float> values, const std::uint32_t* node) {
    for (std::size_t k = 0; k < size; ++k)
        if (!std::isfinite(values[node[k]]))
            return false;
    return true;
}

/// The cells of a uniform or rectilinear grid, in blocks of rows along x.
class GridCells {
  public:
    GridCells(std::array<std::size_t, 3> nodes, std::span<const float> values, double level)
        : nodes_(nodes), values_(values), above_(least_above(level)),
          cases_(cell_cases(CellShape::Hexahedron)) {
        if (nodes[0] > 1 && nodes[1] > 1 && nodes[2] > 1) {
            rows_ = (nodes[1] - 1) * (nodes[2] - 1);
            rows_at_once_ = (block_size + nodes[0] - 2) / (nodes[0] - 1);
        }
    }

    std::size_t blocks() const { return (rows_ + rows_at_once_ - 1) / rows_at_once_; }

    /// Calls visit(case, nodes) for the cells that the level crosses.
    template <class Visit>
    void in_block(std::size_t block, const Visit& visit) const {
        std::vector<std::uint8_t> bits(nodes_[0]);
        const std::size_t end = std::min(rows_, (block + 1) * rows_at_once_);
        for (std::size_t row = block * rows_at_once_; row < end; ++row)
            in_row(row % (nodes_[1] - 1), row / (nodes_[1] - 1), bits, visit);
    }

  private:
    template <class Visit>
    void in_row(std::size_t j,
                std::size_t k,
                std::vector<std::uint8_t>& bits,
                const Visit& visit) const {
        const std::size_t nx = nodes_[0];
        const std::size_t plane = nx * nodes_[1];
        const std::size_t start = nx * j + plane * k;
        const float* const at = values_.data() + start;
        const float* const up = at + nx;
        const float* const beyond = at + plane;
        const float* const both = beyond + nx;
        // The nodes 0, 3, 4 and 7 of the cell behind, which are 1, 2, 5 and 6 of the one before.
        for (std::size_t i = 0; i < nx; ++i)
            bits[i] = static_cast<std::uint8_t>(static_cast<unsigned>(at[i] >= above_) |
                                                static_cast<unsigned>(up[i] >= above_) << 3 |
                                                static_cast<unsigned>(beyond[i] >= above_) << 4 |
                                                static_cast<unsigned>(both[i] >= above_) << 7);
        for (std::size_t i = 0; i + 1 < nx; ++i) {
            const unsigned after = bits[i + 1];
            if (bits[i] == after && (after == 0 || after == all_above))
                continue;
            const unsigned above = bits[i] | (after & 0x11) << 1 | (after & 0x88) >> 1;
            const auto n = static_cast<std::uint32_t>(start + i);
            const auto y = static_cast<std::uint32_t>(nx);
            const auto z = static_cast<std::uint32_t>(plane);
            const std::array<std::uint32_t, 8> node{n,     n + 1,     n + y + 1,     n + y,
                                                    n + z, n + z + 1, n + z + y + 1, n + z + y};
            if (all_finite<8>(values_, node.data()))
                visit(cases_[above], node);
        }
    }

    static constexpr unsigned all_above = 0x99;

    std::array<std::size_t, 3> nodes_;
    std::span<const float> values_;
    float above_;
    const std::vector<CellCase>& cases_;
    std::size_t rows_ = 0;
    std::size_t rows_at_once_ = 1;
};

/// The cells of a mesh, likewise.
class MeshCells {
  public:
    MeshCells(const CellMesh& mesh, std::span<const float> values, double level)
        : cells_(mesh.cells), values_(values), above_(least_above(level)) {}

    std::size_t blocks() const { return (cells_.size() + block_size - 1) / block_size; }

    template <class Visit>
    void in_block(std::size_t block, const Visit& visit) const {
        for (const MeshCell& cell : cells_.subspan(
                 block * block_size, std::min(block_size, cells_.size() - block * block_size)))
            switch (cell.shape) {
            case CellShape::Tetrahedron:
                in_cell<4>(cell, visit);
                break;
            case CellShape::Pyramid:
                in_cell<5>(cell, visit);
                break;
            case CellShape::Wedge:
                in_cell<6>(cell, visit);
                break;
            case CellShape::Hexahedron:
                in_cell<8>(cell, visit);
                break;
            }
    }

  private:
    template <std::size_t size, class Visit>
    void in_cell(const MeshCell& cell, const Visit& visit) const {
        unsigned above = 0;
        for (std::size_t k = 0; k < size; ++k)
            above |= static_cast<unsigned>(values_[cell.node[k]] >= above_) << k;
        if (above != 0 && above + 1 != 1U << size && all_finite<size>(values_, cell.node.data()))
            visit(cell_cases(cell.shape)[above], cell.node);
    }

    std::span<const MeshCell> cells_;
    std::span<const float> values_;
    float above_;
};

/// Visits blocks on all threads there are. Error: Cancelled.
template <class Visit>
Result<void> for_blocks(std::size_t count, const std::stop_token& stop, const Visit& visit) {
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t block) {
            if (!stop.stop_requested())
                visit(block);
        });
    });
    if (stop.stop_requested())
        return fail(Error::Code::Cancelled, "the level set was cancelled");
    return {};
}

/// An edge of the grid that the level crosses.
struct LevelCrossing {
    std::uint32_t low, high; ///< its nodes, by number

    auto operator<=>(const LevelCrossing&) const = default;
};

class Contour {
  public:
    Contour(const Grid& grid,
            std::span<const float> values,
            double level,
            const std::stop_token& stop)
        : grid_(grid), values_(values), level_(level), stop_(stop) {}

    template <class Cells>
    Result<LevelTriangles> of(const Cells& cells, std::uint64_t most, const WorkPart& work) {
        if (auto counted = count(cells); !counted)
            return tl::unexpected(std::move(counted.error()));
        const std::uint64_t triangles = triangles_before_.back();
        const std::uint64_t crossings = crossings_before_.back();
        out_.needed = triangles;
        if (triangles > most)
            return std::move(out_);
        while (values_.size() >> nodes_bits_ > crossings / 4)
            ++nodes_bits_;
        const std::size_t meanwhile =
            crossings * (sizeof(LevelCrossing) + 2 * sizeof(std::uint32_t)) +
            (buckets() + 1) * sizeof(std::uint32_t);
        auto done = work.takes(meanwhile + triangles * sizeof(out_.triangles[0]))
                        .and_then([&] { return cut(cells); })
                        .and_then([&] { return number(work); })
                        .and_then([&] { return join(); });
        if (!done)
            return tl::unexpected(std::move(done.error()));
        work.gives_back(meanwhile);
        return std::move(out_);
    }

  private:
    /// Edges are sorted into so many buckets by their lower node: each has a few.
    std::size_t buckets() const { return (values_.size() >> nodes_bits_) + 1; }

    /// Counts what each block will have.
    template <class Cells>
    Result<void> count(const Cells& cells) {
        triangles_before_.assign(cells.blocks() + 1, 0);
        crossings_before_.assign(cells.blocks() + 1, 0);
        const auto counted = for_blocks(cells.blocks(), stop_, [&](std::size_t block) {
            std::uint64_t triangles = 0, crossings = 0;
            cells.in_block(block, [&](const CellCase& what, const auto&) {
                triangles += what.triangles;
                crossings += what.crossings;
            });
            triangles_before_[block + 1] = triangles;
            crossings_before_[block + 1] = crossings;
        });
        for (std::size_t block = 0; block < cells.blocks(); ++block) {
            triangles_before_[block + 1] += triangles_before_[block];
            crossings_before_[block + 1] += crossings_before_[block];
        }
        return counted;
    }

    /// Makes the triangles, with crossings of their cells as corners.
    template <class Cells>
    Result<void> cut(const Cells& cells) {
        out_.triangles.resize(triangles_before_.back());
        crossings_.resize(crossings_before_.back());
        return for_blocks(cells.blocks(), stop_, [&](std::size_t block) {
            std::size_t triangle = triangles_before_[block];
            std::size_t crossing = crossings_before_[block];
            if (triangle == triangles_before_[block + 1])
                return;
            cells.in_block(block, [&](const CellCase& what, const auto& node) {
                for (std::size_t t = 0; t < what.triangles; ++t)
                    for (std::size_t k = 0; k < 3; ++k)
                        out_.triangles[triangle + t][k] =
                            static_cast<std::uint32_t>(crossing + what.triangle[t][k]);
                triangle += what.triangles;
                for (std::size_t c = 0; c < what.crossings; ++c) {
                    const auto [low, high] =
                        std::minmax(node[what.crossing[c][0]], node[what.crossing[c][1]]);
                    crossings_[crossing++] = {low, high};
                }
            });
        });
    }

    /// Makes one point of the crossings of one edge, in the order of edges.
    Result<void> number(const WorkPart& work) {
        const std::size_t buckets = this->buckets();
        const auto bucket = [&](const LevelCrossing& each) {
            return std::size_t{each.low} >> nodes_bits_;
        };
        std::vector<std::uint32_t> end(buckets + 1, 0);
        std::vector<std::uint32_t> order(crossings_.size());
        for (const LevelCrossing& each : crossings_)
            ++end[bucket(each) + 1];
        for (std::size_t b = 0; b < buckets; ++b)
            end[b + 1] += end[b];
        for (std::uint32_t i = 0; i < crossings_.size(); ++i)
            order[end[bucket(crossings_[i])]++] = i;

        constexpr std::size_t at_once = 1024; // buckets
        const std::size_t blocks = (buckets + at_once - 1) / at_once;
        const auto in_block = [&](std::size_t block, const auto& visit) {
            for (std::size_t b = block * at_once; b < std::min(buckets, (block + 1) * at_once); ++b)
                visit(std::span(order).subspan(b == 0 ? 0 : end[b - 1],
                                               end[b] - (b == 0 ? 0 : end[b - 1])));
        };
        point_.resize(crossings_.size());
        std::vector<std::uint32_t> points_before(blocks + 1, 0);
        const auto counted = for_blocks(blocks, stop_, [&](std::size_t block) {
            std::uint32_t points = 0;
            in_block(block, [&](std::span<std::uint32_t> part) {
                std::ranges::sort(part, {}, [&](std::uint32_t i) { return crossings_[i]; });
                for (std::size_t i = 0; i < part.size(); ++i) {
                    points += i == 0 || crossings_[part[i]] != crossings_[part[i - 1]] ? 1 : 0;
                    point_[part[i]] = points - 1;
                }
            });
            points_before[block + 1] = points;
        });
        if (!counted)
            return counted;
        for (std::size_t block = 0; block < blocks; ++block)
            points_before[block + 1] += points_before[block];
        if (auto room = work.takes(points_before.back() * sizeof(Vec3)); !room)
            return room;
        out_.points.resize(points_before.back());
        return for_blocks(blocks, stop_, [&](std::size_t block) {
            in_block(block, [&](std::span<const std::uint32_t> part) {
                for (std::size_t i = 0; i < part.size(); ++i) {
                    const std::uint32_t at = point_[part[i]] += points_before[block];
                    if (i == 0 || crossings_[part[i]] != crossings_[part[i - 1]])
                        out_.points[at] = place_of(crossings_[part[i]]);
                }
            });
        });
    }

    /// Returns the place on the edge; at a node whose value is the level it is that of the node.
    Vec3 place_of(const LevelCrossing& edge) const {
        const double low = values_[edge.low];
        const double part = (level_ - low) / (double{values_[edge.high]} - low);
        const Vec3 from = node_position(grid_, edge.low);
        const Vec3 to = node_position(grid_, edge.high);
        return part >= 1.0
                   ? to
                   : glm::clamp(from + part * (to - from), glm::min(from, to), glm::max(from, to));
    }

    /// Gives the triangles points for crossings.
    Result<void> join() {
        const std::size_t blocks = (out_.triangles.size() + block_size - 1) / block_size;
        std::atomic<bool> repeats{false};
        const auto joined = for_blocks(blocks, stop_, [&](std::size_t block) {
            const std::size_t end = std::min(out_.triangles.size(), (block + 1) * block_size);
            for (std::size_t t = block * block_size; t < end; ++t) {
                for (std::uint32_t& corner : out_.triangles[t])
                    corner = point_[corner];
                if (repeats_point(out_.triangles[t]))
                    repeats = true;
            }
        });
        if (repeats)
            leave_out_repeating();
        return joined;
    }

    static bool repeats_point(const std::array<std::uint32_t, 3>& t) {
        return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    }

    /// Leaves out triangles that cells with a repeated node make, and the points of these alone.
    void leave_out_repeating() {
        std::erase_if(out_.triangles, repeats_point);
        std::vector<std::uint32_t> now(out_.points.size(), 0);
        for (const auto& triangle : out_.triangles)
            for (const std::uint32_t corner : triangle)
                now[corner] = 1;
        std::uint32_t used = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
            if (now[i] != 0) {
                out_.points[used] = out_.points[i];
                now[i] = used++;
            }
        out_.points.resize(used);
        for (auto& triangle : out_.triangles)
            for (std::uint32_t& corner : triangle)
                corner = now[corner];
    }

    const Grid& grid_;
    std::span<const float> values_;
    double level_;
    const std::stop_token& stop_;
    unsigned nodes_bits_ = 0;                     ///< a bucket is of 2^this nodes
    std::vector<std::uint64_t> triangles_before_; ///< each block, and all
    std::vector<std::uint64_t> crossings_before_; ///< likewise
    std::vector<LevelCrossing> crossings_;        ///< of each cell
    std::vector<std::uint32_t> point_;            ///< of each crossing
    LevelTriangles out_;
};

/// Returns the nodes along each axis of a grid that is not a mesh.
std::array<std::size_t, 3> nodes_along(const Grid& grid) {
    if (const auto* uniform = std::get_if<UniformGrid>(&grid))
        return {uniform->dimensions[0], uniform->dimensions[1], uniform->dimensions[2]};
    const auto& along = std::get<RectilinearGrid>(grid).coordinates;
    return {along[0].size(), along[1].size(), along[2].size()};
}

} // namespace

Result<LevelTriangles> level_triangles(const Grid& grid,
                                       std::span<const float> values,
                                       double level,
                                       std::uint64_t most,
                                       const std::stop_token& stop,
                                       const WorkPart& work) {
    if (values.size() > std::numeric_limits<std::uint32_t>::max())
        return fail(Error::Code::OverLimit, "this grid has too many nodes for level sets");
    Contour contour(grid, values, level, stop);
    if (const auto* mesh = std::get_if<CellMesh>(&grid))
        return contour.of(MeshCells(*mesh, values, level), most, work);
    return contour.of(GridCells(nodes_along(grid), values, level), most, work);
}

} // namespace wakesurf::core
