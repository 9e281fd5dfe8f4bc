#include "protocol/wire_edit.hpp"

#include "protocol/cells_code.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace wakesurf::protocol {

namespace {

using core::Error;
using core::no_vertex;

tl::unexpected<Error> corrupt(std::string message) {
    return core::fail(Error::Code::Corrupt, std::move(message), "subscribe to the surface again");
}

void append_runs(Bytes& bytes, const Runs& runs) {
    append_varint(bytes, static_cast<std::uint32_t>(runs.all().size()));
    std::uint32_t at = 0;
    for (const Run& run : runs.all()) {
        append_varint(bytes, run.begin - at);
        append_varint(bytes, run.end - run.begin);
        at = run.end;
    }
}

/// Reads the edit's numbers one after the other; once something does not fit, all that follows is empty.
class EditReader {
  public:
    explicit EditReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    bool failed() const { return failed_; }

    std::uint32_t number() {
        const auto value = failed_ ? std::nullopt : take_varint(bytes_, at_);
        failed_ = !value;
        return value.value_or(0);
    }

    Runs runs(std::uint32_t over) {
        Runs runs;
        std::uint64_t at = 0;
        for (std::uint32_t left = number(); left > 0 && !failed_; --left) {
            const std::uint64_t begin = at + number();
            const std::uint64_t end = begin + number();
            failed_ = failed_ || begin == end || end > over;
            if (!failed_)
                runs.take({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
            at = end;
        }
        return runs;
    }

    std::span<const std::byte> rest() const { return bytes_.subspan(at_); }

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

/// The cell's vertices in their new numbers; false when it has lost a corner.
bool follow(core::Cell& cell, std::span<const std::uint32_t> now) {
    bool whole = true;
    for (std::uint32_t& v : cell.corner) {
        v = now[v];
        whole = whole && v != no_vertex;
    }
    for (std::uint32_t& v : cell.mid)
        v = v == no_vertex ? no_vertex : now[v];
    return whole;
}

} // namespace

std::vector<std::uint32_t> numbers_after(const Runs& removed, std::uint32_t count) {
    std::vector<std::uint32_t> now(count);
    std::uint32_t at = 0;
    std::uint32_t next = 0;
    for (const Run& run : removed.all()) {
        while (at < run.begin)
            now[at++] = next++;
        while (at < run.end)
            now[at++] = no_vertex;
    }
    while (at < count)
        now[at++] = next++;
    return now;
}

void Runs::take(Run run, std::uint32_t bridge) {
    if (!runs_.empty() && run.begin - runs_.back().end <= bridge) {
        count_ += run.end - runs_.back().end;
        runs_.back().end = run.end;
    } else {
        count_ += run.end - run.begin;
        runs_.push_back(run);
    }
}

Bytes write_edit(const TopologyEdit& edit) {
    Bytes bytes;
    append_runs(bytes, edit.removed_vertices);
    append_varint(bytes, edit.added_vertices);
    append_runs(bytes, edit.moved_vertices);
    append_runs(bytes, edit.removed_cells);
    append_runs(bytes, edit.replaced_cells);
    append_varint(bytes, edit.added_cells);
    CellsEncoder cells;
    for (const core::Cell& cell : edit.cells)
        cells.put(cell);
    const Bytes code = cells.finish();
    bytes.insert(bytes.end(), code.begin(), code.end());
    return bytes;
}

core::Result<TopologyEdit>
read_edit(std::span<const std::byte> bytes, MeshSize before, MeshSize after) {
    EditReader in(bytes);
    TopologyEdit edit;
    edit.removed_vertices = in.runs(before.vertices);
    edit.added_vertices = in.number();
    const std::uint32_t vertices_stay = before.vertices - edit.removed_vertices.count();
    edit.moved_vertices = in.runs(vertices_stay);
    edit.removed_cells = in.runs(before.cells);
    const std::uint32_t cells_stay = before.cells - edit.removed_cells.count();
    edit.replaced_cells = in.runs(cells_stay);
    edit.added_cells = in.number();
    if (in.failed())
        return corrupt("the topology of a mesh update is damaged");
    if (std::uint64_t{vertices_stay} + edit.added_vertices != after.vertices ||
        std::uint64_t{cells_stay} + edit.added_cells != after.cells)
        return corrupt(fmt::format("a mesh update leads to another number of vertices or cells "
                                   "than {} and {}",
                                   after.vertices, after.cells));
    if (auto fine = decode_cells(in.rest(), edit.replaced_cells.count() + edit.added_cells,
                                 after.vertices, edit.cells);
        !fine)
        return tl::unexpected(fine.error());
    return edit;
}

core::Result<std::vector<core::Cell>> edit_cells(const TopologyEdit& edit,
                                                 std::span<const core::Cell> before,
                                                 std::uint32_t vertices_before) {
    std::vector<core::Cell> cells = without(edit.removed_cells, before);
    auto source = edit.cells.begin();
    std::size_t kept = 0;
    const bool renumber = edit.removed_vertices.count() > 0;
    const auto now = renumber ? numbers_after(edit.removed_vertices, vertices_before)
                              : std::vector<std::uint32_t>{};
    bool whole = true;
    const auto keep_until = [&](std::size_t end) {
        if (renumber)
            for (std::size_t i = kept; i < end; ++i)
                whole = follow(cells[i], now) && whole;
    };
    for (const Run& run : edit.replaced_cells.all()) {
        keep_until(run.begin);
        for (std::uint32_t i = run.begin; i < run.end; ++i)
            cells[i] = *source++;
        kept = run.end;
    }
    keep_until(cells.size());
    if (!whole)
        return corrupt("a mesh update takes a corner from a cell that stays");
    cells.insert(cells.end(), source, edit.cells.end());
    return cells;
}

} // namespace wakesurf::protocol
