#include "core/surface/columns/column_merge.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr std::uint32_t no_cell = 0xffffffffu;

/// A merge continues until cells are wider by this factor than where one may begin: columns do not flicker on
/// and off.
constexpr double hysteresis = 1.2;

/// A hanging node on the outline is dropped where that moves the outline by less than this part of the side.
constexpr double outline_shift = 0.02;

/// A shorter merge saves less than its two hanging nodes are worth.
constexpr std::size_t fewest_rows = 4;

/// The cells on either side of a column between two vertices at which both sides have a corner.
struct Row {
    std::uint32_t left_young, right_young, left_old, right_old;
    VertexId from, to;
    bool begins = false; ///< narrow enough to begin a merge
};

class ColumnMerger {
  public:
    ColumnMerger(std::vector<Cell>& cells,
                 std::span<const Vec3> position,
                 const MergeLimits& limits)
        : cells_(cells), position_(position), limits_(limits), on_left_(position.size(), no_cell),
          on_right_(position.size(), no_cell) {
        for (std::size_t i = 0; i < cells.size(); ++i)
            put(cells[i], static_cast<std::uint32_t>(i));
    }

    void merge(const ColumnSpan& column) {
        collect(column);
        for (std::size_t begin = 0; begin < rows_.size();) {
            if (!rows_[begin].begins) {
                ++begin;
                continue;
            }
            std::size_t end = begin + 1;
            while (end < rows_.size() && rows_[end].from == rows_[end - 1].to)
                ++end;
            const std::size_t next = end;
            while (end > begin && !may_end(column, rows_[end - 1]))
                --end;
            // Skew fronts may be too long to begin or go on from: try again further from the rake.
            for (; end >= begin + fewest_rows; begin += 1 + (end - begin) / 8)
                if (may_begin(rows_[begin]) && join(column, begin, end))
                    break;
            begin = next;
        }
    }

    void drop_dead_cells() {
        std::erase_if(cells_, [](const Cell& cell) { return cell.corner[0] == no_vertex; });
    }

  private:
    Cell& cell(std::uint32_t index) { return cells_[index]; }

    void put(const Cell& cell, std::uint32_t index) {
        for (VertexId v = cell.corner[0]; v < cell.corner[3]; ++v)
            on_right_[v] = index;
        for (VertexId v = cell.corner[1]; v < cell.corner[2]; ++v)
            on_left_[v] = index;
    }

    /// Collects the narrow rows of a column.
    void collect(const ColumnSpan& column) {
        rows_.clear();
        const VertexId last = column.first + column.count - 1;
        for (VertexId v = column.first; v < last;) {
            Row row{on_left_[v], on_right_[v], on_left_[v], on_right_[v], v, v};
            if (row.left_young == no_cell || row.right_young == no_cell ||
                cell(row.left_young).corner[1] != v || cell(row.right_young).corner[0] != v) {
                ++v;
                continue;
            }
            VertexId left = cell(row.left_young).corner[2];
            VertexId right = cell(row.right_young).corner[3];
            bool plain = true;
            while (left != right && plain) {
                std::uint32_t& behind = left < right ? row.left_old : row.right_old;
                const std::uint32_t next = left < right ? on_left_[left] : on_right_[right];
                plain = next != no_cell && stacked(cell(behind), cell(next));
                behind = next;
                if (plain)
                    (left < right ? left : right) =
                        left < right ? cell(next).corner[2] : cell(next).corner[3];
            }
            v = row.to = std::max(left, right);
            if (plain && joinable(row))
                rows_.push_back(row);
        }
    }

    /// Returns true where one cell stands on the whole old side of another.
    static bool stacked(const Cell& young, const Cell& old) {
        return young.corner[2] == old.corner[1] && young.corner[3] == old.corner[0] &&
               young.mid[2] == no_vertex && old.mid[0] == no_vertex;
    }

    static int mids(const Cell& a, const Cell& b, std::size_t side) {
        return (a.mid[side] != no_vertex) + (b.mid[side] != no_vertex);
    }

    bool joinable(Row& row) {
        if (mids(cell(row.left_young), cell(row.right_young), 0) > 1 ||
            mids(cell(row.left_old), cell(row.right_old), 2) > 1)
            return false;
        const Vec3 column = position_[row.to] - position_[row.from];
        const Vec3 front =
            position_[cell(row.right_young).corner[1]] - position_[cell(row.left_young).corner[0]];
        const Vec3 area = glm::cross(front, column);
        const double square = glm::dot(column, column);
        const double widest = hysteresis * limits_.joined;
        if (glm::dot(area, area) > widest * widest * square)
            return false; // most rows, without a root
        const Vec3 along = column / std::sqrt(square);
        bool old_begins = false;
        const bool narrow_on = narrow(cell(row.left_young).corner[0], row.from,
                                      cell(row.right_young).corner[1], along, row.begins) &&
                               narrow(cell(row.left_old).corner[3], row.to,
                                      cell(row.right_old).corner[2], along, old_begins);
        row.begins = row.begins && old_begins;
        return narrow_on &&
               stays_flat({cell(row.left_young).corner[0], cell(row.right_young).corner[1],
                           cell(row.right_old).corner[2], cell(row.left_old).corner[3]});
    }

    /// Would a cell with these corners, across the column, meet the cells beside it at no more than it may?
    bool stays_flat(const std::array<VertexId, 4>& corner) {
        if (limits_.neighbour_cosine <= -1.0)
            return true;
        const Vec3 joined = diagonals_cross(corner);
        for (VertexId v = corner[0]; v < corner[3];) {
            const std::uint32_t beside = on_left_[v];
            if (beside != no_cell && bends(joined, diagonals_cross(cell(beside).corner)))
                return false;
            v = beside == no_cell ? v + 1 : cell(beside).corner[2];
        }
        for (VertexId v = corner[1]; v < corner[2];) {
            const std::uint32_t beside = on_right_[v];
            if (beside != no_cell && bends(joined, diagonals_cross(cell(beside).corner)))
                return false;
            v = beside == no_cell ? v + 1 : cell(beside).corner[3];
        }
        return true;
    }

    Vec3 diagonals_cross(const std::array<VertexId, 4>& corner) const {
        return glm::cross(position_[corner[2]] - position_[corner[0]],
                          position_[corner[3]] - position_[corner[1]]);
    }

    bool bends(const Vec3& a, const Vec3& b) const {
        return glm::dot(a, b) <
               limits_.neighbour_cosine * std::sqrt(glm::dot(a, a) * glm::dot(b, b));
    }

    /// Widths count square to the column, whose direction is the unit vector `along`: skew fronts are long
    /// but not wide, and do not make the surface turn.
    bool narrow(VertexId a, VertexId middle, VertexId b, const Vec3& along, bool& begins) {
        const Vec3 first = position_[middle] - position_[a];
        const Vec3 second = position_[b] - position_[middle];
        const Vec3 across_first = first - along * glm::dot(first, along);
        const Vec3 across_second = second - along * glm::dot(second, along);
        const double first_square = glm::dot(across_first, across_first);
        const double second_square = glm::dot(across_second, across_second);
        const double product = glm::dot(across_first, across_second);
        if (product < limits_.least_cosine * std::sqrt(first_square * second_square))
            return false;
        const double longer = std::max(first_square, second_square);
        const double joined = first_square + second_square + 2.0 * product;
        const auto within = [&](double part) {
            return joined <= part * part * limits_.joined * limits_.joined &&
                   longer <= part * part * limits_.each * limits_.each;
        };
        if (!within(hysteresis))
            return false;
        begins = within(1.0);
        return true;
    }

    /// The cell below the split a column was born in, if the column's first vertex hangs on it and on nothing
    /// else.
    std::uint32_t birth_cell(const ColumnSpan& column, const Row& row) {
        const Cell& left = cell(row.left_young);
        const VertexId corner = left.corner[0];
        if (row.from != column.first || corner == 0)
            return no_cell;
        const std::uint32_t below = on_right_[corner - 1];
        return below != no_cell && cell(below).corner[3] == corner &&
                       cell(below).mid[2] == column.first
                   ? below
                   : no_cell;
    }

    /// Returns true if the younger side of the first merged row can be left as it is.
    bool may_begin(const Row& row) {
        return mids(cell(row.left_young), cell(row.right_young), 0) == 0;
    }

    bool on_outline(const ColumnSpan& column, const Row& row) const {
        return row.to == column.first + column.count - 1;
    }

    bool may_end(const ColumnSpan& column, const Row& row) {
        return mids(cell(row.left_old), cell(row.right_old), 2) == 0 || droppable(column, row);
    }

    /// True where the sheet ends and the joined side is as good as straight.
    bool droppable(const ColumnSpan& column, const Row& row) {
        if (!on_outline(column, row))
            return false;
        const Vec3 a = position_[cell(row.left_old).corner[3]];
        const Vec3 side = position_[cell(row.right_old).corner[2]] - a;
        const Vec3 off = position_[row.to] - a;
        const double square = glm::dot(side, side);
        return square > 0.0 && glm::length(glm::cross(off, side)) < outline_shift * square;
    }

    /// Zips the columns on either side of rows [begin, end) again, piece by piece between what begins or ends
    /// there.
    bool join(const ColumnSpan& column, std::size_t begin, std::size_t end) {
        made_.clear();
        std::size_t first = begin;
        for (std::size_t i = begin; i < end; ++i)
            if (i + 1 == end || !stacked(cell(rows_[i].left_old), cell(rows_[i + 1].left_young)) ||
                !stacked(cell(rows_[i].right_old), cell(rows_[i + 1].right_young))) {
                if (!zip(rows_[first], rows_[i]))
                    return false;
                first = i + 1;
            }
        const std::uint32_t birth = birth_cell(column, rows_[begin]);
        if (birth != no_cell)
            cell(birth).mid[2] = no_vertex;
        else
            made_.front().mid[0] = rows_[begin].from;
        if (!droppable(column, rows_[end - 1]))
            made_.back().mid[2] = rows_[end - 1].to;
        free_.clear();
        for (VertexId v = rows_[begin].from; v < rows_[end - 1].to; ++v) {
            for (const std::uint32_t gone : {on_left_[v], on_right_[v]})
                if (cell(gone).corner[0] != no_vertex) {
                    cell(gone).corner[0] = no_vertex;
                    free_.push_back(gone);
                }
            on_left_[v] = on_right_[v] = no_cell;
        }
        for (std::size_t i = 0; i < made_.size(); ++i) { // never more than there were
            cell(free_[i]) = made_[i];
            put(made_[i], free_[i]);
        }
        return true;
    }

    /// Appends to made_ the cells that take the place of rows `young` to `old`, between which the columns on
    /// either side stay the same. Returns false where a front would be too long, cross an obstacle or bend.
    bool zip(const Row& young, const Row& old) {
        const auto either = [](VertexId a, VertexId b) { return a != no_vertex ? a : b; };
        const VertexId left = cell(young.left_young).corner[0];
        const VertexId right = cell(young.right_young).corner[1];
        const std::size_t left_count = cell(old.left_old).corner[3] - left;
        const std::size_t right_count = cell(old.right_old).corner[2] - right;
        const std::span<const Vec3> left_side = position_.subspan(left, left_count + 1);
        const std::span<const Vec3> right_side = position_.subspan(right, right_count + 1);
        const Vec3 front = left_side[0] - right_side[0];
        if (glm::dot(front, front) > limits_.rules.separation * limits_.rules.separation)
            return false;
        const std::size_t from = made_.size();
        for (StripFront at; at.left < left_count || at.right < right_count;) {
            const auto step =
                next_quad(limits_.rules, left_side, right_side, at, ZipMode::ToBothEnds);
            if (!step)
                return false;
            const VertexId l = left + static_cast<VertexId>(at.left);
            const VertexId r = right + static_cast<VertexId>(at.right);
            Cell& quad = made_.emplace_back();
            quad.corner = {l, r, r + static_cast<VertexId>(step->right),
                           l + static_cast<VertexId>(step->left)};
            if (!stays_flat(quad.corner))
                return false;
            if (step->right == 2)
                quad.mid[1] = r + 1;
            if (step->left == 2)
                quad.mid[3] = l + 1;
            at.left += step->left;
            at.right += step->right;
        }
        made_[from].mid[0] = either(cell(young.left_young).mid[0], cell(young.right_young).mid[0]);
        made_.back().mid[2] = either(cell(old.left_old).mid[2], cell(old.right_old).mid[2]);
        return true;
    }

    std::vector<Cell>& cells_;
    std::span<const Vec3> position_;
    MergeLimits limits_;
    /// The cell left of the column's segment that begins at a vertex.
    std::vector<std::uint32_t> on_left_;
    std::vector<std::uint32_t> on_right_; ///< and the one to its right
    std::vector<Row> rows_;
    std::vector<Cell> made_;
    std::vector<std::uint32_t> free_; ///< places of the cells that made_ replaces
};

} // namespace

void merge_columns(std::vector<Cell>& cells,
                   std::span<const ColumnSpan> columns,
                   std::span<const Vec3> position,
                   const MergeLimits& limits,
                   const std::stop_token& stop) {
    ColumnMerger merger(cells, position, limits);
    for (const ColumnSpan& column : columns)
        if (!stop.stop_requested())
            merger.merge(column);
    merger.drop_dead_cells();
}

} // namespace wakesurf::core
