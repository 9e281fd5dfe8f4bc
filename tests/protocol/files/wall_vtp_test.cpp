#include "protocol/files/wall_vtp.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace wakesurf::protocol::wall_vtp_test {
namespace {

TEST(WallVtp, HasPatchesByNameAndAValueAPoint) {
    core::QuadComplex mesh;
    mesh.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.cells = {{{0, 1, 2, 2}, core::Cell{}.mid}, {{0, 2, 3, 3}, core::Cell{}.mid}};
    using Kind = core::BoundaryPatch::Kind;
    const std::string text = wall_vtp(mesh, {{"<a>", Kind::Wall, 1}, {"b", Kind::Other, 1}},
                                      {{"p", 1, {1, 2, 3, std::nanf("")}}}, 2.5);
    EXPECT_NE(text.find("NumberOfPoints=\"4\""), std::string::npos);
    EXPECT_NE(text.find("NumberOfPolys=\"2\""), std::string::npos);
    EXPECT_NE(text.find(">2.5<"), std::string::npos);
    EXPECT_NE(text.find("NumberOfTuples=\"2\" format=\"ascii\">60 97 62 0 98 0 <"),
              std::string::npos)
        << "names cannot break the file";
    EXPECT_NE(text.find("Name=\"Patch\""), std::string::npos);
    const std::string shape = wall_vtp(mesh, {}, {}, {});
    EXPECT_EQ(shape.find("Patch"), std::string::npos);
    EXPECT_EQ(shape.find("TimeValue"), std::string::npos);
}

} // namespace
} // namespace wakesurf::protocol::wall_vtp_test
