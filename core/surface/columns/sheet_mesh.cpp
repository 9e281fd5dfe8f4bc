#include "core/surface/columns/sheet_mesh.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/columns/column_merge.hpp"
#include "core/surface/columns/curve_errors.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace wakesurf::core {

namespace {

/// Numbers the vertices of all columns of a sheet, column by column along the rake; neighbouring strips share
/// the numbers of the column between them.
class ColumnNumbers {
  public:
    explicit ColumnNumbers(const Sheet& sheet) : strips_(sheet.strips()), closed_(sheet.closed()) {
        first_.resize(strips_.size());
        for (std::size_t i = 0; i < strips_.size(); ++i) {
            const std::vector<StripColumn>& columns = strips_[i].columns();
            first_[i].assign(columns.size(), no_vertex);
            // Seeds merge after what was inserted between them, every second one first.
            first_[i][Strip::left_column] =
                add(columns[Strip::left_column], i == 0 ? never : std::countr_zero(i));
            strips_[i].for_each_inner_column(
                [&](std::uint32_t c) { first_[i][c] = add(columns[c], -columns[c].depth); });
        }
        if (!closed_ && !strips_.empty())
            end_ = add(strips_.back().columns()[Strip::right_column], never);
    }

    VertexId of(std::size_t strip, StripVertex v) const {
        if (!v.exists())
            return no_vertex;
        if (v.column != Strip::right_column)
            return first_[strip][v.column] + v.index;
        if (strip + 1 < strips_.size())
            return first_[strip + 1][Strip::left_column] + v.index;
        return (closed_ ? first_[0][Strip::left_column] : end_) + v.index;
    }

    struct Entry {
        StripColumn column;
        ColumnSpan span;
        int order; ///< when it may be merged away
    };

    static constexpr int never = 1 << 30;

    const std::vector<Entry>& entries() const { return entries_; }

    VertexId count() const { return count_; }

  private:
    VertexId add(const StripColumn& column, int order) {
        const auto vertices = static_cast<VertexId>(column.column->position.size());
        entries_.push_back({column, {count_, vertices}, order});
        return std::exchange(count_, count_ + vertices);
    }

    const std::vector<Strip>& strips_;
    bool closed_;
    std::vector<Entry> entries_;
    std::vector<std::vector<VertexId>> first_; ///< by strip and column
    VertexId end_ = no_vertex;                 ///< of an open rake's last column
    VertexId count_ = 0;
};

std::vector<Cell> cells_of(const Sheet& sheet, const ColumnNumbers& numbers) {
    const std::vector<Strip>& strips = sheet.strips();
    std::vector<std::size_t> first{0};
    for (const Strip& strip : strips)
        first.push_back(first.back() + strip.quads());
    std::vector<Cell> cells(first.back());
    for_each_index(
        strips.size(),
        [&](std::size_t i) {
            Cell* cell = cells.data() + first[i];
            strips[i].for_each_cell([&](const StripCell& from) {
                for (std::size_t k = 0; k < 4; ++k) {
                    cell->corner[k] = numbers.of(i, from.corner[k]);
                    cell->mid[k] = numbers.of(i, from.mid[k]);
                }
                ++cell;
            });
            assert(cell == cells.data() + first[i + 1]);
        },
        1);
    return cells;
}

void merge(const Sheet& sheet,
           const ColumnNumbers& numbers,
           std::vector<Cell>& cells,
           const std::stop_token& stop) {
    const SheetOptions& options = sheet.options();
    if (options.merge <= 0.0)
        return;
    std::vector<const ColumnNumbers::Entry*> order;
    for (const auto& entry : numbers.entries())
        if (entry.order != ColumnNumbers::never)
            order.push_back(&entry);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto* a, const auto* b) { return a->order < b->order; });
    std::vector<ColumnSpan> columns;
    for (const auto* entry : order)
        columns.push_back(entry->span);
    std::vector<Vec3> position;
    position.reserve(numbers.count());
    for (const auto& entry : numbers.entries())
        position.insert(position.end(), entry.column.column->position.begin(),
                        entry.column.column->position.end());
    // Two cells meet at half the angle: one across both is off either by a quarter of it.
    const double angle = options.angle * std::numbers::pi / 180.0;
    const double joined = 2.0 * options.merge * options.separation;
    merge_columns(cells, columns, position,
                  {sheet.rules(), 0.65 * joined, joined, std::cos(0.5 * angle), std::cos(angle)},
                  stop);
}

/// Appends the vertices in use and returns what each is called in the mesh.
std::vector<VertexId> append_vertices(SheetMesh& mesh,
                                      const ColumnNumbers& numbers,
                                      const std::vector<Cell>& cells,
                                      const std::stop_token& stop) {
    constexpr VertexId used = no_vertex - 1;
    std::vector<VertexId> id(numbers.count(), no_vertex);
    for (const Cell& cell : cells)
        for (std::size_t k = 0; k < 4; ++k) {
            id[cell.corner[k]] = used;
            if (cell.mid[k] != no_vertex)
                id[cell.mid[k]] = used;
        }
    std::vector<const SeededCurve*> curves;
    for (const auto& entry : numbers.entries())
        curves.push_back(entry.column.curve);
    const CurveErrors errors(std::move(curves), stop);
    QuadComplex& complex = mesh.complex;
    const std::size_t before = complex.vertices();
    std::size_t total = before;
    for (const auto& entry : numbers.entries())
        for (VertexId k = 0; k < entry.span.count; ++k) {
            VertexId& own = id[entry.span.first + k];
            if (own != used)
                continue;
            const auto next = static_cast<VertexId>(total);
            own = entry.column.depth == 0 && k == 0
                      ? mesh.on_rake.try_emplace(entry.column.curve->s, next).first->second
                      : next;
            total += own == next; // else the sheet of the other direction made it
        }
    complex.position.resize(total);
    complex.s.resize(total);
    complex.t.resize(total);
    complex.approximated.resize(total, 0);
    complex.error.resize(total);
    mesh.stretch.resize(total);
    for_each_index(
        numbers.entries().size(),
        [&](std::size_t i) {
            const auto& entry = numbers.entries()[i];
            const Column& column = *entry.column.column;
            for (VertexId k = 0; k < entry.span.count && !stop.stop_requested(); ++k) {
                const VertexId own = id[entry.span.first + k];
                if (own == no_vertex || own < before)
                    continue;
                complex.position[own] = column.position[k];
                complex.s[own] = entry.column.curve->s;
                complex.t[own] = column.time[k];
                complex.error[own] = errors.at(entry.column.curve, column.arc[k]);
                mesh.stretch[own] = column.stretch[k];
            }
        },
        8);
    return id;
}

} // namespace

bool append_sheet(SheetMesh& mesh, const Sheet& sheet, const std::stop_token& stop) {
    const ColumnNumbers numbers(sheet);
    std::vector<Cell> cells = cells_of(sheet, numbers);
    if (!stop.stop_requested())
        merge(sheet, numbers, cells, stop);
    if (stop.stop_requested())
        return false;
    const std::vector<VertexId> id = append_vertices(mesh, numbers, cells, stop);
    if (stop.stop_requested())
        return false;
    for_each_index(cells.size(), [&](std::size_t i) {
        Cell& cell = cells[i];
        for (std::size_t k = 0; k < 4; ++k) {
            cell.corner[k] = id[cell.corner[k]];
            if (cell.mid[k] != no_vertex)
                cell.mid[k] = id[cell.mid[k]];
        }
        if (sheet.upstream())
            cell = mirror(cell); // both sheets of a rake face the same way
    });
    if (mesh.complex.cells.empty())
        mesh.complex.cells = std::move(cells);
    else
        mesh.complex.cells.insert(mesh.complex.cells.end(), cells.begin(), cells.end());
    return true;
}

} // namespace wakesurf::core
