// A small store whose values are given, whole or in bricks, written by the store's own writers.
#pragma once

#include "store/brick_mask.hpp"
#include "store/store_grid.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"
#include "store/value_writing.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace wakesurf::tests {

/// The content of a store.
struct StoreValues {
    core::Grid grid;
    core::Precision precision = core::Precision::Single;
    std::vector<std::uint8_t> fluid; ///< empty: no mask
    /// The values by time-step, then column.
    std::vector<std::vector<std::vector<float>>> values;
};

/// Returns a function that hands `all` out in pieces of `piece`.
template <class T>
auto in_pieces(std::span<const T> all, std::size_t piece) {
    return [all, piece]() mutable -> core::Result<std::span<const T>> {
        const auto now = all.first(std::min(piece, all.size()));
        all = all.subspan(now.size());
        return now;
    };
}

/// Writes it and returns its layout. @param brick_cells  0: whole time-steps. @param piece  values at a time
inline store::StoreLayout write_store(const std::filesystem::path& folder,
                                      const StoreValues& what,
                                      std::uint32_t brick_cells,
                                      std::size_t piece = 1000) {
    auto writer = store::StoreWriter::open(folder, [] { return core::Result<void>(); }).value();
    store::StoreLayout layout;
    layout.folder = folder;
    layout.grid = store::stored_grid(what.grid);
    layout.precision = what.precision;
    layout.brick_cells = brick_cells;
    for (const store::GridFile& file : store::grid_files(what.grid))
        layout.checksums[file.name] = writer.write(file.name, file.bytes).value();
    for (std::size_t scalar = 1; scalar < what.values.front().size(); ++scalar)
        layout.scalars.push_back({"s" + std::to_string(scalar), "s" + std::to_string(scalar)});
    for (std::size_t step = 0; step < what.values.size(); ++step)
        layout.times.push_back(static_cast<double>(step));
    if (!what.fluid.empty()) {
        layout.mask = true;
        layout.checksums[std::string(store::mask_file_name)] =
            store::write_mask(writer, layout,
                              in_pieces(std::span<const std::uint8_t>(what.fluid), piece))
                .value();
    }
    for (std::size_t step = 0; step < what.values.size(); ++step) {
        std::vector<std::uint32_t> sums;
        for (std::size_t column = 0; column < what.values[step].size(); ++column)
            sums.push_back(store::write_values(
                               writer, layout, column, step,
                               in_pieces(std::span<const float>(what.values[step][column]), piece))
                               .value());
        writer.finish_step(step, sums).map([] { return true; }).value();
    }
    return layout;
}

/// Writes a store of a uniform grid with a manifest, so that it can be opened by its folder.
inline store::StoreLayout write_whole_store(const std::filesystem::path& folder,
                                            const StoreValues& what,
                                            std::uint32_t brick_cells) {
    const auto& grid = std::get<core::UniformGrid>(what.grid);
    store::StoreManifest manifest;
    manifest.layout = write_store(folder, what, brick_cells, std::size_t{1} << 20);
    manifest.complete = true;
    core::DatasetInfo& info = manifest.info;
    info.dataset = info.name = "values";
    info.reader = "vtk";
    info.bounds = grid.bounds();
    info.dimensions = grid.dimensions;
    info.spacing = grid.spacing;
    info.points = info.cells = 1;
    for (const std::uint32_t nodes : grid.dimensions) {
        info.points *= nodes;
        info.cells *= nodes - 1;
    }
    info.times = manifest.layout.times;
    info.velocity = "U";
    info.why = "it is the only one";
    info.bytes_per_step = 3 * sizeof(float) * info.points;
    info.fields = {{"U", 3, core::FieldInfo::Source::Point, {0, 1}, ""}};
    for (const auto& each : manifest.layout.scalars)
        info.fields.push_back({each.name, 1, core::FieldInfo::Source::Point, {0, 1}, ""});
    write_file(folder / store::manifest_file_name, store::store_manifest_text(manifest));
    return manifest.layout;
}

inline std::shared_ptr<const store::StoreReader>
open_bricks(const store::StoreLayout& layout,
            std::shared_ptr<const core::Disk> disk = std::make_shared<core::PosixDisk>(),
            std::size_t threads = 4) {
    return store::StoreReader::open(layout, std::move(disk), threads).value();
}

} // namespace wakesurf::tests
