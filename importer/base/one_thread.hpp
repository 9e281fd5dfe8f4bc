// VTK without threads of its own.
#pragma once

namespace wakesurf::importer {

/// For the whole process, before VTK computes anything: processes use the cores, and in one that was forked, VTK would wait
/// for threads that are not there.
void keep_vtk_to_one_thread();

} // namespace wakesurf::importer
