#include "importer/assembly/mesh_assembly.hpp"

#include "core/dataset/cell_neighbours.hpp"
#include "importer/assembly/block_cells.hpp"
#include "importer/assembly/mesh_parts.hpp"
#include "importer/assembly/point_merging.hpp"
#include "importer/assembly/polyhedron_cutter.hpp"
#include "importer/base/text.hpp"

#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace wakesurf::importer {

using core::Error;
using core::MeshCell;
using core::Vec3;
using Form = BlockCell::Form;

namespace {

// Points closer than eight roundings of 32-bit coordinates are one place: many files store coordinates so.
// But the distance is never more than this part of the shortest edge there: boundary layers are thin, and may
// be far from the origin.
constexpr double same_place = 0x1p-21;
constexpr double part_of_edge = 0.1;

void append_points(vtkDataSet& data, std::vector<Vec3>& out) {
    const vtkIdType count = data.GetNumberOfPoints();
    for (vtkIdType i = 0; i < count; ++i) {
        double p[3];
        data.GetPoint(i, p);
        out.emplace_back(p[0], p[1], p[2]);
    }
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return count == 1 ? "1 " + one : std::to_string(count) + " " + many;
}

std::vector<std::uint32_t> unique_nodes(std::vector<std::uint32_t> nodes) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

class MeshAssembly {
  public:
    MeshAssembly(BlockList blocks, const AssemblyRequest& request) : request_(request) {
        std::size_t points = 0;
        for (const auto& block : blocks) {
            cells_.emplace_back(*block);
            points += static_cast<std::size_t>(block->GetNumberOfPoints());
            auto* const set = vtkPointSet::SafeDownCast(block);
            single_ = single_ || (set != nullptr && set->GetPoints() != nullptr &&
                                  set->GetPoints()->GetDataType() == VTK_FLOAT);
        }
        points_.at.reserve(points);
        for (const auto& block : blocks) {
            points_.first.push_back(points_.at.size());
            append_points(*block, points_.at);
        }
        points_.first.push_back(points_.at.size());
        points_.used.assign(points_.at.size(), false);
    }

    core::Result<GridAssembly> run() {
        constexpr std::size_t most = 0xfffffff0u;
        if (points_.at.size() > most)
            return core::over_limit(most, "has more than 2^32 points");
        if (auto marked = mark_used(); !marked)
            return tl::unexpected(marked.error());
        if (auto numbered = number_nodes(); !numbered)
            return tl::unexpected(numbered.error());
        if (auto built = build_cells(); !built)
            return tl::unexpected(built.error());
        if (mesh_.cells.empty())
            return core::fail(
                Error::Code::Unsupported, "has no three-dimensional cells",
                "surfaces need a three-dimensional flow; extrude plane data by one cell");
        core::connect_cells(mesh_);
        out_.grid = std::move(mesh_);
        if (auto walled = wall_off_solids(); !walled)
            return tl::unexpected(walled.error());
        describe();
        add_note(out_.note, note_on_parts(std::get<core::CellMesh>(out_.grid)));
        return std::move(out_);
    }

  private:
    bool solid(std::size_t block, std::size_t cell) const {
        return block < request_.solid.size() && cell < request_.solid[block].size() &&
               request_.solid[block][cell];
    }

    // Calls visit(cell, number, solid) for every three-dimensional cell that is not blanked.
    template <class Visit>
    core::Result<void> visit_cells(std::size_t block, const Visit& visit) {
        for (std::size_t i = 0; i < cells_[block].size(); ++i) {
            if (auto read = cells_[block].read(i, cell_); !read)
                return read;
            visit(cell_, i, solid(block, i));
        }
        return {};
    }

    template <class Visit>
    static void visit_points(const BlockCell& cell, const Visit& visit) {
        if (cell.form == Form::Standard)
            std::for_each_n(cell.point.begin(), core::node_count(cell.shape), visit);
        else if (cell.form == Form::Polyhedron)
            for (const auto& face : cell.faces)
                std::for_each(face.begin(), face.end(), visit);
    }

    // Marks the points that cells use, and finds the pieces: each structured block is one.
    core::Result<void> mark_used() {
        DisjointSets together(points_.at.size());
        for (std::size_t b = 0; b < cells_.size(); ++b) {
            out_.curvilinear = (b == 0 || out_.curvilinear) && cells_[b].structured();
            const bool whole = cells_[b].structured();
            const auto first = static_cast<std::uint32_t>(points_.first[b]);
            auto marked = visit_cells(b, [&](const BlockCell& cell, std::size_t, bool is_solid) {
                std::uint32_t before = no_node;
                if (!is_solid)
                    visit_points(cell, [&](std::uint32_t p) {
                        points_.used[first + p] = true;
                        if (before != no_node && !whole)
                            together.join(first + before, first + p);
                        before = p;
                    });
            });
            if (!marked)
                return marked;
            for (std::size_t i = points_.first[b] + 1; whole && i < points_.first[b + 1]; ++i)
                together.join(first, static_cast<std::uint32_t>(i));
        }
        points_.piece.assign(points_.at.size(), no_node);
        for (std::uint32_t i = 0; i < points_.at.size(); ++i) {
            if (!points_.used[i])
                continue;
            auto& piece = points_.piece[together.lowest(i)]; // of the lowest, which comes first
            if (piece == no_node)
                piece = static_cast<std::uint32_t>(points_.pieces++);
            points_.piece[i] = piece;
        }
        return {};
    }

    // Sets how far points reach. REQUIRES: all cells have been read without an error before.
    void find_reach(double slack) {
        points_.reach.assign(points_.at.size(), static_cast<float>(slack));
        for (std::size_t b = 0; b < cells_.size(); ++b) {
            const auto at = [&](std::uint32_t p) { return points_.at[points_.first[b] + p]; };
            static_cast<void>(visit_cells(b, [&](const BlockCell& cell, std::size_t, bool) {
                double shortest = HUGE_VAL;
                const auto shorten = [&](std::uint32_t p, std::uint32_t q) {
                    if (const double length = glm::length(at(p) - at(q)); length > 0.0)
                        shortest = std::min(shortest, length);
                };
                visit_edges(cell, shorten);
                const auto reach = static_cast<float>(part_of_edge * shortest);
                visit_points(cell, [&](std::uint32_t p) {
                    auto& here = points_.reach[points_.first[b] + p];
                    here = std::min(here, reach);
                });
            }));
        }
    }

    std::vector<FacePoints> faces_at(const std::vector<bool>& marked) {
        std::vector<FacePoints> found;
        for (std::size_t b = 0; b < cells_.size(); ++b) {
            const auto visited =
                visit_cells(b, [&](const BlockCell& cell, std::size_t, bool is_solid) {
                    bool touches = false;
                    visit_points(cell, [&](std::uint32_t p) {
                        touches = touches || marked[points_.first[b] + p];
                    });
                    if (is_solid || !touches)
                        return;
                    for (auto& face : faces_of(cell)) {
                        for (auto& point : face)
                            point += static_cast<std::uint32_t>(points_.first[b]);
                        found.push_back(std::move(face));
                    }
                });
            if (!visited)
                break; // the same cells were read without an error before
        }
        return found;
    }

    core::Result<void> number_nodes() {
        Vec3 lo(HUGE_VAL);
        Vec3 hi(-HUGE_VAL);
        for (std::size_t i = 0; i < points_.at.size(); ++i)
            if (points_.used[i]) {
                lo = glm::min(lo, points_.at[i]);
                hi = glm::max(hi, points_.at[i]);
            }
        std::vector<std::uint32_t> same;
        if (points_.pieces > 1) {
            const Vec3 size = single_ ? glm::max(glm::abs(lo), glm::abs(hi)) : hi - lo;
            const double slack = same_place * std::max({size.x, size.y, size.z});
            find_reach(slack);
            same = merge_points(points_, [&](const auto& marked) { return faces_at(marked); });
            if (request_.velocities)
                if (auto sound = keep_apart(same); !sound)
                    return sound;
            note_joined(same, slack);
        }
        std::vector<std::uint32_t> number; // of the points of each node
        for (std::size_t b = 0; b < cells_.size(); ++b) {
            auto& nodes = out_.blocks.emplace_back().node_of_point;
            nodes.assign(points_.first[b + 1] - points_.first[b], no_node);
            for (std::size_t i = points_.first[b]; i < points_.first[b + 1]; ++i) {
                if (!points_.used[i])
                    continue;
                const std::size_t first = same.empty() ? i : same[i];
                if (first == i) {
                    nodes[i - points_.first[b]] = static_cast<std::uint32_t>(mesh_.points.size());
                    mesh_.points.push_back(points_.at[i]);
                    number.push_back(1);
                    if (!place_.empty())
                        out_.place.push_back(place_[i]);
                    continue;
                }
                const auto owner = static_cast<std::size_t>(
                    std::upper_bound(points_.first.begin(), points_.first.end(), first) -
                    points_.first.begin() - 1);
                const std::uint32_t node =
                    out_.blocks[owner].node_of_point[first - points_.first[owner]];
                nodes[i - points_.first[b]] = node;
                out_.further.push_back({static_cast<std::uint32_t>(b),
                                        static_cast<std::uint32_t>(i - points_.first[b]), node,
                                        ++number[node]});
            }
        }
        for (const std::uint32_t points : number)
            shared_.push_back(points > 1);
        out_.source_nodes = mesh_.points.size();
        points_ = {};
        place_ = {};
        return {};
    }

    // Takes the points out of their nodes whose velocities jump.
    core::Result<void> keep_apart(std::vector<std::uint32_t>& same) {
        std::vector<std::uint32_t> cells(points_.pieces, 0);
        const auto each_cell = [&](const auto& visit) {
            for (std::size_t b = 0; b < cells_.size(); ++b) // read without an error before
                static_cast<void>(
                    visit_cells(b, [&](const BlockCell& cell, std::size_t, bool is_solid) {
                        if (!is_solid && cell.form != Form::None)
                            visit(cell, static_cast<std::uint32_t>(points_.first[b]));
                    }));
        };
        each_cell([&](const BlockCell& cell, std::uint32_t first) {
            const auto corner =
                cell.form == Form::Standard ? cell.point.front() : cell.faces.front().front();
            ++cells[points_.piece[first + corner]];
        });
        MeetingPoints meeting(same, points_.piece, cells);
        if (meeting.empty())
            return {};
        each_cell([&](const BlockCell& cell, std::uint32_t first) {
            visit_edges(cell, [&](std::uint32_t p, std::uint32_t q) {
                meeting.add_edge(first + p, first + q);
            });
        });
        auto sound =
            request_.velocities([&](std::span<const float> velocity) { meeting.take(velocity); });
        if (!sound)
            return sound;
        DisjointSets nodes(same.size());
        meeting.join(nodes);
        auto place = same;
        for (std::uint32_t i = 0; i < same.size(); ++i)
            same[i] = nodes.lowest(i);
        for (std::size_t i = 0; i < same.size(); ++i)
            apart_ += same[i] != place[i] ? 1 : 0;
        joined_by_ = meeting.largest(same, true);
        apart_by_ = meeting.largest(same, false);
        meeting.keep_joined(same);
        out_.meeting = std::move(meeting);
        if (apart_ > 0)
            place_ = std::move(place);
        return {};
    }

    // Notes points that differ, or are of one block: files leave it to their reader to join either.
    void note_joined(const std::vector<std::uint32_t>& same, double slack) {
        for (std::size_t b = 0; b < cells_.size(); ++b)
            for (std::size_t i = points_.first[b]; i < points_.first[b + 1]; ++i)
                if (same[i] != i &&
                    (same[i] >= points_.first[b] || points_.at[i] != points_.at[same[i]]))
                    ++joined_;
        joined_within_ = slack;
    }

    core::Result<void> build_cells() {
        PolyhedronCutter cutter(mesh_, out_.added);
        std::set<std::vector<std::uint32_t>> between_blocks;
        mesh_.cells.reserve(std::accumulate(
            cells_.begin(), cells_.end(), std::size_t{0},
            [](std::size_t sum, const BlockCells& cells) { return sum + cells.size(); }));
        for (std::size_t b = 0; b < cells_.size(); ++b) {
            BlockNodes& block = out_.blocks[b];
            if (request_.cell_nodes)
                block.first.assign(1, 0);
            auto built = visit_cells(b, [&](const BlockCell& cell, std::size_t, bool is_solid) {
                if (!is_solid && cell.form != Form::None)
                    add_cell(cell, block, cutter, between_blocks);
                if (request_.cell_nodes)
                    block.first.push_back(block.cell_nodes.size());
            });
            if (!built)
                return built;
        }
        overlapping_ = cutter.overlapping();
        return {};
    }

    void add_cell(const BlockCell& cell,
                  BlockNodes& block,
                  PolyhedronCutter& cutter,
                  std::set<std::vector<std::uint32_t>>& between_blocks) {
        std::vector<std::uint32_t>& nodes = scratch_;
        nodes.clear();
        visit_points(cell, [&](std::uint32_t p) { nodes.push_back(block.node_of_point[p]); });
        // Blocks that overlap by whole cells hold those twice.
        const bool between = std::all_of(nodes.begin(), nodes.end(),
                                         [&](std::uint32_t node) { return shared_[node]; });
        if (between || request_.cell_nodes) {
            std::sort(nodes.begin(), nodes.end());
            nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        }
        if (between && !between_blocks.insert(nodes).second) {
            ++twice_;
            return;
        }
        if (cell.form == Form::Standard ? !add_standard(cell, block)
                                        : !add_polyhedron(cell, block, cutter))
            return;
        ++out_.source_cells;
        if (request_.cell_nodes)
            block.cell_nodes.insert(block.cell_nodes.end(), nodes.begin(), nodes.end());
    }

    bool add_standard(const BlockCell& cell, const BlockNodes& block) {
        MeshCell made{};
        made.shape = cell.shape;
        for (std::size_t i = 0; i < core::node_count(cell.shape); ++i)
            made.node[i] = block.node_of_point[cell.point[i]];
        return add(made);
    }

    bool add_polyhedron(const BlockCell& cell, const BlockNodes& block, PolyhedronCutter& cutter) {
        faces_ = cell.faces;
        for (auto& face : faces_)
            for (auto& point : face)
                point = block.node_of_point[point];
        if (auto made = standard_cell(faces_))
            return add(*made);
        cutter.cut(faces_);
        ++cut_;
        return true;
    }

    bool add(MeshCell cell) {
        const Turned turned = turn_outside_out(cell, mesh_.points);
        flat_ += turned == Turned::Flat ? 1 : 0;
        if (turned == Turned::Flat)
            return false;
        mesh_.cells.push_back(cell);
        return true;
    }

    core::Result<void> wall_off_solids() {
        auto& mesh = std::get<core::CellMesh>(out_.grid);
        std::set<std::vector<std::uint32_t>> solid_faces;
        for (std::size_t b = 0; b < request_.solid.size() && b < cells_.size(); ++b) {
            auto visited = visit_cells(b, [&](const BlockCell& cell, std::size_t, bool is_solid) {
                for (auto& face : is_solid ? faces_of(cell) : std::vector<Polygon>()) {
                    for (auto& point : face)
                        point = out_.blocks[b].node_of_point[point];
                    if (std::find(face.begin(), face.end(), no_node) == face.end())
                        solid_faces.insert(unique_nodes(std::move(face)));
                }
            });
            if (!visited)
                return visited;
        }
        if (solid_faces.empty())
            return {};
        for (const auto& [cell, face] : core::boundary_faces(mesh))
            if (solid_faces.contains(source_polygon(out_, mesh.cells[cell], face)))
                mesh.cells[cell].beyond[face] = core::beyond_wall;
        return {};
    }

    void describe() {
        const auto add = [&](const std::string& words) { add_note(out_.note, words); };
        if (joined_ > 0)
            add(counted(joined_, "point was joined", "points were joined") +
                " with others at the same place, no farther than " +
                length_text(joined_within_, 2) + " and a tenth of the shortest edge there");
        if (joined_by_ > 0.0)
            add("where points are one node, their velocities differ by up to " +
                length_text(joined_by_, 2) + ": the mean is taken");
        if (apart_ > 0)
            add(counted(apart_, "point stays", "points stay") +
                " apart from others at the same place, where the velocity jumps by up to " +
                length_text(apart_by_, 2) + ": no particle crosses there");
        if (flat_ > 0)
            add(counted(flat_, "cell without volume was left out",
                        "cells without volume were left out"));
        if (twice_ > 0)
            add(counted(twice_, "cell shared by two blocks was stored once",
                        "cells shared by two blocks were stored once"));
        if (cut_ > 0)
            add(counted(cut_, "polyhedron was cut", "polyhedra were cut") +
                " into pyramids and tetrahedra");
        if (overlapping_ > 0)
            add(counted(overlapping_, "of them is so distorted that its parts overlap",
                        "of them are so distorted that their parts overlap"));
    }

    const AssemblyRequest& request_;
    std::vector<BlockCells> cells_;
    BlockPoints points_;
    core::CellMesh mesh_;
    GridAssembly out_;
    std::vector<bool> shared_; ///< by node: a point of several blocks
    BlockCell cell_;
    std::vector<std::uint32_t> scratch_;
    std::vector<Polygon> faces_;
    bool single_ = false; ///< coordinates are stored in 32 bits
    std::size_t joined_ = 0;
    double joined_within_ = 0.0;
    double joined_by_ = 0.0; ///< velocities of one node differ
    std::size_t apart_ = 0;  ///< points that are no node of others at their place
    double apart_by_ = 0.0;
    std::vector<std::uint32_t> place_; ///< the lowest point there; empty if none stays apart
    std::size_t flat_ = 0;
    std::size_t twice_ = 0;
    std::size_t cut_ = 0;
    std::size_t overlapping_ = 0;
};

} // namespace

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

core::Result<GridAssembly> assemble_mesh(BlockList blocks, const AssemblyRequest& request) {
    return MeshAssembly(blocks, request).run();
}

} // namespace wakesurf::importer
