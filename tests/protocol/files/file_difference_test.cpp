#include "core/surface/contour_lines.hpp"
#include "protocol/files/file_difference.hpp"
#include "protocol/files/mesh_file.hpp"
#include "protocol/files/recipe.hpp"
#include "protocol/files/surface_lines.hpp"
#include "tests/support/small_mesh.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

namespace wakesurf::protocol::file_difference_test {

namespace {

MeshMetadata metadata() {
    MeshMetadata out{.dataset = "d", .version = "1"};
    out.recipe = recipe_text({.version = "1", .dataset = "d"});
    return out;
}

std::string
file_of(const core::QuadComplex& mesh, MeshFormat format, GlbCoding coding = GlbCoding::Plain) {
    return mesh_file(format, mesh, metadata(), {{"p", {0, 1, 2, 3, 4, 5, 6, 7}}}, coding).value();
}

std::string difference(MeshFormat format, const std::function<void(core::QuadComplex&)>& change) {
    core::QuadComplex other = tests::small_mesh();
    change(other);
    return first_difference(extension(format), file_of(other, format),
                            file_of(tests::small_mesh(), format))
        .what;
}

} // namespace

TEST(FileDifference, NamesTheVertexThatWasMoved) {
    const auto move = [](core::QuadComplex& mesh) { mesh.position[2].z = 0.25; };
    EXPECT_EQ(difference(MeshFormat::Vtp, move),
              "position of vertex 2 is (1, 1, 0.25) instead of (1, 1, 0.1)");
    EXPECT_EQ(difference(MeshFormat::Obj, move), "vertex 2 is `v 1 1 0.25` instead of `v 1 1 0.1`");
}

TEST(FileDifference, NamesTheValueOfAVertex) {
    const auto turn = [](core::QuadComplex& mesh) { mesh.deformation[5] = 7; };
    EXPECT_EQ(difference(MeshFormat::Vtp, turn), "deformation of vertex 5 is 7 instead of 1");
    EXPECT_EQ(difference(MeshFormat::Ply, turn), "deformation of vertex 5 is 7 instead of 1");
    EXPECT_EQ(difference(MeshFormat::Glb, turn), "_DEFORMATION of vertex 5 is 7 instead of 1");
    const auto mark = [](core::QuadComplex& mesh) { mesh.approximated[7] = 1; };
    EXPECT_EQ(difference(MeshFormat::Vtp, mark), "approximated of vertex 7 is 1 instead of 0");
    EXPECT_EQ(difference(MeshFormat::Ply, mark), "approximated of vertex 7 is 1 instead of 0");
}

TEST(FileDifference, NamesTheCellThatJoinsOtherVertices) {
    const auto flip = [](core::QuadComplex& mesh) { mesh.cells[2] = core::mirror(mesh.cells[2]); };
    EXPECT_EQ(difference(MeshFormat::Vtp, flip), "connectivity of corner 9 is 2 instead of 6");
    const std::string ply = file_of(tests::small_mesh(), MeshFormat::Ply);
    std::string other = ply;
    other.back() ^= 1;
    EXPECT_EQ(first_difference("ply", other, ply).what, "face 4 has other vertices");
}

TEST(FileDifference, NoticesEveryByteOfEveryFormat) {
    const auto every = [](MeshFormat format, const std::string& right) {
        std::map<std::string, int> recompressed;
        for (std::size_t k = 0; k < right.size(); ++k) {
            std::string other = right;
            other[k] ^= 4;
            const auto found = first_difference(extension(format), other, right);
            EXPECT_TRUE(!found.what.empty() || found.recompressed) << extension(format) << k;
        }
        EXPECT_EQ(first_difference(extension(format), right, right).what, "");
        EXPECT_FALSE(first_difference(extension(format), right, right).recompressed);
    };
    for (const MeshFormat format : mesh_formats)
        every(format, file_of(tests::small_mesh(), format));
    every(MeshFormat::Glb, file_of(tests::small_mesh(), MeshFormat::Glb, GlbCoding::Draco));
    const LinesWanted wanted{.along = LinesWanted::Along::Seed, .values = 2};
    const auto lines = surface_lines(tests::small_mesh(), wanted);
    for (const MeshFormat format :
         {MeshFormat::Vtp, MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Glb})
        every(format, lines_file(format, *lines, wanted, metadata()).value());
}

TEST(FileDifference, NoticesAnEndThatIsMissingAndBytesBehindIt) {
    for (const MeshFormat format : mesh_formats) {
        const std::string right = file_of(tests::small_mesh(), format);
        for (const std::size_t size : {std::size_t{0}, right.size() / 2, right.size() - 1})
            EXPECT_EQ(first_difference(extension(format), right.substr(0, size), right).what,
                      "it ends after " + std::to_string(size) + " of " +
                          std::to_string(right.size()) + " bytes");
        EXPECT_EQ(first_difference(extension(format), right + "ab", right).what,
                  "it has 2 bytes more, behind its end");
    }
}

TEST(FileDifference, TakesAnotherCompressionForTheSameValues) {
    const std::string right = file_of(tests::small_mesh(), MeshFormat::Vtp);
    // The content begins with four words for one block, in 44 letters, then come the bytes of zlib: 0x78, and one that says how hard it
    // tried: 0x01. With 0xda instead it tried hardest.
    std::string other = right;
    const std::size_t at = right.find('>', right.find("Name=\"s\"")) + 1 + 44;
    ASSERT_EQ(right.substr(at, 2), "eA");
    other[at + 1] = 'N';
    other[at + 2] = static_cast<char>(right[at + 2] - 'E' + 'o');
    const auto found = first_difference("vtp", other, right);
    EXPECT_EQ(found.what, "");
    EXPECT_TRUE(found.recompressed);
}

} // namespace wakesurf::protocol::file_difference_test
