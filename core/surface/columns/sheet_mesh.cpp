#include "core/surface/columns/sheet_mesh.hpp"

#include <utility>

namespace wakesurf::core {

namespace {

/// Vertex ids of every column of every strip; neighbouring strips share the ids of the column between them.
class ColumnIds {
  public:
    static constexpr VertexId used = no_vertex - 1;

    explicit ColumnIds(const Sheet& sheet)
        : strips_(sheet.strips()), closed_(sheet.closed()), ends_(strips_.size() + 1),
          inner_(strips_.size()) {
        for (std::size_t i = 0; i < strips_.size(); ++i) {
            const std::vector<Column>& columns = strips_[i].columns();
            ends_[i].assign(columns[Strip::left_column].points.size(), no_vertex);
            ends_[i + 1].assign(columns[Strip::right_column].points.size(), no_vertex);
            for (std::size_t c = 2; c < columns.size(); ++c)
                inner_[i].emplace_back(columns[c].points.size(), no_vertex);
        }
        for (std::size_t i = 0; i < strips_.size(); ++i)
            for (const StripCell& cell : strips_[i].cells())
                for (std::size_t k = 0; k < 4; ++k) {
                    at(i, cell.corner[k]) = used;
                    if (cell.mid[k].exists())
                        at(i, cell.mid[k]) = used;
                }
    }

    std::vector<VertexId>& column(std::size_t strip, std::uint32_t column) {
        if (column == Strip::left_column)
            return ends_[strip];
        if (column == Strip::right_column)
            return ends_[closed_ && strip + 1 == strips_.size() ? 0 : strip + 1];
        return inner_[strip][column - 2];
    }

    VertexId& at(std::size_t strip, StripVertex v) { return column(strip, v.column)[v.index]; }

  private:
    const std::vector<Strip>& strips_;
    bool closed_;
    std::vector<std::vector<VertexId>> ends_;
    std::vector<std::vector<std::vector<VertexId>>> inner_;
};

void append_column(SheetMesh& mesh,
                   const Column& column,
                   std::vector<VertexId>& ids,
                   bool from_rake) {
    for (std::size_t k = 0; k < ids.size(); ++k) {
        if (ids[k] != ColumnIds::used)
            continue;
        const auto next = static_cast<VertexId>(mesh.complex.vertices());
        ids[k] =
            from_rake && k == 0 ? mesh.on_rake.try_emplace(column.s, next).first->second : next;
        if (ids[k] != next)
            continue; // the sheet of the other direction made it
        const CurvePoint& point = column.points[k];
        mesh.complex.position.push_back(point.position);
        mesh.complex.s.push_back(column.s);
        mesh.complex.t.push_back(point.time);
        mesh.complex.approximated.push_back(0);
        mesh.stretch.push_back(point.stretch);
    }
}

Cell cell_of(const StripCell& cell, std::size_t strip, ColumnIds& ids, bool upstream) {
    Cell made;
    for (std::size_t k = 0; k < 4; ++k) {
        made.corner[k] = ids.at(strip, cell.corner[k]);
        if (cell.mid[k].exists())
            made.mid[k] = ids.at(strip, cell.mid[k]);
    }
    if (upstream) { // mirrored, so that both sheets of a rake face the same way
        std::swap(made.corner[0], made.corner[1]);
        std::swap(made.corner[2], made.corner[3]);
        std::swap(made.mid[1], made.mid[3]);
    }
    return made;
}

} // namespace

void append_sheet(SheetMesh& mesh, const Sheet& sheet) {
    const std::vector<Strip>& strips = sheet.strips();
    ColumnIds ids(sheet);
    for (std::size_t i = 0; i < strips.size(); ++i) {
        const std::vector<Column>& columns = strips[i].columns();
        append_column(mesh, columns[Strip::left_column], ids.column(i, Strip::left_column), true);
        for (std::uint32_t c = 2; c < columns.size(); ++c)
            append_column(mesh, columns[c], ids.column(i, c), false);
        if (i + 1 == strips.size() && !sheet.closed())
            append_column(mesh, columns[Strip::right_column], ids.column(i, Strip::right_column),
                          true);
    }
    for (std::size_t i = 0; i < strips.size(); ++i)
        for (const StripCell& cell : strips[i].cells())
            mesh.complex.cells.push_back(cell_of(cell, i, ids, sheet.upstream()));
}

} // namespace wakesurf::core
