// Pieces of a mesh with points at one place and velocities that jump there: what is one node, and what stays apart.
#include "importer/assembly/node_values.hpp"
#include "importer/assembly/wall_assembly.hpp"
#include "tests/importer/small_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace wakesurf::importer::meeting_pieces_test {
namespace {

using namespace tests;
using core::Vec3;
using Pointers = std::vector<vtkSmartPointer<vtkDataSet>>;

const FieldParts velocity{{{"U", 3, core::FieldInfo::Source::Point, {}, {}}}, {}, 3};

/// The velocity at a point, and the middle of its piece.
using Flow = std::function<Vec3(const Vec3& p, const Vec3& piece)>;

/// Two pieces of 4 x 4 x 2 cells of side 0.5 that meet at z = 1, in one block or in two; or the same cells, each
/// with nodes of its own.
class Pieces {
  public:
    Pieces(bool in_one_block, bool of_single_cells = false) {
        for (int half = 0; half < 2; ++half) {
            if (half == 0 || !in_one_block)
                blocks.push_back(empty_block());
            auto& block = *vtkUnstructuredGrid::SafeDownCast(blocks.back());
            const auto whole = brick({0, 0, half}, 0.5, {4, 4, 2});
            vtkIdType first = block.GetNumberOfPoints();
            const auto add_points = [&](vtkDataSet& from) {
                Vec3 middle;
                from.GetCenter(&middle[0]);
                for (vtkIdType i = 0; i < from.GetNumberOfPoints(); ++i) {
                    Vec3 p;
                    from.GetPoint(i, &p[0]);
                    add_point(block, p);
                    middles.push_back(middle);
                    points.push_back(p);
                }
            };
            if (!of_single_cells)
                add_points(*whole);
            for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c) {
                std::vector<vtkIdType> nodes;
                const auto cell = of_single_cells ? brick({0, 0, 0}, 0.5, {1, 1, 1}) : whole;
                if (of_single_cells) {
                    double bounds[6];
                    whole->GetCell(c)->GetBounds(bounds);
                    first = block.GetNumberOfPoints();
                    add_points(*brick({bounds[0], bounds[2], bounds[4]}, 0.5, {1, 1, 1}));
                }
                auto* ids = cell->GetCell(of_single_cells ? 0 : c)->GetPointIds();
                for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
                    nodes.push_back(first + ids->GetId(i));
                add_cell(block, VTK_HEXAHEDRON, nodes);
            }
        }
    }

    std::vector<float> values(const Flow& flow) const {
        std::vector<float> out;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (int c = 0; c < 3; ++c)
                out.push_back(static_cast<float>(flow(points[i], middles[i])[c]));
        return out;
    }

    GridAssembly assembled(const std::vector<Flow>& steps) const {
        AssemblyRequest request;
        request.velocities = [&](const auto& look) {
            for (const Flow& flow : steps)
                look(values(flow));
            return core::Result<void>();
        };
        auto out = assemble_grid(blocks, request).value();
        find_walls(out, {});
        return out;
    }

    /// Puts the flow into the blocks and returns the values at the nodes.
    std::vector<float> at_nodes(const GridAssembly& assembly, const Flow& flow) const {
        const auto all = values(flow);
        std::size_t at = 0;
        for (const auto& block : blocks) {
            auto array = vtkSmartPointer<vtkDoubleArray>::New();
            array->SetName("U");
            array->SetNumberOfComponents(3);
            for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i, at += 3)
                array->InsertNextTuple3(all[at], all[at + 1], all[at + 2]);
            block->GetPointData()->AddArray(array);
        }
        return node_values(assembly, blocks, velocity).value();
    }

    Pointers blocks;
    std::vector<Vec3> points;  ///< of all blocks
    std::vector<Vec3> middles; ///< of each point's piece
};

std::size_t walls(const GridAssembly& assembly) {
    std::size_t found = 0;
    const auto& mesh = std::get<core::CellMesh>(assembly.grid);
    for (const auto& cell : mesh.cells)
        for (std::size_t f = 0; f < core::face_count(cell.shape); ++f)
            found += cell.beyond[f] == core::beyond_wall ? 1 : 0;
    return found;
}

Vec3 counterflow(const Vec3&, const Vec3& piece) {
    return {piece.z < 1 ? 1.0 : -1.0, 0, 0};
}

constexpr std::size_t joined_nodes = 5 * 5 * 5;
constexpr std::size_t between = 5 * 5;

TEST(MeetingPieces, OfTwoFluidsStayApartWithWallsBetweenInOneFileOrInTwo) {
    for (const bool in_one_block : {true, false}) {
        const Pieces pieces(in_one_block);
        // With a shear of its own across each fluid.
        const Flow flow = [](const Vec3& p, const Vec3& piece) {
            return counterflow(p, piece) + Vec3(0.2 * p.z, 0.5 * p.z, 0.0);
        };
        const auto assembly = pieces.assembled({flow});
        EXPECT_EQ(core::node_count(assembly.grid), joined_nodes + between);
        EXPECT_EQ(walls(assembly), 2u * 4 * 4);
        EXPECT_EQ(assembly.note, "25 points stay apart from others at the same place, where the "
                                 "velocity jumps by up to 2: no particle crosses there");
        const auto values = pieces.at_nodes(assembly, flow);
        for (std::size_t i = 0; i < values.size(); i += 3)
            EXPECT_GT(std::abs(values[i]), 0.55f);
        EXPECT_TRUE(assembly.meeting.empty());
    }
}

TEST(MeetingPieces, ThatDifferByRoundingsAreOneNodeWithTheMean) {
    const Pieces pieces(true);
    const Flow flow = [](const Vec3& p, const Vec3& piece) {
        return Vec3(1.0 + (piece.z < 1 ? 0.0 : 4e-6) + p.z, 0.0, 0.0);
    };
    const auto assembly = pieces.assembled({flow});
    EXPECT_EQ(core::node_count(assembly.grid), joined_nodes);
    EXPECT_EQ(walls(assembly), 0u);
    EXPECT_EQ(assembly.note.find("differ"), std::string::npos) << assembly.note;
    const auto& points = std::get<core::CellMesh>(assembly.grid).points;
    const auto values = pieces.at_nodes(assembly, flow);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(values[3 * i],
                    1.0 + points[i].z +
                        (points[i].z == 1  ? 2e-6
                         : points[i].z > 1 ? 4e-6
                                           : 0),
                    5e-7);
}

// One-sided means at the border of a processor: the jump is twice what the values change by within a cell.
TEST(MeetingPieces, AveragedEachByItselfAreOneNodeAndTheNoteSaysByHowMuchTheyDiffer) {
    const Pieces pieces(false);
    const Flow flow = [](const Vec3& p, const Vec3& piece) {
        const double inside = p.z == 1.0 ? (piece.z < 1 ? 0.75 : 1.25) : p.z;
        return Vec3(1.0, inside, 0.0);
    };
    const auto assembly = pieces.assembled({flow});
    EXPECT_EQ(core::node_count(assembly.grid), joined_nodes);
    EXPECT_NE(assembly.note.find("where points are one node, their velocities differ by up to 0.5: "
                                 "the mean is taken"),
              std::string::npos)
        << assembly.note;
    const auto values = pieces.at_nodes(assembly, flow);
    const auto& points = std::get<core::CellMesh>(assembly.grid).points;
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(values[3 * i + 1], points[i].z, 1e-6);
}

TEST(MeetingPieces, OfSingleCellsAreOneMeshHoweverTheValuesJump) {
    const Pieces pieces(true, true);
    const Flow layer = [](const Vec3&,
                          const Vec3& piece) { // constant in cells, a shear layer at z = 1
        return Vec3(piece.z < 1 ? 1.0 : -1.0, 0.1 * piece.x, 0.0);
    };
    const auto assembly = pieces.assembled({layer});
    EXPECT_EQ(core::node_count(assembly.grid), joined_nodes);
    EXPECT_EQ(walls(assembly), 0u);
    EXPECT_NE(assembly.note.find("differ by up to 2: the mean is taken"), std::string::npos)
        << assembly.note;
    const auto values = pieces.at_nodes(assembly, layer);
    const auto& points = std::get<core::CellMesh>(assembly.grid).points;
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(values[3 * i], points[i].z == 1 ? 0.0 : points[i].z < 1 ? 1.0 : -1.0, 1e-6);
}

// As finite element programs write elements that they divide: 27 of 2 x 2 x 2 cells.
TEST(MeetingPieces, ThatAreDividedElementsAreOneMeshHoweverTheValuesJump) {
    Pointers blocks;
    std::vector<float> values;
    for (int i = 0; i < 27; ++i) {
        blocks.push_back(brick({i % 3, i / 3 % 3, i / 9}, 0.5, {2, 2, 2}));
        for (vtkIdType p = 0; p < blocks.back()->GetNumberOfPoints(); ++p)
            values.insert(values.end(), {i % 2 == 0 ? 1.0f : -1.0f, 0.0f, 0.0f});
    }
    AssemblyRequest request;
    request.velocities = [&](const auto& look) {
        look(values);
        return core::Result<void>();
    };
    EXPECT_EQ(core::node_count(assemble_grid(blocks, request).value().grid), 7u * 7 * 7);
}

TEST(MeetingPieces, AreJoinedWhereTheirValuesAgreeAndApartWhereTheyJump) {
    const Pieces pieces(true);
    const Flow flow = [](const Vec3& p,
                         const Vec3& piece) { // both sides of a splitter, as far as x = 1
        return p.x < 1 ? counterflow(p, piece) : Vec3(0.5, 0.0, 0.0);
    };
    const auto assembly = pieces.assembled({flow});
    EXPECT_EQ(core::node_count(assembly.grid), joined_nodes + 2 * 5) << "those at x = 0 and 0.5";
    EXPECT_EQ(walls(assembly), 2u * 2 * 4);
}

TEST(MeetingPieces, ThatComeApartAtALaterTimeStepAreFoundThere) {
    const Pieces pieces(true);
    const Flow rest = [](const Vec3&, const Vec3&) { return Vec3(0.0); };
    const auto first = pieces.assembled({rest, rest});
    EXPECT_EQ(core::node_count(first.grid), joined_nodes);
    EXPECT_FALSE(first.meeting.tears(pieces.values(rest)));
    EXPECT_TRUE(first.meeting.tears(pieces.values(counterflow)));
    const auto all = pieces.assembled({rest, counterflow});
    EXPECT_EQ(core::node_count(all.grid), joined_nodes + between);
}

} // namespace
} // namespace wakesurf::importer::meeting_pieces_test
