#include "protocol/wire/mesh_stream.hpp"
#include "tests/protocol/wire/sample_meshes.hpp"

#include <ctime>
#include <limits>

namespace wakesurf::protocol::mesh_guard_test {
namespace {

using core::Error;

const Lattice lattice = lattice_over(samples::domain);

TEST(MeshGuard, LetsAWholeMeshPassWithAndWithoutAttributes) {
    auto mesh = samples::hanging_sheet(8, 9, 1);
    EXPECT_TRUE(guard_mesh(mesh, lattice, true).has_value());
    mesh.s.clear();
    mesh.t.clear();
    mesh.velocity.clear();
    EXPECT_TRUE(guard_mesh(mesh, lattice, false).has_value());
    EXPECT_FALSE(guard_mesh(mesh, lattice, true).has_value());
}

TEST(MeshGuard, NamesHowManyPositionsAreBadAndTheFirst) {
    auto mesh = samples::sheet(8, 9);
    mesh.position[17].y = std::numeric_limits<double>::quiet_NaN();
    mesh.position[40].z = 3.4e38;
    const auto result = guard_mesh(mesh, lattice, true);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, Error::Code::OutOfDomain);
    EXPECT_NE(result.error().message.find("2 of 72"), std::string::npos) << result.error().message;
    EXPECT_NE(result.error().message.find("number 17"), std::string::npos)
        << result.error().message;
}

// Each of these meshes hangs, aborts or segfaults Draco 1.5.5, or makes it take gigabytes or drop all detail.
TEST(MeshGuard, KeepsTheMeshesThatKillDracoFromIt) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity, 3.4e38, -3.4e38, 1e38, 1e9, 1e300})
        for (int axis = 0; axis < 3; ++axis) {
            auto mesh = samples::sheet(20, 30);
            mesh.position[599][axis] = bad;
            const std::clock_t before = std::clock();
            const auto state = encode_state(mesh, lattice, {});
            EXPECT_FALSE(state.has_value()) << bad << " on axis " << axis;
            EXPECT_LT(std::clock() - before, 1 * CLOCKS_PER_SEC) << "of the processor";
        }
    auto mesh = samples::sheet(20, 30);
    for (std::size_t i = 0; i < mesh.position.size(); ++i)
        mesh.position[i] = core::Vec3(i % 2 == 0 ? 3.4e38 : -3.4e38);
    EXPECT_FALSE(encode_state(mesh, lattice, {}).has_value());
}

TEST(MeshGuard, RefusesAttributesThatAreNotFiniteAsFloats) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300}) {
        auto mesh = samples::sheet(4, 4);
        mesh.t[3] = bad;
        EXPECT_FALSE(guard_mesh(mesh, lattice, true).has_value()) << bad;
        EXPECT_TRUE(guard_mesh(mesh, lattice, false).has_value()) << bad;
    }
    auto mesh = samples::sheet(4, 4);
    mesh.velocity[15] = core::Vec3f(3e38f);
    EXPECT_FALSE(guard_mesh(mesh, lattice, true).has_value()) << "the speed overflows";
}

TEST(MeshGuard, RefusesCellsOfVerticesThatDoNotExistAndUnusableLattices) {
    auto mesh = samples::sheet(4, 4);
    mesh.cells[5].corner[2] = 16;
    EXPECT_EQ(guard_mesh(mesh, lattice, true).error().code, Error::Code::Corrupt);
    mesh = samples::sheet(4, 4);
    mesh.cells[5].corner[2] = core::no_vertex;
    EXPECT_FALSE(guard_mesh(mesh, lattice, true).has_value());
    mesh = samples::sheet(4, 4);
    mesh.cells[5].mid[2] = 16;
    EXPECT_FALSE(guard_mesh(mesh, lattice, true).has_value());
    EXPECT_EQ(guard_mesh(samples::sheet(4, 4), {{0, 0, 0}, 0, 16}, true).error().code,
              Error::Code::InvalidArgument);
}

} // namespace
} // namespace wakesurf::protocol::mesh_guard_test
