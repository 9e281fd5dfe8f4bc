// Fast access to the numbers of a VTK array of any type.
#pragma once

#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataArray.h>

#include <cstddef>

namespace wakesurf::importer {

/// Calls visit(value) with a function value(tuple, component) -> double. The function knows an array of float
/// or double by its type: a virtual call a number takes ten times as long.
template <class Visit>
void with_tuples(vtkDataArray& array, const Visit& visit) {
    const auto components = static_cast<std::size_t>(array.GetNumberOfComponents());
    if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(&array)) {
        const float* at = floats->GetPointer(0);
        visit([at, components](std::size_t i, std::size_t c) {
            return static_cast<double>(at[i * components + c]);
        });
    } else if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(&array)) {
        const double* at = doubles->GetPointer(0);
        visit([at, components](std::size_t i, std::size_t c) { return at[i * components + c]; });
    } else {
        visit([&array](std::size_t i, std::size_t c) {
            return array.GetComponent(static_cast<vtkIdType>(i), static_cast<int>(c));
        });
    }
}

} // namespace wakesurf::importer
