#include "store/store_grid.hpp"
#include "store/store_manifest.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace wakesurf::store::store_grid_test {
namespace {

using namespace core;

using namespace tests;

RectilinearGrid stretched() {
    return {{{{0.0, 0.5, 2.0}, {-1.0, 1.0}, {3.0, 3.25, 3.5, 7.0}}}};
}

/// A hexahedron with a pyramid on its top, a wall beneath.
CellMesh two_cells() {
    constexpr std::uint32_t none = 0xffffffffu;
    CellMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},    {0, 0, 1},
                   {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 2}};
    mesh.cells = {{{0, 1, 2, 3, 4, 5, 6, 7},
                   {beyond_domain, beyond_domain, beyond_domain, beyond_domain, beyond_wall, 1},
                   CellShape::Hexahedron},
                  {{4, 5, 6, 7, 8, none, none, none},
                   {0, beyond_domain, beyond_domain, beyond_domain, beyond_domain, beyond_domain},
                   CellShape::Pyramid}};
    return mesh;
}

StoreLayout stored(const TemporaryFolder& folder, const Grid& grid) {
    StoreLayout layout;
    layout.folder = folder.path();
    layout.grid = stored_grid(grid);
    layout.times = {0.0};
    for (const GridFile& file : grid_files(grid))
        put_fixed(layout, file.name,
                  {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
    return layout;
}

Error::Code read_error(const StoreLayout& layout) {
    const auto grid = read_grid(layout, PosixDisk());
    return grid ? Error::Code::Cancelled : grid.error().code;
}

TEST(StoreGrid, GivesBackRectilinearCoordinates) {
    const TemporaryFolder folder;
    const Grid grid = stretched();
    const auto layout = stored(folder, grid);
    EXPECT_EQ(layout.grid.dimensions, (std::array<std::uint32_t, 3>{3, 2, 4}));
    EXPECT_EQ(layout.grid.nodes(), 24u);
    const auto back = std::get<RectilinearGrid>(read_grid(layout, PosixDisk()).value());
    EXPECT_EQ(back.coordinates, stretched().coordinates);
}

TEST(StoreGrid, GivesBackCellsAndWhatLiesBeyondTheirFaces) {
    const TemporaryFolder folder;
    const auto layout = stored(folder, two_cells());
    EXPECT_EQ(layout.grid.kind, GridKind::Unstructured);
    EXPECT_EQ(layout.grid.nodes(), 9u);
    const auto back = std::get<CellMesh>(read_grid(layout, PosixDisk()).value());
    const auto mesh = two_cells();
    EXPECT_EQ(back.points, mesh.points);
    ASSERT_EQ(back.cells.size(), mesh.cells.size());
    for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
        EXPECT_EQ(back.cells[i].node, mesh.cells[i].node);
        EXPECT_EQ(back.cells[i].beyond, mesh.cells[i].beyond);
        EXPECT_EQ(back.cells[i].shape, mesh.cells[i].shape);
    }
}

TEST(StoreGrid, KeepsTheAxisOfAWedgeAndRefusesOneThatIsNone) {
    const TemporaryFolder folder;
    CellMesh mesh = two_cells();
    mesh.axis = core::SymmetryAxis{{0.1, 0.2, 0.3}, {0, 0.6, 0.8}, {1, 0, 0}};
    auto layout = stored(folder, mesh);
    const auto text = protocol::written(layout);
    const auto parsed = protocol::parse_kept<StoreLayout>(text);
    ASSERT_TRUE(parsed.has_value()) << parsed.error().message;
    layout.grid.axis = parsed->grid.axis;
    EXPECT_EQ(std::get<CellMesh>(read_grid(layout, PosixDisk()).value()).axis, mesh.axis);
    for (const Vec3& radial : {Vec3(1, 0.1, 0), Vec3(0, 0.6, 0.8), Vec3(0), Vec3(NAN)}) {
        layout.grid.axis->radial = radial;
        EXPECT_EQ(read_error(layout), Error::Code::Corrupt);
    }
}

TEST(StoreGrid, RefusesEveryFlippedBitAndEveryCut) {
    for (const Grid& grid : {Grid(stretched()), Grid(two_cells())}) {
        const TemporaryFolder folder;
        const auto layout = stored(folder, grid);
        for (const GridFile& file : grid_files(grid)) {
            const auto path = folder / file.name;
            for (std::size_t bit = 0; bit < 8 * file.bytes.size(); ++bit) {
                flip_bit(path, bit);
                ASSERT_EQ(read_error(layout), Error::Code::Corrupt) << file.name << " " << bit;
                flip_bit(path, bit);
            }
            const std::string whole = read_file(path);
            for (std::size_t size = 0; size < whole.size(); ++size) {
                write_file(path, whole.substr(0, size));
                ASSERT_EQ(read_error(layout), Error::Code::Corrupt) << file.name << " " << size;
            }
            std::filesystem::remove(path);
            EXPECT_EQ(read_error(layout), Error::Code::NotFound) << file.name;
            write_file(path, whole);
        }
        EXPECT_TRUE(read_grid(layout, PosixDisk()).has_value());
    }
}

TEST(StoreGrid, RefusesAFileThatTheManifestDoesNotVouchFor) {
    const TemporaryFolder folder;
    auto layout = stored(folder, stretched());
    layout.checksums.erase("y.f64");
    EXPECT_EQ(read_error(layout), Error::Code::Corrupt);
}

TEST(StoreGrid, RefusesCoordinatesThatDoNotRise) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const auto& x : {std::vector<double>{0.0, 0.0, 1.0},
                          {0.0, 2.0, 1.0},
                          {0.0, nan, 1.0},
                          {0.0, 1.0, infinite}}) {
        const TemporaryFolder folder;
        auto grid = stretched();
        grid.coordinates[0] = x;
        EXPECT_EQ(read_error(stored(folder, grid)), Error::Code::Corrupt);
    }
}

TEST(StoreGrid, RefusesCellsWithNodesShapesOrNeighboursThatDoNotExist) {
    const auto error_with = [](auto change) {
        const TemporaryFolder folder;
        auto mesh = two_cells();
        change(mesh);
        return read_error(stored(folder, mesh));
    };
    const auto corrupt = Error::Code::Corrupt;
    EXPECT_EQ(error_with([](CellMesh& m) { m.cells[1].node[4] = 9; }), corrupt);
    EXPECT_EQ(error_with([](CellMesh& m) { m.cells[0].beyond[5] = 2; }), corrupt);
    EXPECT_EQ(error_with([](CellMesh& m) { m.cells[0].beyond[5] = 0xfffffffdu; }), corrupt);
    EXPECT_EQ(
        error_with([](CellMesh& m) { m.points[3].y = std::numeric_limits<double>::quiet_NaN(); }),
        corrupt);
    const TemporaryFolder folder;
    auto layout = stored(folder, two_cells());
    put_fixed(layout, "shapes.u8", std::string("\3\4", 2));
    EXPECT_EQ(read_error(layout), corrupt);
}

} // namespace
} // namespace wakesurf::store::store_grid_test
