// What is said of meshes in several parts: gaps between them, and parts over others.
#include "core/base/vec3.hpp"
#include "importer/assembly/grid_assembly.hpp"

#include <gtest/gtest.h>
#include <vtkImageData.h>

namespace wakesurf::importer::mesh_parts_test {
namespace {

using core::Vec3;
using Blocks = std::vector<vtkSmartPointer<vtkDataSet>>;

vtkSmartPointer<vtkDataSet> image(const Vec3& lo, const Vec3& hi, int cells) {
    auto out = vtkSmartPointer<vtkImageData>::New();
    const Vec3 spacing = (hi - lo) / double(cells);
    out->SetDimensions(cells + 1, cells + 1, cells + 1);
    out->SetOrigin(lo.x, lo.y, lo.z);
    out->SetSpacing(spacing.x, spacing.y, spacing.z);
    return out;
}

std::string note_on(const Blocks& blocks) {
    const auto mesh = assemble_grid(blocks);
    EXPECT_TRUE(mesh.has_value());
    return mesh ? mesh->note : "";
}

TEST(MeshParts, ThatDoNotTouchAreSaidToBeSoFarApart) {
    EXPECT_EQ(note_on({image(Vec3(0), {0.75, 2, 2}, 4), image({1, 0, 0}, {2, 2, 2}, 4)}),
              "the cells are in 2 parts that do not touch: they are 0.25 apart, and particles end "
              "there");
    EXPECT_EQ(note_on({image(Vec3(0), {1, 1, 1}, 3), image({1.5, 0, 0}, {2, 1, 1}, 3),
                       image({2.125, 0, 0}, {3, 1, 1}, 3)}),
              "the cells are in 3 parts that do not touch: they are 0.125 to 0.5 apart, and "
              "particles end there");
}

TEST(MeshParts, ThatTouchAreNotWorthAWord) {
    EXPECT_EQ(note_on({image(Vec3(0), {1, 2, 2}, 4), image({1, 0, 0}, {2, 2, 2}, 4)}), "");
    // Their nodes are not the same, their faces are.
    EXPECT_EQ(note_on({image(Vec3(0), {1, 2, 2}, 4), image({1, 0, 0}, {2, 2, 2}, 3)}), "");
}

TEST(MeshParts, OverOthersAreNamedWhicheverIsFirst) {
    const auto coarse = image(Vec3(0), Vec3(2), 4);
    const std::string words = "1 part lies over others, as fine levels over coarse ones: a "
                              "particle stays in the part that it is in";
    for (const auto& fine : {image(Vec3(0.5), Vec3(1.5), 4), image(Vec3(0.6), Vec3(1.3), 3)}) {
        EXPECT_EQ(note_on({coarse, fine}), words);
        EXPECT_EQ(note_on({fine, coarse}), words);
    }
}

} // namespace
} // namespace wakesurf::importer::mesh_parts_test
