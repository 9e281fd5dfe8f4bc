// The mark of a block that was a plane before it was given a thickness: what is read of the velocity across it is no
// motion of particles.
#pragma once

#include "core/base/vec3.hpp"

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace wakesurf::importer {

inline constexpr const char* slab_name = "wakesurf: slab";

struct Slab {
    core::Vec3 across{0.0}; ///< the plane, of length 1
    double place = 0.0;     ///< of the plane, along that
    double thickness = 0.0;
    double area = 0.0;  ///< of the block's own cells
    double cells = 0.0; ///< of these
};

/// Returns the mean width of cells, rounded so that it does not depend on their order, nor on the pieces they are in:
/// these may be others at the next time-step.
inline double thickness_of(double area, double cells) {
    constexpr double digits = 0x1p20;
    int power = 0;
    const double part = std::frexp(std::sqrt(area / cells), &power);
    return std::ldexp(std::round(part * digits) / digits, power);
}

inline void mark_slab(vtkDataSet& block, const Slab& slab) {
    const auto mark = vtkSmartPointer<vtkDoubleArray>::New();
    mark->SetName(slab_name);
    for (const double number : {slab.across.x, slab.across.y, slab.across.z, slab.place,
                                slab.thickness, slab.area, slab.cells})
        mark->InsertNextValue(number);
    block.GetFieldData()->AddArray(mark);
}

/// Returns by how much points of a plane may be off it: numbers of six digits, as text has, are rounded so.
/// @param box  lo and hi of x, y and z
inline double off_plane(const std::array<double, 6>& box) {
    const double size = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
    double largest = 0.0;
    for (const double side : box)
        largest = std::max(largest, std::abs(side));
    return std::clamp(2e-5 * largest, 1e-6 * size, 1e-3 * size);
}

/// Returns what a block is marked as; nothing of any other.
inline std::optional<Slab> marked_slab(vtkDataSet& block) {
    vtkDataArray* const mark = block.GetFieldData()->GetArray(slab_name);
    if (mark == nullptr || mark->GetNumberOfValues() != 7)
        return std::nullopt;
    const auto number = [&](vtkIdType i) { return mark->GetTuple1(i); };
    return Slab{{number(0), number(1), number(2)}, number(3), number(4), number(5), number(6)};
}

} // namespace wakesurf::importer
