#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/mesh_vtp.hpp"
#include "tests/support/small_mesh.hpp"
#include "tests/support/vtp_arrays.hpp"

#include <gtest/gtest.h>

namespace wakesurf::protocol::mesh_vtp_test {

namespace {

using tests::array_of;
using tests::small_mesh;

const MeshMetadata metadata{.rake = {core::Rake::Kind::Line, {{0, 0, 0}, {0.1, 1e-300, -2}}},
                            .parameters = {.kind = core::SurfaceKind::Path, .from = 0.1, .to = 7},
                            .separation = 0.05,
                            .dataset = "a<b",
                            .version = "1.2.3"};

} // namespace

TEST(MeshVtp, WritesCornersAndHangingNodesInOrderSharingPoints) {
    const auto file = mesh_vtp(small_mesh(), metadata);
    EXPECT_EQ(array_of<std::int64_t>(file, "Int64", "connectivity"),
              (std::vector<std::int64_t>{0, 1, 2, 6, 3, 3, 6, 7, 4, 6, 2, 5, 7}));
    EXPECT_EQ(array_of<std::int64_t>(file, "Int64", "offsets"),
              (std::vector<std::int64_t>{5, 9, 13}));
}

TEST(MeshVtp, KeepsCoordinatesExactly) {
    const auto mesh = small_mesh();
    const auto points = array_of<core::Vec3>(mesh_vtp(mesh, metadata), "Float64", "Points");
    EXPECT_EQ(points, mesh.position);
}

TEST(MeshVtp, WritesEveryPointArrayOfTheContract) {
    const auto mesh = small_mesh();
    const auto file = mesh_vtp(mesh, metadata, {{"p", {1, 2, 3, 4, 5, 6, 7, 8}}});
    EXPECT_EQ(array_of<double>(file, "Float64", "s"), mesh.s);
    EXPECT_EQ(array_of<double>(file, "Float64", "t"), mesh.t);
    EXPECT_EQ(array_of<float>(file, "Float32", "speed"), std::vector<float>(8, 5.0F));
    EXPECT_EQ(array_of<core::Vec3f>(file, "Float32", "velocity"), mesh.velocity);
    EXPECT_EQ(array_of<float>(file, "Float32", "deformation"), mesh.deformation);
    EXPECT_EQ(array_of<std::uint32_t>(file, "UInt32", "component"), mesh.component);
    EXPECT_EQ(array_of<std::uint8_t>(file, "UInt8", "approximated"), mesh.approximated);
    EXPECT_EQ(array_of<float>(file, "Float32", "p"), (std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(MeshVtp, WritesMetadataThatReadsBackTheSame) {
    const auto file = mesh_vtp(small_mesh(), metadata);
    EXPECT_NE(file.find("Name=\"kind\" NumberOfTuples=\"1\" format=\"ascii\">112 97 116 104 0<"),
              std::string::npos);
    EXPECT_NE(
        file.find(
            "NumberOfComponents=\"3\" NumberOfTuples=\"2\" format=\"ascii\">0 0 0 0.1 1e-300 -2 <"),
        std::string::npos);
    EXPECT_NE(file.find("Name=\"separation\" NumberOfComponents=\"1\" NumberOfTuples=\"1\" "
                        "format=\"ascii\">0.05 <"),
              std::string::npos);
}

TEST(MeshVtp, SaysWhatTheSurfaceWasReleasedFromWhereThatIsMoreThanARake) {
    EXPECT_EQ(mesh_vtp(small_mesh(), metadata).find("Name=\"sweep\""), std::string::npos);
    auto more = metadata;
    more.parameters.sweep = core::Vec3(0, 1, 0);
    more.parameters.rake2 = core::Rake{core::Rake::Kind::Line, {{0, 0, 1}, {0, 0, 2}}};
    more.parameters.release_until = 2.5;
    more.parameters.life = 0.75;
    const auto file = mesh_vtp(small_mesh(), more);
    for (const std::string part : {"Name=\"sweep\" NumberOfComponents=\"3\" NumberOfTuples=\"1\" "
                                   "format=\"ascii\">0 1 0 <",
                                   "Name=\"rake2\" NumberOfComponents=\"3\" NumberOfTuples=\"2\" "
                                   "format=\"ascii\">0 0 1 0 0 2 <",
                                   "Name=\"life\" NumberOfComponents=\"1\" "
                                   "NumberOfTuples=\"1\" format=\"ascii\">0.75 <",
                                   "Name=\"releaseUntil\" NumberOfComponents=\"1\" "
                                   "NumberOfTuples=\"1\" format=\"ascii\">2.5 <"})
        EXPECT_NE(file.find(part), std::string::npos) << part;
}

TEST(MeshVtp, SaysOfALevelSetItsFieldAndLevelAndNoRake) {
    auto level = metadata;
    level.parameters.kind = core::SurfaceKind::Level;
    level.parameters.field = "p";
    level.parameters.level = 0.25;
    const auto file = mesh_vtp(small_mesh(), level);
    for (const std::string part : {"Name=\"field\" NumberOfTuples=\"1\" format=\"ascii\">112 0<",
                                   "Name=\"level\" NumberOfComponents=\"1\" "
                                   "NumberOfTuples=\"1\" format=\"ascii\">0.25 <"})
        EXPECT_NE(file.find(part), std::string::npos) << part;
    EXPECT_EQ(file.find("Name=\"rake\""), std::string::npos);
    const auto lines = mesh_lines(level);
    EXPECT_NE(std::ranges::find(lines, "field p"), lines.end());
    EXPECT_NE(std::ranges::find(lines, "level 0.25"), lines.end());
}

TEST(MeshVtp, CutsLongArraysIntoBlocksThatReadBackWhole) {
    for (const std::size_t vertices :
         {1u, 32767u, 32768u, 32769u, 200000u}) { // 8 bytes: 2^18 a block
        core::QuadComplex mesh;
        mesh.position.resize(vertices);
        mesh.velocity.resize(vertices);
        mesh.component.resize(vertices);
        mesh.approximated.resize(vertices);
        mesh.t.resize(vertices);
        for (std::size_t v = 0; v < vertices; ++v)
            mesh.s.push_back(static_cast<double>(v * v % 1009) / 1009.0);
        EXPECT_EQ(array_of<double>(mesh_vtp(mesh, metadata), "Float64", "s"), mesh.s) << vertices;
    }
}

TEST(MeshVtp, HasNoAppendedDataWhichSomeReadersCannotTake) {
    EXPECT_EQ(mesh_vtp(small_mesh(), metadata).find("ppended"), std::string::npos);
}

TEST(MeshVtp, GivesTheSameBytesForTheSameMesh) {
    EXPECT_EQ(mesh_vtp(small_mesh(), metadata), mesh_vtp(small_mesh(), metadata));
}

TEST(MeshVtp, WritesASurfaceWithoutCellsAsAnEmptyFile) {
    const auto file = mesh_vtp({}, metadata);
    EXPECT_NE(file.find("NumberOfPoints=\"0\""), std::string::npos);
    EXPECT_NE(file.find("</VTKFile>"), std::string::npos);
}

} // namespace wakesurf::protocol::mesh_vtp_test
