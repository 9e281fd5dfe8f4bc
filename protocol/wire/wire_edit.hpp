// The topology of an update: the vertices and cells that are removed, added and changed.
// protocol/wire/FORMAT.md, Topology. Twin: web-client/src/protocol/wireEdit.ts.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/wire/numbers.hpp"
#include "protocol/wire/wire_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// New cells as numbers: slot by slot, each vertex as the difference from the one it replaces, or else from
/// one that it is near. protocol/wire/FORMAT.md, Topology. Twin: readCells in
/// web-client/src/protocol/wireEdit.ts.
/// Holds what both ends know of the new cells.
struct CellContext {
    /// The old cells that the first of the new ones replace, one each.
    std::span<const core::Cell> replaced;
    std::uint32_t stay = 0;     ///< vertices that were there before
    std::uint32_t vertices = 0; ///< after the update
};

/// Appends new cells. REQUIRES: at least as many cells as are replaced.
void append_cells(std::vector<std::uint32_t>& numbers,
                  std::span<const core::Cell> cells,
                  const CellContext& context);

/// Reads `count` cells. Error: Corrupt. Allocates O(numbers) at most.
core::Result<std::vector<core::Cell>>
read_cells(Numbers& numbers, std::size_t count, const CellContext& context);

/// A selection of a list's elements, as runs of consecutive ones; and the list after some are removed.
/// protocol/wire/FORMAT.md, Topology. Twin: web-client/src/protocol/bytes.ts.
/// Stands for the elements begin .. end - 1 of a list.
struct Run {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    bool operator==(const Run&) const = default;
};

/// Holds disjoint, ascending runs.
class Runs {
  public:
    /// REQUIRES: `index` is above everything taken so far.
    void take(std::uint32_t index) { take({index, index + 1}); }

    /// Takes a run. A gap of at most `bridge` elements to the run before is taken as well.
    void take(Run run, std::uint32_t bridge = 0);

    std::span<const Run> all() const { return runs_; }

    std::uint32_t count() const { return count_; }

    bool operator==(const Runs&) const = default;

  private:
    std::vector<Run> runs_;
    std::uint32_t count_ = 0;
};

/// Returns the number that each of `count` elements has once the removed ones are gone, `core::no_vertex` for
/// those.
std::vector<std::uint32_t> numbers_after(const Runs& removed, std::uint32_t count);

/// Calls each(begin, end) for the runs of those of `count` elements that are not taken.
template <class Each>
void for_each_gap(const Runs& taken, std::uint32_t count, Each each) {
    std::uint32_t at = 0;
    for (const Run& run : taken.all()) {
        if (at < run.begin)
            each(at, run.begin);
        at = run.end;
    }
    if (at < count)
        each(at, count);
}

/// Returns the elements that stay, in order.
template <class T>
std::vector<T> without(const Runs& removed, std::span<const T> things) {
    std::vector<T> left;
    left.reserve(things.size() - removed.count());
    for_each_gap(removed, static_cast<std::uint32_t>(things.size()),
                 [&](std::uint32_t begin, std::uint32_t end) {
                     const auto run = things.subspan(begin, end - begin);
                     left.insert(left.end(), run.begin(), run.end());
                 });
    return left;
}

struct TopologyEdit {
    Runs removed_vertices; ///< of the old ones
    std::uint32_t added_vertices = 0;
    Runs moved_vertices; ///< of those that stay
    Runs removed_cells;  ///< of the old ones
    Runs replaced_cells; ///< of those that stay
    std::uint32_t added_cells = 0;
    std::vector<core::Cell> cells; ///< the replaced, then the added ones

    /// Says that old vertices and cells keep their numbers, and cells their vertices.
    bool only_adds() const {
        return removed_vertices.count() + removed_cells.count() + replaced_cells.count() == 0;
    }

    bool keeps_topology() const { return only_adds() && added_vertices == 0 && cells.empty(); }

    bool operator==(const TopologyEdit&) const = default;
};

/// Counts vertices and cells.
struct MeshSize {
    std::uint32_t vertices = 0;
    std::uint32_t cells = 0;
};

/// Counts the state that an edit starts from.
struct EditedFrom {
    std::uint32_t vertices = 0;
    std::span<const core::Cell> cells;
};

/// Returns the cells that stay, in the numbers that vertices have after the update; removed vertices are
/// `core::no_vertex`. Cost: O(before).
std::vector<core::Cell>
kept_cells(const Runs& removed_vertices, const Runs& removed_cells, const EditedFrom& before);

/// Appends an edit.
/// @param kept  the cells that stay, the replaced ones as they were; not read if none is replaced
/// @param stay  vertices that stay
void append_edit(std::vector<std::uint32_t>& numbers,
                 const TopologyEdit& edit,
                 std::span<const core::Cell> kept,
                 std::uint32_t stay);

struct ReadEdit {
    TopologyEdit edit;
    std::vector<core::Cell> kept; ///< the replaced ones as they were
};

/// Reads an edit. Error: Corrupt if it is damaged, does not lead from `before` to `after`, or takes a corner
/// from a cell that stays. Allocates O(before + numbers) at most.
core::Result<ReadEdit> read_edit(Numbers& numbers, const EditedFrom& before, MeshSize after);

/// Returns the cells after the edit, from those that stay.
std::vector<core::Cell> edited_cells(std::vector<core::Cell> kept, const TopologyEdit& edit);

/// An unfinished state: vertices that stay as they were, room for new ones, and what predictions need of the
/// state before. Both ends begin it alike and then fill it in, vertex by vertex.
struct WireDraft {
    WireMesh after;         ///< unfinished; `change` of moved vertices follows their positions
    std::uint32_t stay = 0; ///< vertices below are of the state before
    std::vector<LatticePoint> position_before; ///< of those that stay, like all that follow
    std::vector<LatticePoint> change_before;
    std::vector<std::vector<std::uint16_t>> codes_before;

    std::uint32_t vertices() const { return static_cast<std::uint32_t>(after.position.size()); }
};

/// Begins a draft. REQUIRES: the edit fits `before`.
/// @param edit      the vertices removed and added; the moved ones do not matter yet
/// @param topology  of the state after the edit
WireDraft begin_draft(const WireMesh& before,
                      const TopologyEdit& edit,
                      std::shared_ptr<const WireTopology> topology);

} // namespace wakesurf::protocol
