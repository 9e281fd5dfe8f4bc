#include "protocol/wire/wire_edit.hpp"

#include "protocol/wire/cells_code.hpp"

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

/// Whether a cell that stays and is not replaced has lost a corner.
bool corner_lost(const KeptCells& kept, const Runs& replaced) {
    bool lost = false;
    if (!kept.now.empty())
        for_each_gap(replaced, static_cast<std::uint32_t>(kept.cells.size()),
                     [&](std::uint32_t begin, std::uint32_t end) {
                         for (std::uint32_t i = begin; i < end; ++i)
                             for (const std::uint32_t corner : kept.cells[i].corner)
                                 lost = lost || corner == no_vertex;
                     });
    return lost;
}

} // namespace

Bytes write_edit(const TopologyEdit& edit, const KeptCells& kept) {
    Bytes bytes;
    append_runs(bytes, edit.removed_vertices);
    append_varint(bytes, edit.added_vertices);
    append_runs(bytes, edit.moved_vertices);
    append_runs(bytes, edit.removed_cells);
    append_runs(bytes, edit.replaced_cells);
    append_varint(bytes, edit.added_cells);
    const Bytes code =
        encode_cells(edit.cells, {kept.stay + edit.added_vertices, kept, edit.replaced_cells});
    bytes.insert(bytes.end(), code.begin(), code.end());
    return bytes;
}

core::Result<ReadEdit>
read_edit(std::span<const std::byte> bytes, const EditedFrom& before, MeshSize after) {
    EditReader in(bytes);
    const auto cells_before = static_cast<std::uint32_t>(before.cells.size());
    TopologyEdit edit;
    edit.removed_vertices = in.runs(before.vertices);
    edit.added_vertices = in.number();
    const std::uint32_t vertices_stay = before.vertices - edit.removed_vertices.count();
    edit.moved_vertices = in.runs(vertices_stay);
    edit.removed_cells = in.runs(cells_before);
    const std::uint32_t cells_stay = cells_before - edit.removed_cells.count();
    edit.replaced_cells = in.runs(cells_stay);
    edit.added_cells = in.number();
    if (in.failed())
        return corrupt("the topology of a mesh update is damaged");
    if (std::uint64_t{vertices_stay} + edit.added_vertices != after.vertices ||
        std::uint64_t{cells_stay} + edit.added_cells != after.cells)
        return corrupt(fmt::format("a mesh update leads to another number of vertices or cells "
                                   "than {} and {}",
                                   after.vertices, after.cells));
    KeptCells kept;
    if (!edit.keeps_topology() || edit.replaced_cells.count() + edit.added_cells > 0) {
        kept = keep_cells(edit.removed_vertices, before.vertices, edit.removed_cells, before.cells);
        kept.leave_out(edit.replaced_cells);
        if (corner_lost(kept, edit.replaced_cells))
            return corrupt("a mesh update takes a corner from a cell that stays");
    }
    auto cells = decode_cells(in.rest(), edit.replaced_cells.count() + edit.added_cells,
                              {after.vertices, kept, edit.replaced_cells});
    if (!cells)
        return tl::unexpected(cells.error());
    edit.cells = std::move(*cells);
    return ReadEdit{std::move(edit), std::move(kept)};
}

std::vector<core::Cell> edited_cells(std::vector<core::Cell> kept, const TopologyEdit& edit) {
    auto source = edit.cells.begin();
    for (const Run& run : edit.replaced_cells.all())
        for (std::uint32_t i = run.begin; i < run.end; ++i)
            kept[i] = *source++;
    kept.insert(kept.end(), source, edit.cells.end());
    return kept;
}

} // namespace wakesurf::protocol
