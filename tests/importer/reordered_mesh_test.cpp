// The same mesh with its nodes and cells in another order and in other pieces, and meshes that are not the same.
#include "importer/assembly/same_mesh.hpp"
#include "tests/importer/small_blocks.hpp"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace wakesurf::importer::reordered_mesh_test {
namespace {

using namespace tests;
using core::Vec3;
using Pointers = std::vector<vtkSmartPointer<vtkDataSet>>;

double value_at(const Vec3& p, int c) {
    return p.x + 10.0 * p.y + 100.0 * p.z + 1000.0 * c;
}

void put_values(vtkDataSet& block) {
    add_array(block, true, "U", 3, value_at);
    add_array(block, false, "T", 1, value_at);
}

/// Returns the cells of `whole` that `part` takes, in any order, with nodes of their own, in any order.
GridPointer
piece(vtkUnstructuredGrid& whole, const std::function<bool(vtkIdType)>& part, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<vtkIdType> cells;
    for (vtkIdType i = 0; i < whole.GetNumberOfCells(); ++i)
        if (part(i))
            cells.push_back(i);
    std::shuffle(cells.begin(), cells.end(), random);
    std::vector<vtkIdType> order(static_cast<std::size_t>(whole.GetNumberOfPoints()));
    std::iota(order.begin(), order.end(), vtkIdType{0});
    std::shuffle(order.begin(), order.end(), random);
    std::vector<vtkIdType> made(order.size(), -1);
    auto out = empty_block();
    std::vector<bool> used(order.size(), false);
    for (const vtkIdType cell : cells)
        for (vtkIdType i = 0; i < whole.GetCell(cell)->GetNumberOfPoints(); ++i)
            used[static_cast<std::size_t>(whole.GetCell(cell)->GetPointId(i))] = true;
    for (const vtkIdType p : order)
        if (used[static_cast<std::size_t>(p)]) {
            Vec3 at;
            whole.GetPoint(p, &at[0]);
            made[static_cast<std::size_t>(p)] = add_point(*out, at);
        }
    for (const vtkIdType cell : cells) {
        std::vector<vtkIdType> nodes;
        for (vtkIdType i = 0; i < whole.GetCell(cell)->GetNumberOfPoints(); ++i)
            nodes.push_back(made[static_cast<std::size_t>(whole.GetCell(cell)->GetPointId(i))]);
        add_cell(*out, whole.GetCellType(cell), nodes);
    }
    return out;
}

Pointers in_pieces(vtkUnstructuredGrid& whole, int count) {
    Pointers out;
    for (int i = 0; i < count; ++i) {
        const auto part = [&](vtkIdType cell) { return cell % count == i; };
        out.push_back(piece(whole, part, static_cast<unsigned>(7 * count + i)));
        put_values(*out.back());
    }
    return out;
}

void expect_values(vtkDataSet& block) {
    auto* u = block.GetPointData()->GetArray("U");
    auto* t = block.GetCellData()->GetArray("T");
    ASSERT_TRUE(u != nullptr && t != nullptr);
    for (vtkIdType i = 0; i < block.GetNumberOfPoints(); ++i) {
        Vec3 p;
        block.GetPoint(i, &p[0]);
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(u->GetComponent(i, c), value_at(p, c)) << i;
    }
    auto wanted = vtkSmartPointer<vtkDataSet>::Take(block.NewInstance());
    wanted->CopyStructure(&block);
    put_values(*wanted);
    for (vtkIdType i = 0; i < block.GetNumberOfCells(); ++i)
        ASSERT_NEAR(t->GetTuple1(i), wanted->GetCellData()->GetArray("T")->GetTuple1(i), 1e-9) << i;
}

TEST(ReorderedMesh, HasTheValuesOfTheSamePlacesInHoweverManyPieces) {
    const auto whole = brick({-1, 0, 0}, 0.1, {3, 4, 5});
    const Pointers one{whole};
    for (const int count : {1, 2, 3, 7}) {
        const auto there = values_on(one, in_pieces(*whole, count));
        ASSERT_TRUE(there.has_value()) << count;
        ASSERT_EQ(there->size(), 1u);
        expect_values(*there->front());
        const auto first = in_pieces(*whole, count);
        const auto back = values_on(first, in_pieces(*whole, 4));
        ASSERT_TRUE(back.has_value()) << count;
        ASSERT_EQ(back->size(), first.size());
        for (const auto& block : *back)
            expect_values(*block);
    }
}

TEST(ReorderedMesh, IsAnotherWhereACellOrANodeIs) {
    const auto whole = brick({0, 0, 0}, 1.0, {2, 2, 2});
    const Pointers one{whole};
    const auto expect_another = [&](GridPointer other) {
        put_values(*other);
        EXPECT_FALSE(values_on(one, Pointers{other}).has_value());
    };
    expect_another(piece(
        *whole, [](vtkIdType cell) { return cell != 3; }, 1));
    expect_another(brick({0, 0, 0}, 1.0, {2, 2, 3}));
    auto moved = brick({0, 0, 0}, 1.0, {2, 2, 2});
    moved->GetPoints()->SetPoint(13, 1.0, 1.0, 1.0 + 1e-9);
    expect_another(moved);
    auto turned = brick({0, 0, 0}, 1.0, {2, 2, 1}); // the same nodes in other cells
    auto tetrahedra = empty_block();
    tetrahedra->SetPoints(turned->GetPoints());
    add_cell(*tetrahedra, VTK_TETRA, {0, 1, 3, 9});
    expect_another(tetrahedra);
}

TEST(ReorderedMesh, KeepsTheTwoValuesOfAPlaceApart) {
    // Two pieces that meet at x = 1, each with a value of its own there.
    const auto make = [](bool swapped) {
        Pointers out;
        for (const int i : {0, 1}) {
            const int side = swapped ? 1 - i : i;
            out.push_back(brick({side, 0, 0}, 0.5, {2, 2, 2}));
            add_array(*out.back(), true, "U", 1,
                      [&](const Vec3&, int) { return 1.0 - 2.0 * side; });
        }
        return out;
    };
    const auto there = values_on(make(false), make(true)).value();
    for (const int side : {0, 1})
        for (vtkIdType i = 0; i < there[std::size_t(side)]->GetNumberOfPoints(); ++i)
            EXPECT_EQ(there[std::size_t(side)]->GetPointData()->GetArray("U")->GetTuple1(i),
                      1.0 - 2.0 * side);
}

TEST(ReorderedMesh, LeavesGhostsOutAndTakesImages) {
    const auto image = [](int lo, int hi) {
        auto out = vtkSmartPointer<vtkImageData>::New();
        out->SetExtent(lo, hi, 0, 2, 0, 2);
        put_values(*out);
        return out;
    };
    auto overlapping = image(2, 4);
    auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < overlapping->GetNumberOfCells(); ++i)
        marks->InsertNextValue(i % 2 == 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    overlapping->GetCellData()->AddArray(marks);
    const Pointers one{image(0, 4)};
    const auto there = values_on(one, Pointers{image(0, 3), overlapping});
    ASSERT_TRUE(there.has_value());
    expect_values(*there->front());
}

} // namespace
} // namespace wakesurf::importer::reordered_mesh_test
