// The topology of an update: which vertices and cells go, come and change, as runs and a cells code.
// protocol/wire/README.md, Topology. Twin: web-client/src/protocol/wireEdit.ts.
#pragma once

#include "core/base/result.hpp"
#include "protocol/wire/bytes.hpp"
#include "protocol/wire/kept_cells.hpp"

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

    /// Cells stay as they are and keep their vertices' numbers.
    bool keeps_topology() const {
        return removed_vertices.count() == 0 && added_vertices == 0 && removed_cells.count() == 0 &&
               cells.empty();
    }

    bool operator==(const TopologyEdit&) const = default;
};

/// How many vertices or cells there are.
struct MeshSize {
    std::uint32_t vertices = 0;
    std::uint32_t cells = 0;
};

/// @param kept  the cells that stay, the replaced ones left out
Bytes write_edit(const TopologyEdit& edit, const KeptCells& kept);

/// The state an edit starts from.
struct EditedFrom {
    std::uint32_t vertices = 0;
    std::span<const core::Cell> cells;
};

struct ReadEdit {
    TopologyEdit edit;
    KeptCells kept; ///< the replaced ones as they were
};

/// Error: Corrupt when it is damaged, does not lead from `before` to `after`, or takes a corner from a cell that stays.
/// Allocates O(before + after) at most.
core::Result<ReadEdit>
read_edit(std::span<const std::byte> bytes, const EditedFrom& before, MeshSize after);

/// The cells after the edit, from those that stay.
std::vector<core::Cell> edited_cells(std::vector<core::Cell> kept, const TopologyEdit& edit);

} // namespace wakesurf::protocol
