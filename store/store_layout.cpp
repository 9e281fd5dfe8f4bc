#include "store/store_layout.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

namespace wakesurf::store {

using core::Error;
using core::GridKind;

core::Result<StepPlacement> parse_step_placement(std::string_view text) {
    if (text == "auto")
        return StepPlacement::Auto;
    if (text == "whole")
        return StepPlacement::Whole;
    if (text == "bricks")
        return StepPlacement::Bricks;
    return core::fail(Error::Code::InvalidArgument,
                      "--layout: '" + std::string(text) + "' is none of auto, whole and bricks");
}

core::Result<std::uint32_t> brick_cells_for(StepPlacement placement, const StoredGrid& grid) {
    const bool cells = grid.kind != GridKind::Uniform && grid.kind != GridKind::Rectilinear;
    if (cells && placement == StepPlacement::Bricks)
        return core::fail(Error::Code::Unsupported,
                          "--layout bricks: only uniform and rectilinear grids lie in bricks, not "
                          "meshes of cells",
                          "leave --layout out");
    const bool large = step_file_size(grid.nodes(), 3, core::Precision::Single) > whole_at_most;
    if (cells || placement == StepPlacement::Whole || (placement == StepPlacement::Auto && !large))
        return 0;
    return core::BrickLayout::usual_cells;
}

bool goes_on(StepPlacement placement, std::uint32_t brick_cells) {
    return placement == StepPlacement::Auto ||
           (placement == StepPlacement::Bricks) == (brick_cells != 0);
}

bool BrickIndex::any_gap() const {
    return std::any_of(gaps.begin(), gaps.end(), [](std::uint8_t gap) { return gap != 0; });
}

std::vector<std::byte> brick_index_bytes(const BrickIndex& index) {
    std::vector<std::byte> out(BrickIndex::bytes(index.checksums.size()));
    const auto sums = std::as_bytes(std::span(index.checksums));
    const auto gaps = std::as_bytes(std::span(index.gaps));
    std::copy(gaps.begin(), gaps.end(), std::copy(sums.begin(), sums.end(), out.begin()));
    return out;
}

core::Result<BrickIndex> parse_brick_index(std::span<const std::byte> bytes, std::size_t bricks) {
    const auto corrupt = [](std::string message) {
        return core::fail(core::Error::Code::Corrupt, std::move(message),
                          "import the dataset again");
    };
    if (bytes.size() != BrickIndex::bytes(bricks))
        return corrupt("has " + std::to_string(bytes.size()) + " bytes instead of " +
                       std::to_string(BrickIndex::bytes(bricks)));
    BrickIndex index(bricks);
    const auto sums = std::as_writable_bytes(std::span(index.checksums));
    const auto gaps = bytes.subspan(sums.size());
    std::copy_n(bytes.begin(), sums.size(), sums.begin());
    std::copy(gaps.begin(), gaps.end(), std::as_writable_bytes(std::span(index.gaps)).begin());
    if (std::any_of(index.gaps.begin(), index.gaps.end(), [](std::uint8_t gap) { return gap > 1; }))
        return corrupt("says of a brick neither that it has gaps nor that it has none");
    return index;
}

using core::Error;
using core::fail;
using core::GridKind;
using core::Precision;
using core::Result;
using core::UniformGrid;

namespace {

// Lengths beyond this, or below its inverse, overflow when squared further down the path.
constexpr double largest = 1e100;
// The batch kernel counts a brick's nodes in float, which is exact up to 2^24: 129^3 are fewer, 257^3 are
// more.
constexpr std::uint32_t most_brick_cells = 128;
// Bytes of several time-steps can be added up.
constexpr std::uint64_t most_nodes =
    std::numeric_limits<std::int64_t>::max() / (16 * 3 * sizeof(float));

std::uint64_t product(const std::array<std::uint32_t, 3>& dimensions) {
    std::uint64_t nodes = 1;
    for (const std::uint64_t count : dimensions) {
        if (count < 2 || nodes > most_nodes / count)
            return 0;
        nodes *= count;
    }
    return nodes;
}

bool usable(const UniformGrid& grid) {
    for (int axis = 0; axis < 3; ++axis) {
        const double far =
            std::max(std::abs(grid.bounds().lo[axis]), std::abs(grid.bounds().hi[axis]));
        if (!(grid.spacing[axis] >= 1.0 / largest) || !(far <= largest))
            return false;
    }
    return true;
}

} // namespace

std::uint64_t StoredGrid::nodes() const {
    switch (kind) {
    case GridKind::Uniform:
        return product(uniform.dimensions);
    case GridKind::Rectilinear:
        return product(dimensions);
    default:
        return points;
    }
}

std::string step_file_name(std::string_view stem, std::size_t index, Precision precision) {
    std::string digits = std::to_string(index);
    digits.insert(0, digits.size() < 6 ? 6 - digits.size() : 0, '0');
    return std::string(stem) + "_" + digits + (precision == Precision::Half ? ".f16" : ".f32");
}

core::BrickLayout StoreLayout::bricks() const {
    return core::BrickLayout(
        grid.kind == GridKind::Uniform ? grid.uniform.dimensions : grid.dimensions, brick_cells);
}

std::vector<StepFile> step_files(const StoreLayout& layout, std::size_t column, std::size_t index) {
    const auto stem =
        column == 0 ? velocity_stem : std::string_view(layout.scalars[column - 1].stem);
    return step_files(layout, stem, components_of(column), layout.precision, index);
}

std::vector<StepFile> step_files(const StoreLayout& layout,
                                 std::string_view stem,
                                 std::size_t components,
                                 Precision precision,
                                 std::size_t index) {
    const std::string values = step_file_name(stem, index, precision);
    const auto size = [&](std::uint64_t nodes) -> std::uint64_t {
        return step_file_size(nodes, components, precision);
    };
    if (layout.brick_cells == 0)
        return {{values, size(layout.grid.nodes())}};
    const auto bricks = layout.bricks();
    if (!layout.checked)
        return {{values, size(bricks.count() * bricks.nodes_per_brick())}};
    return {{values, size(bricks.count() * bricks.nodes_per_brick())},
            {values.substr(0, values.rfind('.')) + std::string(bricks_suffix),
             BrickIndex::bytes(bricks.count())}};
}

std::size_t step_file_size(std::uint64_t nodes, std::size_t components, Precision precision) {
    return static_cast<std::size_t>(nodes) * components * (precision == Precision::Half ? 2 : 4);
}

std::uint64_t opening_bytes(const StoreLayout& layout) {
    const StoredGrid& grid = layout.grid;
    std::uint64_t bytes = 0;
    if (grid.kind == GridKind::Rectilinear)
        for (const std::uint64_t nodes : grid.dimensions)
            bytes += 2 * sizeof(double) * nodes; // as the file has them, and as the grid does
    if (grid.kind == GridKind::Curvilinear || grid.kind == GridKind::Unstructured)
        bytes += 2 * sizeof(core::Vec3) * grid.points + 2 * sizeof(core::MeshCell) * grid.cells;
    if (layout.mask && layout.brick_cells == 0)
        bytes += 2 * grid.nodes();
    if (layout.mask && layout.brick_cells != 0)
        bytes += (1 + sizeof(void*)) * layout.bricks().count();
    return bytes;
}

Result<void> check_grid(const StoredGrid& grid) {
    const bool cells = grid.kind == GridKind::Curvilinear || grid.kind == GridKind::Unstructured;
    constexpr std::uint64_t most_points = 0xfffffff0u; // node numbers have 32 bits
    if (cells && (grid.points < 4 || grid.cells == 0))
        return fail(Error::Code::InvalidArgument, "the mesh has no cells");
    if (cells && (grid.points > most_points || grid.cells > most_points))
        return fail(Error::Code::InvalidArgument, "the mesh has more points or cells than 2^32");
    const auto& dimensions =
        grid.kind == GridKind::Uniform ? grid.uniform.dimensions : grid.dimensions;
    if (!cells && std::any_of(dimensions.begin(), dimensions.end(), [](auto n) { return n < 2; }))
        return fail(Error::Code::InvalidArgument, "the grid is thinner than two nodes");
    if (grid.nodes() == 0)
        return fail(Error::Code::InvalidArgument, "the grid has more nodes than memory can hold");
    if (grid.kind == GridKind::Uniform && !usable(grid.uniform))
        return fail(Error::Code::InvalidArgument, "the grid's origin or spacing is not usable");
    if (grid.kind == GridKind::Analytic)
        return fail(Error::Code::InvalidArgument, "an analytic flow has no grid to store");
    return {};
}

Result<void> check_bricks(const StoreLayout& layout) {
    if (layout.brick_cells == 0)
        return {};
    if (layout.grid.kind != GridKind::Uniform && layout.grid.kind != GridKind::Rectilinear)
        return fail(Error::Code::InvalidArgument, "a mesh of cells does not lie in bricks");
    if (!std::has_single_bit(layout.brick_cells) || layout.brick_cells > most_brick_cells)
        return fail(Error::Code::InvalidArgument,
                    "the cells of a brick's axis are no power of two up to 128");
    const auto bricks = layout.bricks();
    const std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (std::uint64_t{bricks.bricks()[0]} * bricks.bricks()[1] > most / bricks.bricks()[2] ||
        bricks.count() > most_nodes / bricks.nodes_per_brick())
        return fail(Error::Code::InvalidArgument, "the grid has more bricks than memory can hold");
    return {};
}

Result<void> check_layout(const StoreLayout& layout) {
    const auto& times = layout.times;
    if (times.empty())
        return fail(Error::Code::InvalidArgument, "the store has no time-steps");
    const bool finite_times =
        std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
    const bool rising = std::adjacent_find(times.begin(), times.end(), [](double a, double b) {
                            return !(a < b);
                        }) == times.end();
    if (!finite_times || !rising)
        return fail(Error::Code::InvalidArgument, "the store's times are not strictly increasing");
    return check_grid(layout.grid).and_then([&] { return check_bricks(layout); });
}

void mark_stored(const StoreLayout& layout, core::DatasetInfo& info) {
    for (core::FieldInfo& field : info.fields)
        field.stored = field.kept() ||
                       (field.components == 1
                            ? std::ranges::find(layout.scalars, field.name, &StoredScalar::name) !=
                                  layout.scalars.end()
                            : field.name == info.velocity);
}

Result<std::size_t> find_scalar(const StoreLayout& layout, std::string_view name) {
    std::string all;
    for (std::size_t i = 0; i < layout.scalars.size(); ++i) {
        if (layout.scalars[i].name == name)
            return i;
        all += (all.empty() ? "" : ", ") + layout.scalars[i].name;
    }
    return fail(Error::Code::NotFound, "there is no scalar field " + std::string(name),
                all.empty() ? "the dataset holds no scalar fields" : "there is " + all);
}

} // namespace wakesurf::store
