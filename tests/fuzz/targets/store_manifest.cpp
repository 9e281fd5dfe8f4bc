// A store's manifest: what is read describes a store whose parts agree, and is read again from what is written.
#include "protocol/store_manifest.hpp"

#include "core/dataset/store_grid.hpp"
#include "tests/fuzz/targets/all.hpp"

namespace wakesurf::fuzz {

void store_manifest(Input input) {
    const auto manifest = protocol::parse_store_manifest(text_of(input));
    if (!manifest)
        return;
    const std::string text = protocol::store_manifest_text(*manifest);
    const auto again = protocol::parse_store_manifest(text);
    demand(again.has_value(), "a manifest that was written can be read");
    demand(protocol::store_manifest_text(*again) == text,
           "a manifest is the same after it was written and read");
}

std::vector<std::string> store_manifest_seeds() {
    protocol::StoreManifest manifest;
    manifest.complete = true;
    manifest.source = {
        {{"a.pvd", 100, 5}}, {{{"a_0.vti", 200, -5}}, {{"a_1.vti", 200, 7}}}, "field U "};
    const core::UniformGrid grid{{0.5, 0, -1}, {0.1, 0.2, 0.3}, {3, 4, 5}};
    manifest.layout.grid = core::stored_grid(grid);
    manifest.layout.times = {0.5, 1.5};
    manifest.layout.scalars = {{"p / rho", "p-rho"}};
    manifest.layout.mask = manifest.layout.walls = true;
    manifest.layout.checksums = {{"mask.u8", 0xffffffffu}, {"walls.f32", 0}};
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
    info.bytes_per_step = 720;
    const std::string whole = protocol::store_manifest_text(manifest);
    return {whole, whole.substr(0, whole.size() / 2), "{}"};
}

} // namespace wakesurf::fuzz
