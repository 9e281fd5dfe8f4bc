#include "core/surface/columns/sheet_bends.hpp"

#include <glm/vec3.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

struct Face {
    glm::vec3 normal;      ///< of length 1, or 0 where the cell has no area
    std::uint32_t last[2]; ///< vertex of its left and of its right column where it ends
};

/// The cells of a strip, as far as their neighbours across a column need to know them.
struct StripFaces {
    struct CellOfNode {
        std::int32_t node;
        std::uint32_t row;
    };

    const Strip* strip = nullptr;
    std::vector<const Vec3*> position; ///< by column
    std::vector<std::uint32_t> offset; ///< by node: of its first cell in `faces`
    std::vector<Face> faces;
    std::vector<CellOfNode> bent;

    const Vec3& at(const StripVertex& v) const { return position[v.column][v.index]; }

    /// Square to both diagonals, twice as long as the cell is large.
    Vec3 area(const StripCell& cell) const {
        const auto& [a, b, c, d] = cell.corner;
        return glm::cross(at(c) - at(a), at(d) - at(b));
    }

    /// Returns the width square to the columns.
    double width(const StripCell& cell) const {
        const auto& [a, b, c, d] = cell.corner;
        const double along = glm::length((at(c) - at(b)) + (at(d) - at(a)));
        return along > 0.0 ? glm::length(area(cell)) / along : 0.0;
    }

    void add(std::int32_t node) {
        offset[static_cast<std::size_t>(node)] = static_cast<std::uint32_t>(faces.size());
        for (const StripCell& cell : strip->cells(node)) {
            const Vec3 twice = area(cell);
            const double square = glm::dot(twice, twice);
            const double scale = square > 0.0 ? 1.0 / std::sqrt(square) : 0.0;
            faces.push_back(
                {glm::vec3(twice * scale), {cell.corner[3].index, cell.corner[2].index}});
        }
        for (std::size_t side = 0; side < 2; ++side)
            if (const std::int32_t child = strip->child(node, side); child >= 0)
                add(child);
    }

    void make(const Strip& from) {
        strip = &from;
        for (const StripColumn& column : from.columns())
            position.push_back(column.column->position.data());
        offset.resize(from.nodes());
        faces.reserve(from.quads());
        add(0);
    }
};

/// Visits the cells on one side of a column, one after the other from its first vertex on.
class ColumnSide {
  public:
    /// @param node  where they begin; those of its child number `side` follow, and so on
    ColumnSide(StripFaces& faces, std::int32_t node, std::size_t side)
        : faces_(faces), node_(node), side_(side) {
        enter();
    }

    bool ended() const { return node_ < 0; }

    const glm::vec3& normal() const { return face_[row_].normal; }

    /// Vertex of the column where the cell ends.
    std::uint32_t last() const { return face_[row_].last[side_]; }

    double width() const { return faces_.width(faces_.strip->cells(node_)[row_]); }

    void mark() { faces_.bent.push_back({node_, static_cast<std::uint32_t>(row_)}); }

    void next() {
        if (++row_ == rows_) {
            node_ = faces_.strip->child(node_, side_);
            enter();
        }
    }

  private:
    void enter() {
        for (row_ = 0; node_ >= 0; node_ = faces_.strip->child(node_, side_)) {
            rows_ = faces_.strip->cells(node_).size();
            face_ = faces_.faces.data() + faces_.offset[static_cast<std::size_t>(node_)];
            if (rows_ > 0)
                return;
        }
    }

    StripFaces& faces_;
    std::int32_t node_;
    std::size_t side_;
    std::size_t row_ = 0;
    std::size_t rows_ = 0;
    const Face* face_ = nullptr;
};

class Bends {
  public:
    Bends(double least_cosine, double least_width)
        : least_cosine_(static_cast<float>(least_cosine)), least_width_(least_width) {}

    /// Compares the cells on the left of a column with those on its right.
    void mark(ColumnSide left, ColumnSide right) const {
        while (!left.ended() && !right.ended()) {
            if (glm::dot(left.normal(), right.normal()) < least_cosine_)
                mark_wide(left, right);
            const bool next_left = left.last() <= right.last();
            const bool next_right = right.last() <= left.last();
            if (next_left)
                left.next();
            if (next_right)
                right.next();
        }
    }

  private:
    /// A cell much narrower than the other has done its part; that of a sliver, whose sides lie closer than
    /// they are curved, points anywhere.
    void mark_wide(ColumnSide& a, ColumnSide& b) const {
        const double a_width = a.width();
        const double b_width = b.width();
        if (std::min(a_width, b_width) < 0.2 * least_width_)
            return;
        if (a_width > least_width_ && a_width > 0.5 * b_width)
            a.mark();
        if (b_width > least_width_ && b_width > 0.5 * a_width)
            b.mark();
    }

    float least_cosine_;
    double least_width_;
};

void mark_inner_columns(const Bends& bends, StripFaces& faces, std::int32_t node) {
    const std::int32_t left = faces.strip->child(node, 0);
    const std::int32_t right = faces.strip->child(node, 1);
    if (left < 0)
        return;
    bends.mark({faces, left, 1}, {faces, right, 0});
    mark_inner_columns(bends, faces, left);
    mark_inner_columns(bends, faces, right);
}

} // namespace

std::vector<std::vector<std::uint32_t>>
find_bends(std::span<const Strip> strips, bool closed, double least_cosine, double least_width) {
    const Bends bends(least_cosine, least_width);
    std::vector<StripFaces> all(strips.size());
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(std::size_t{0}, strips.size(), [&](std::size_t i) {
            all[i].make(strips[i]);
            mark_inner_columns(bends, all[i], 0);
        });
    });
    const auto mark_right_of = [&](std::size_t i) {
        bends.mark({all[i], 0, 1}, {all[(i + 1) % all.size()], 0, 0});
    };
    for (std::size_t odd = 0; odd < 2; ++odd) // every second column, so that no strip is on two
        tbb::this_task_arena::isolate([&] {
            tbb::parallel_for(std::size_t{0}, all.size() / 2, [&](std::size_t i) {
                if (2 * i + odd + 1 < all.size())
                    mark_right_of(2 * i + odd);
            });
        });
    if (closed && !all.empty())
        mark_right_of(all.size() - 1);
    std::vector<std::vector<std::uint32_t>> rows(strips.size());
    for (std::size_t i = 0; i < strips.size(); ++i)
        for (const auto& [node, row] : all[i].bent) {
            if (rows[i].empty())
                rows[i].assign(strips[i].nodes(), Strip::no_row);
            std::uint32_t& first = rows[i][static_cast<std::size_t>(node)];
            first = std::min(first, row);
        }
    return rows;
}

} // namespace wakesurf::core
