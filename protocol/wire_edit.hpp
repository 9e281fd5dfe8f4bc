// The topology of an update: which vertices and cells go, come and change, as runs and a cells code.
// protocol/README.md, Topology. Twin: web-client/src/protocol/wireEdit.ts.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/bytes.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::protocol {

/// Things begin .. end - 1 of a list.
struct Run {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    bool operator==(const Run&) const = default;
};

/// Disjoint and ascending.
class Runs {
  public:
    /// REQUIRES: `index` is above everything taken so far.
    void take(std::uint32_t index) { take({index, index + 1}); }

    /// A gap of less than `bridge` things to the run before is taken as well.
    void take(Run run, std::uint32_t bridge = 0);

    std::span<const Run> all() const { return runs_; }

    std::uint32_t count() const { return count_; }

    bool operator==(const Runs&) const = default;

  private:
    std::vector<Run> runs_;
    std::uint32_t count_ = 0;
};

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

Bytes write_edit(const TopologyEdit& edit);

/// Error: Corrupt when it is damaged or does not lead from `before` to `after`. Allocates O(after) at most.
core::Result<TopologyEdit>
read_edit(std::span<const std::byte> bytes, MeshSize before, MeshSize after);

/// The number each of `count` things has when the removed ones are gone, `core::no_vertex` for those.
std::vector<std::uint32_t> numbers_after(const Runs& removed, std::uint32_t count);

/// The cells after the edit. Removed mids are gone from the cells that stay. Error: Corrupt when one has lost a corner.
core::Result<std::vector<core::Cell>> edit_cells(const TopologyEdit& edit,
                                                 std::span<const core::Cell> before,
                                                 std::uint32_t vertices_before);

/// The things that stay where `removed` go, in order.
template <class T>
std::vector<T> without(const Runs& removed, std::span<const T> things) {
    std::vector<T> left;
    left.reserve(things.size() - removed.count());
    std::size_t at = 0;
    for (const Run& run : removed.all()) {
        left.insert(left.end(), things.begin() + static_cast<std::ptrdiff_t>(at),
                    things.begin() + static_cast<std::ptrdiff_t>(run.begin));
        at = run.end;
    }
    left.insert(left.end(), things.begin() + static_cast<std::ptrdiff_t>(at), things.end());
    return left;
}

} // namespace wakesurf::protocol
