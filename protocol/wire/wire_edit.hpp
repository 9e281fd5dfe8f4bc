// The topology of an update: the vertices and cells that are removed, added and changed.
// protocol/wire/FORMAT.md, Topology. Twin: web-client/src/protocol/wireEdit.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/numbers.hpp"
#include "protocol/wire/runs.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

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

} // namespace wakesurf::protocol
