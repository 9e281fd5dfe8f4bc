// A store's manifest in which every member holds something.
#pragma once

#include "store/store_grid.hpp"
#include "store/store_manifest.hpp"

namespace wakesurf::tests {

inline store::StoreManifest sample_manifest() {
    store::StoreManifest manifest;
    manifest.complete = true;
    manifest.source = {{{"a.pvd", 100, 1'795'231'487'280'964'257}},
                       {{{"a_0.vti", 200, -5}}, {{"a_1.vti", 200, 7}, {"a_1.raw", 9, 8}}},
                       "field U "};
    const core::UniformGrid grid{{0.5, 0, -1}, {0.1, 0.2, 0.3}, {3, 4, 5}};
    manifest.layout.grid = store::stored_grid(grid);
    manifest.layout.times = {0.5, 1.5};
    manifest.layout.precision = core::Precision::Half;
    manifest.layout.scalars = {{"p / rho", "p-rho"}};
    manifest.layout.mask = manifest.layout.walls = true;
    manifest.layout.checksums = {{"mask.u8", 0xffffffffu}, {"walls.f32", 0}, {"walls.u32", 17}};
    manifest.velocity_range = {0.25, 2};
    auto& info = manifest.info;
    info.dataset = info.name = "a";
    info.reader = "vtk";
    info.bounds = grid.bounds();
    info.dimensions = grid.dimensions;
    info.spacing = grid.spacing;
    info.points = 60;
    info.cells = 24;
    info.times = manifest.layout.times;
    info.fields = {{"U", 3, core::FieldInfo::Source::Point, {0.25, 2}, ""}};
    info.velocity = "U";
    info.why = "so";
    info.bytes_per_step = 720;
    return manifest;
}

} // namespace wakesurf::tests
