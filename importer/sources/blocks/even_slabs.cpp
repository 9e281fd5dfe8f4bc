#include "importer/base/slab_mark.hpp"
#include "importer/sources/blocks/plane_slab.hpp"

#include <vtkBoundingBox.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace wakesurf::importer {

using core::Vec3;

namespace {

// Puts the sides of a slab where `to` has them. REQUIRES: both are of one plane.
void set_sides(vtkDataSet& block, const Slab& from, const Slab& to) {
    const auto axis =
        static_cast<int>(std::find(&to.across[0], &to.across[0] + 3, 1.0) - &to.across[0]);
    const double half = 0.5 * to.thickness;
    if (auto* image = vtkImageData::SafeDownCast(&block); image != nullptr && axis < 3) {
        std::array<double, 3> origin{};
        std::array<double, 3> spacing{};
        image->GetOrigin(origin.data());
        image->GetSpacing(spacing.data());
        origin[static_cast<std::size_t>(axis)] = to.place - half;
        spacing[static_cast<std::size_t>(axis)] = to.thickness;
        image->SetOrigin(origin.data());
        image->SetSpacing(spacing.data());
    } else if (auto* grid = vtkRectilinearGrid::SafeDownCast(&block); grid != nullptr && axis < 3) {
        const std::array<vtkDataArray*, 3> axes{grid->GetXCoordinates(), grid->GetYCoordinates(),
                                                grid->GetZCoordinates()};
        auto* const sides = axes[static_cast<std::size_t>(axis)];
        sides->SetTuple1(0, to.place - half);
        sides->SetTuple1(1, to.place + half);
    } else if (auto* set = vtkPointSet::SafeDownCast(&block)) {
        for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i) {
            Vec3 p;
            block.GetPoint(i, &p[0]);
            const bool below =
                (glm::dot(p, from.across) < from.place) == (glm::dot(from.across, to.across) > 0.0);
            p += (to.place + (below ? -half : half) - glm::dot(p, to.across)) * to.across;
            set->GetPoints()->SetPoint(i, p.x, p.y, p.z);
        }
    }
    block.Modified();
    mark_slab(block, to);
}

// Says whether the middle of a slab lies in the plane of another one, beyond rounding.
bool lies_in(vtkDataSet& block, const Slab& own, const Slab& plane, double within) {
    const auto nodes = vtkSmartPointer<vtkIdList>::New();
    for (vtkIdType cell = 0; cell < block.GetNumberOfCells(); ++cell) {
        block.GetCellPoints(cell, nodes);
        for (const vtkIdType node : *nodes) { // no others: points may be left over
            Vec3 p;
            block.GetPoint(node, &p[0]);
            const double side = glm::dot(p, own.across) < own.place ? -0.5 : 0.5;
            p -= side * own.thickness * own.across;
            if (!(std::abs(glm::dot(p, plane.across) - plane.place) <= within))
                return false;
        }
    }
    return true;
}

// The more exact of two planes: along axes, then of more cells.
bool less_exact(const Slab& one, const Slab& other) {
    const auto along_axis = [](const Slab& slab) {
        return std::max({std::abs(slab.across.x), std::abs(slab.across.y),
                         std::abs(slab.across.z)}) == 1.0;
    };
    return std::pair(along_axis(one), one.cells) < std::pair(along_axis(other), other.cells);
}

} // namespace

core::Result<void> even_slabs(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks) {
    std::vector<Slab> slabs;
    vtkBoundingBox box;
    for (const auto& block : blocks) {
        if (const auto slab = marked_slab(*block))
            slabs.push_back(*slab);
        box.AddBounds(block->GetBounds());
    }
    if (slabs.empty() || blocks.size() == 1)
        return {};
    std::array<double, 6> bounds{};
    box.GetBounds(bounds.data());
    Slab whole = *std::ranges::max_element(slabs, less_exact);
    bool one = slabs.size() == blocks.size();
    for (std::size_t i = 0; one && i < blocks.size(); ++i)
        one = lies_in(*blocks[i], slabs[i], whole, 2.0 * off_plane(bounds));
    if (!one)
        return core::fail(core::Error::Code::Unsupported,
                          "has flat parts that do not lie in one plane, or beside cells in space",
                          "give the plane or the cells in space alone");
    double area = 0.0;
    double cells = 0.0;
    for (const Slab& slab : slabs) {
        area += slab.area;
        cells += slab.cells;
    }
    if (area > 0.0)
        whole.thickness = thickness_of(area, cells);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        whole.area = slabs[i].area;
        whole.cells = slabs[i].cells;
        set_sides(*blocks[i], slabs[i], whole);
    }
    return {};
}

} // namespace wakesurf::importer
