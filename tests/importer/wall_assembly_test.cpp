#include "core/dataset/cell_neighbours.hpp"
#include "importer/assembly/wall_assembly.hpp"
#include "tests/importer/small_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace wakesurf::importer::wall_assembly_test {
namespace {

using namespace tests;
using core::CellMesh;
using core::Vec3;
using Pointers = std::vector<vtkSmartPointer<vtkDataSet>>;

// Walls among the faces for which `where` holds of all corners; and the number of such faces.
template <class Where>
std::pair<std::size_t, std::size_t> walls_where(const GridAssembly& assembly, const Where& where) {
    const auto& mesh = std::get<CellMesh>(assembly.grid);
    std::size_t walls = 0;
    std::size_t faces = 0;
    for (const auto& [number, f] : core::boundary_faces(mesh)) {
        const auto& cell = mesh.cells[number];
        const auto face = core::face(cell.shape, f);
        bool all = true;
        for (std::size_t i = 0; i < face.count; ++i)
            all = all && where(mesh.points[cell.node[face.node[i]]]);
        faces += all ? 1 : 0;
        walls += all && cell.beyond[f] == core::beyond_wall ? 1 : 0;
    }
    return {walls, faces};
}

const auto everywhere = [](const Vec3&) { return true; };
const auto floor_of_it = [](const Vec3& p) { return p.z == 0.0; };

vtkSmartPointer<vtkPolyData> polygons(const std::vector<std::vector<Vec3>>& faces) {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    data->SetPoints(points);
    data->Allocate(1);
    for (const auto& face : faces) {
        std::vector<vtkIdType> ids;
        for (const Vec3& p : face)
            ids.push_back(points->InsertNextPoint(p.x, p.y, p.z));
        data->InsertNextCell(VTK_POLYGON, static_cast<int>(ids.size()), ids.data());
    }
    return data;
}

GridAssembly brick_with_hole() {
    auto grid = brick({0, 0, 0}, 1.0, {3, 3, 3});
    auto holey = empty_block();
    holey->SetPoints(grid->GetPoints());
    for (vtkIdType i = 0; i < 27; ++i)
        if (i != 13) {
            auto ids = vtkSmartPointer<vtkIdList>::New();
            grid->GetCellPoints(i, ids);
            holey->InsertNextCell(VTK_HEXAHEDRON, ids);
        }
    const Pointers blocks{holey};
    return assemble_grid(blocks).value();
}

TEST(WallAssembly, TakesTheFacesAReaderSaysAreWalls) {
    const Pointers blocks{refined_block()};
    auto assembly = assemble_grid(blocks).value();
    SourceStep step;
    step.walls.push_back(
        {polygons({{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}},
                   {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0.5, 0, 1}, {0, 0, 1}}, // was cut in five
                   {{7, 7, 7}, {8, 7, 7}, {8, 8, 7}}}),
         true});
    const Walls walls = find_walls(assembly, step);
    EXPECT_EQ(walls_where(assembly, everywhere).first, 1u + 5u);
    EXPECT_EQ(walls_where(assembly, floor_of_it), std::pair(std::size_t{1}, std::size_t{4}));
    EXPECT_EQ(walls.unmatched, 1u);
    EXPECT_EQ(walls.still.size(), 7u); // 4 on the floor, 3 more on the side
    const auto& mesh = std::get<CellMesh>(assembly.grid);
    for (const std::uint32_t node : walls.still)
        EXPECT_TRUE(mesh.points[node].z == 0.0 || mesh.points[node].y == 0.0);
}

TEST(WallAssembly, TakesTheBoundaryOfAHoleButNotThatOfTheDomain) {
    auto assembly = brick_with_hole();
    EXPECT_TRUE(find_walls(assembly, {}).still.empty());
    EXPECT_EQ(walls_where(assembly, everywhere), std::pair(std::size_t{6}, std::size_t{60}));
    const auto geometry = wall_geometry(assembly, {});
    EXPECT_EQ(geometry.triangles.size(), 12u);
    EXPECT_EQ(geometry.points.size(), 8u);
    for (const auto& p : geometry.points)
        EXPECT_TRUE(p.x >= 1 && p.x <= 2 && p.y >= 1 && p.y <= 2 && p.z >= 1 && p.z <= 2);
}

TEST(WallAssembly, DrawsTheWallsOfAWedgeAllTheWayRound) {
    auto assembly = brick_with_hole();
    find_walls(assembly, {});
    auto& mesh = std::get<CellMesh>(assembly.grid);
    // Thin about the half plane y > 0, whose axis lies along x.
    for (auto& p : mesh.points)
        p = {p.x, (p.y + 1.0) * std::cos(0.01 * (p.z - 1.5)),
             (p.y + 1.0) * std::sin(0.01 * (p.z - 1.5))};
    mesh.axis = core::SymmetryAxis{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto geometry = wall_geometry(assembly, {});
    EXPECT_EQ(geometry.triangles.size(), 72u * 12u);
    std::array<int, 8> octants{};
    for (const auto& p : geometry.points) {
        const double radius = std::hypot(p.y, p.z);
        EXPECT_TRUE(p.x >= 1 && p.x <= 2 && radius > 2 - 1e-5 && radius < 3 + 1e-5);
        ++octants[static_cast<std::size_t>((std::atan2(p.z, p.y) + std::numbers::pi) * 3.99999 /
                                           std::numbers::pi)];
    }
    EXPECT_TRUE(std::ranges::all_of(octants, [](int count) { return count > 8; }));
}

TEST(WallAssembly, TakesFacesThatAreAtRestAtBothTimeSteps) {
    const Pointers blocks{brick({0, 0, 0}, 1.0, {2, 2, 2})};
    auto assembly = assemble_grid(blocks).value();
    const auto& points = std::get<CellMesh>(assembly.grid).points;
    std::vector<float> first(3 * points.size(), 1.0f);
    std::vector<float> last = first;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            if (points[i].z == 0.0)
                first[3 * i + c] = last[3 * i + c] = 0.0f;
            if (points[i].z == 2.0)
                first[3 * i + c] = 0.0f; // an inlet that starts at rest
        }
    add_still_walls(assembly, first, last);
    EXPECT_EQ(walls_where(assembly, floor_of_it), std::pair(std::size_t{4}, std::size_t{4}));
    EXPECT_EQ(walls_where(assembly, everywhere).first, 4u);
    EXPECT_TRUE(wall_geometry(assembly, {})
                    .triangles.empty()); // the floor of the box would hide what is in it
}

TEST(WallAssembly, ShowsSolidRegions) {
    const Pointers blocks{brick({0, 0, 0}, 1.0, {1, 1, 1})};
    auto assembly = assemble_grid(blocks).value();
    SourceStep step;
    step.solids.push_back(polygons({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));
    EXPECT_EQ(wall_geometry(assembly, step).triangles.size(), 2u);
    EXPECT_EQ(wall_geometry(assembly, step).points.size(), 4u);
}

using Kind = core::BoundaryPatch::Kind;
using Patches = std::vector<core::BoundaryPatch>;

// The six faces of the hole, and the quads of the sides x = 0 and x = 3.
struct FacesOfHole {
    vtkSmartPointer<vtkPolyData> low = polygons({{{1, 1, 1}, {1, 2, 1}, {1, 2, 2}, {1, 1, 2}}});
    vtkSmartPointer<vtkPolyData> high = polygons({{{2, 1, 1}, {2, 2, 1}, {2, 2, 2}, {2, 1, 2}}});
    vtkSmartPointer<vtkPolyData> side = polygons({{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}});
    vtkSmartPointer<vtkPolyData> inlet = polygons({{{3, 0, 0}, {3, 1, 0}, {3, 1, 1}, {3, 0, 1}},
                                                   {{3, 1, 1}, {3, 2, 1}, {3, 2, 2}, {3, 1, 2}}});
};

TEST(WallAssembly, KeepsThePatchesOfTheSourceByName) {
    auto assembly = brick_with_hole();
    const FacesOfHole faces;
    SourceStep step;
    step.others = {{faces.inlet, false, "inlet"}};
    step.walls = {{faces.low, true, "hull"},
                  {faces.side, true, "hull"}, // a piece of it lies in a side of the box
                  {faces.high, true, "tail"},
                  {polygons({}), true, "empty"}};
    const Walls walls = find_walls(assembly, step);
    EXPECT_EQ(walls.unmatched, 0u);
    const auto geometry = wall_geometry(assembly, step, walls);
    EXPECT_EQ(geometry.patches, (Patches{{"hull", Kind::Wall, 2},
                                         {"tail", Kind::Wall, 2},
                                         {"other walls", Kind::Wall, 8},
                                         {"hull", Kind::Side, 2},
                                         {"inlet", Kind::Other, 4}}));
    EXPECT_EQ(geometry.triangles.size(), 18u);
    for (const std::uint32_t point : geometry.triangles.front())
        EXPECT_EQ(geometry.points[point].x, 1.0f);
    for (const std::uint32_t point : geometry.triangles.back())
        EXPECT_EQ(geometry.points[point].x, 3.0f);
    const auto body = core::body_of(geometry);
    EXPECT_EQ(body.triangles.size(), 12u);
    EXPECT_EQ(body.points.size(), 8u); // as without names
}

TEST(WallAssembly, KeepsNoPatchesOfASourceThatNamesNone) {
    auto assembly = brick_with_hole();
    SourceStep step;
    step.walls = {{FacesOfHole().low, true}};
    step.others = {{FacesOfHole().inlet}};
    const auto geometry = wall_geometry(assembly, step, find_walls(assembly, step));
    EXPECT_TRUE(geometry.patches.empty());
    EXPECT_EQ(geometry.triangles.size(), 12u);
}

TEST(WallAssembly, MakesNamesOfStrangersHarmlessAndPutsManyPatchesTogether) {
    auto assembly = brick_with_hole();
    SourceStep step;
    for (int i = 0; i < 1000; ++i)
        step.others.push_back({polygons({}), false, "p" + std::to_string(i)});
    step.others.front() = {FacesOfHole().low, false, "a\x1b[31m" + std::string(1 << 20, 'x')};
    step.others.back().faces = FacesOfHole().high;
    const Walls walls = find_walls(assembly, step);
    EXPECT_EQ(walls.names.size(), most_patches);
    const auto patches = wall_geometry(assembly, step, walls).patches;
    ASSERT_EQ(patches.size(), 3u);
    EXPECT_EQ(patches[0].name.find('\x1b'), std::string::npos);
    EXPECT_LE(patches[0].name.size(), 110u);
    EXPECT_EQ(patches[1], (core::BoundaryPatch{"further patches", Kind::Wall, 2}));
}

TEST(WallAssembly, SaysSoWhereThereAreTooManySidesToKeep) {
    const Pointers blocks{brick({0, 0, 0}, 1.0, {1, 512, 512})};
    auto assembly = assemble_grid(blocks).value();
    std::vector<std::vector<Vec3>> faces;
    for (int j = 0; j < 512; ++j)
        for (int k = 0; k < 512; ++k) {
            const double y = j, z = k;
            faces.push_back({{0, y, z}, {0, y + 1, z}, {0, y + 1, z + 1}, {0, y, z + 1}});
        }
    SourceStep step;
    step.others = {{polygons(faces), false, "inlet"}};
    EXPECT_TRUE(wall_geometry(assembly, step, find_walls(assembly, step)).patches.empty());
    EXPECT_NE(assembly.note.find("not kept for display"), std::string::npos) << assembly.note;
}

} // namespace
} // namespace wakesurf::importer::wall_assembly_test
