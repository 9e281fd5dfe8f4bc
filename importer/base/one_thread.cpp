// C++17: VTK 9.1's header is not valid C++20 (constructors with template arguments).
#include "importer/base/one_thread.hpp"

#include <vtkSMPTools.h>

namespace wakesurf::importer {

void keep_vtk_to_one_thread() {
    vtkSMPTools::SetBackend("Sequential");
}

} // namespace wakesurf::importer
