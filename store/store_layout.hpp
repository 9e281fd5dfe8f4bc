// The layout of a store: names and sizes of its files. It holds values only; store/store_manifest.hpp reads
// store.json's text, store_reader.hpp the files. The format: README.md here.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/brick_layout.hpp"
#include "core/dataset/cell_mesh.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/dataset/grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

inline constexpr std::string_view mask_file_name = "mask.u8";
inline constexpr std::string_view checksums_file_name = "checksums.u32";
inline constexpr std::string_view velocity_stem = "velocity";
inline constexpr std::string_view bricks_suffix = ".bricks";

/// The grid without its big arrays, which have files of their own.
struct StoredGrid {
    core::GridKind kind = core::GridKind::Uniform;    ///< which of the members below count
    core::UniformGrid uniform;                        ///< of Uniform
    std::array<std::uint32_t, 3> dimensions{0, 0, 0}; ///< nodes an axis, of Rectilinear
    std::uint64_t points = 0;                         ///< of Curvilinear and Unstructured
    std::uint64_t cells = 0;                          ///< of Curvilinear and Unstructured
    std::optional<core::SymmetryAxis> axis{};         ///< of Unstructured: see core::CellMesh
    core::PeriodicAxes periodic{};                    ///< where the flow goes on through the sides

    /// Nodes; 0 where they are too many to be counted.
    std::uint64_t nodes() const;
};

/// Describes a scalar field: one float a node and time-step, in files STEM_000000.f32 and so on.
struct StoredScalar {
    std::string name; ///< as the source calls it
    std::string stem; ///< of its files' names

    bool operator==(const StoredScalar&) const = default;
};

/// The files of a store.
struct StoreLayout {
    std::filesystem::path folder;                        ///< of the files
    StoredGrid grid;                                     ///< what all time-steps share
    std::vector<double> times;                           ///< strictly increasing
    core::Precision precision = core::Precision::Single; ///< of velocity and scalars
    std::vector<StoredScalar> scalars;                   ///< in the order of the columns
    std::uint32_t brick_cells = 0; ///< an axis of a brick; 0: whole time-steps
    /// True if each brick has a checksum, for time-steps in bricks. False for data that were not written as a
    /// store and are read as one.
    bool checked = true;
    bool may_have_gaps = false; ///< of bricks without checksums: some values may not be finite
    bool mask = false;          ///< mask.u8 is there
    bool walls = false;         ///< walls.f32 and walls.u32 are there
    /// Have the triangles of walls.u32, one patch after the other; empty: all are the body's.
    std::vector<core::BoundaryPatch> patches{};
    /// The CRC-32C of the files that all time-steps share.
    std::map<std::string, std::uint32_t> checksums;

    /// Returns the number of columns: velocity and the scalars.
    std::size_t columns() const { return 1 + scalars.size(); }

    /// Returns how the nodes lie in bricks. REQUIRES: brick_cells is not 0.
    core::BrickLayout bricks() const;
};

/// Describes a file of a time-step.
struct StepFile {
    std::string name;       ///< without the folder
    std::uint64_t size = 0; ///< bytes
};

/// Returns the numbers a node of a column: 0 is the velocity, then come the scalars.
inline std::size_t components_of(std::size_t column) {
    return column == 0 ? 3 : 1;
}

/// Returns a column's files at a time-step: the values and, for bricks that are checked, the bricks'
/// checksums. The CRC-32C of the last one, which is the record in checksums.u32, identifies the values.
std::vector<StepFile> step_files(const StoreLayout& layout, std::size_t column, std::size_t index);

/// Returns the files of a column that has another stem or precision than the layout knows.
std::vector<StepFile> step_files(const StoreLayout& layout,
                                 std::string_view stem,
                                 std::size_t components,
                                 core::Precision precision,
                                 std::size_t index);

/// A scalar that was made of the data and is kept beside them: a column after those of the layout, in single
/// precision. Several time-steps may share a file.
struct KeptColumn {
    std::string stem;                ///< of its files' names
    std::vector<std::uint32_t> file; ///< of each time-step: its number
    std::vector<std::uint32_t> sums; ///< of each file, as checksums.u32 has them

    bool operator==(const KeptColumn&) const = default;
};

/// Returns velocity_000000.f32 and so on.
std::string step_file_name(std::string_view stem, std::size_t index, core::Precision precision);

/// Returns the bytes of such a file.
std::size_t step_file_size(std::uint64_t nodes, std::size_t components, core::Precision precision);

/// Returns the bytes that opening the store takes at most for its grid and its mask, as far as the layout tells:
/// a few words of it can ask for more than a machine has.
std::uint64_t opening_bytes(const StoreLayout& layout);

/// Checks a layout. Error: InvalidArgument for times that do not rise, and for a grid thinner than 2 nodes,
/// with non-finite or non-positive spacing, without points or cells, or beyond the address space; also for
/// cells in bricks.
core::Result<void> check_layout(const StoreLayout& layout);
core::Result<void> check_grid(const StoredGrid& grid);
core::Result<void> check_bricks(const StoreLayout& layout);

/// Marks each field as stored or not in a store of this layout: as the velocity, a scalar, or a family.
void mark_stored(const StoreLayout& layout, core::DatasetInfo& info);

/// Returns the index into the layout's scalars. Error: NotFound, listing what there is.
core::Result<std::size_t> find_scalar(const StoreLayout& layout, std::string_view name);

/// The index of the bricks of a field at a time-step, in files like velocity_000000.bricks. Bricks are in the order of the file (BrickLayout::place_on_disk).
struct BrickIndex {
    std::vector<std::uint32_t> checksums; ///< CRC-32C of a brick's bytes
    std::vector<std::uint8_t> gaps;       ///< 1: some of its values are not finite; else 0

    explicit BrickIndex(std::size_t bricks) : checksums(bricks), gaps(bricks) {}

    /// Returns the bytes of the file: all checksums, then all gaps.
    static constexpr std::uint64_t bytes(std::uint64_t bricks) { return 5 * bricks; }

    bool any_gap() const;

    bool operator==(const BrickIndex&) const = default;
};

std::vector<std::byte> brick_index_bytes(const BrickIndex& index);

/// Parses the file. Error: Corrupt for another size, and a gap that is neither 0 nor 1; to be read after the
/// file's name.
core::Result<BrickIndex> parse_brick_index(std::span<const std::byte> bytes, std::size_t bricks);

/// The choice of whole time-steps or bricks for a new store.
enum class StepPlacement {
    /// Uses bricks where a time-step's velocity is larger than whole_at_most; a store that is gone on with
    /// stays as it was begun.
    Auto,
    Whole,
    Bricks
};

/// A size in bytes, in single precision. A time-step of this size is read in a second or two, and four of
/// them fit into the memory of most machines. It is the same everywhere: a store does not depend on the
/// machine it was made on.
inline constexpr std::uint64_t whole_at_most = std::uint64_t{1} << 30;

/// Parses auto, whole or bricks. Error: InvalidArgument.
core::Result<StepPlacement> parse_step_placement(std::string_view text);

/// Returns StoreLayout::brick_cells of a grid; 0 of a mesh of cells. Error: Unsupported for Bricks of a mesh
/// of cells.
core::Result<std::uint32_t> brick_cells_for(StepPlacement placement, const StoredGrid& grid);

/// A store that was begun with bricks of so many cells is what was asked for.
bool goes_on(StepPlacement placement, std::uint32_t brick_cells);

} // namespace wakesurf::store
