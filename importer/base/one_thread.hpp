// VTK without threads of its own.
#pragma once

namespace wakesurf::importer {

/// Sets VTK's threads to one, for the whole process, before VTK computes anything: processes use the cores,
/// and in a forked one VTK would wait for threads that do not exist.
void keep_vtk_to_one_thread();

} // namespace wakesurf::importer
