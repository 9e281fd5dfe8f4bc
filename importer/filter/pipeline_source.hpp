// Time-steps of a VTK pipeline as a source of the importer: the importer's own code makes a flow of them.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/steps_in_memory.hpp"

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Holds a time-step of three-dimensional cells; flat blocks beside them are walls if their names say so.
struct PipelineStep {
    double time = 0.0;
    vtkSmartPointer<vtkDataObject> data; ///< a data set, or blocks of them
};

/// @param velocity  name of the array; empty: by its name, as the importer chooses it.
/// Error: as of an import of the same data in files: Unsupported, NotFound, InvalidArgument, Corrupt.
core::Result<std::shared_ptr<const core::StepsInMemory>> steps_of(std::vector<PipelineStep> steps,
                                                                  const std::string& velocity);

} // namespace wakesurf::importer
