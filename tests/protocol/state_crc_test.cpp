#include "protocol/state_crc.hpp"
#include "tests/protocol/sample_meshes.hpp"

namespace wakesurf::protocol {
namespace {

std::vector<LatticePoint> nodes_of(const core::QuadComplex& mesh) {
    std::vector<LatticePoint> nodes;
    for (const core::Vec3& p : mesh.position)
        nodes.push_back(quantise(lattice_over(samples::domain), p));
    return nodes;
}

TEST(StateCrc, DoesNotDependOnHowTheStateWasCut) {
    const auto mesh = samples::hanging_sheet(9, 13, 2);
    const auto nodes = nodes_of(mesh);
    const std::span cells(mesh.cells);
    StateCrc whole;
    whole.add(nodes);
    whole.add(cells);
    StateCrc pieces;
    pieces.add(cells.first(5));
    pieces.add(std::span(nodes).first(50));
    pieces.add(std::span(nodes).subspan(50));
    pieces.add(cells.subspan(5));
    EXPECT_EQ(pieces.value(), whole.value());
}

TEST(StateCrc, ChangesWithAnyPositionCellOrCount) {
    const auto mesh = samples::sheet(4, 5);
    auto nodes = nodes_of(mesh);
    auto cells = mesh.cells;
    const auto value = [&] {
        StateCrc crc;
        crc.add(nodes);
        crc.add(cells);
        return crc.value();
    };
    const std::uint32_t before = value();
    ++nodes[7][1];
    EXPECT_NE(value(), before);
    --nodes[7][1];
    std::swap(cells[2], cells[3]);
    EXPECT_NE(value(), before);
    std::swap(cells[2], cells[3]);
    EXPECT_EQ(value(), before);
    nodes.pop_back();
    EXPECT_NE(value(), before);
}

} // namespace
} // namespace wakesurf::protocol
