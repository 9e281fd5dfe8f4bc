// The parts of an EnSight Gold geometry file as VTK data sets.
#pragma once

#include "importer/sources/ensight/ensight_stream.hpp"

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <map>

namespace wakesurf::importer {

/// Counts elements of one type, as they follow each other in files of the mesh and of variables.
struct EnsightSection {
    std::string type; ///< hexa8, nfaced ... ; "block" for a structured part
    std::size_t count = 0;
    int dimension = 0; ///< 0 also for ghosts, which are left out
};

struct EnsightPart {
    std::string name;
    std::size_t nodes = 0;
    std::vector<EnsightSection> sections;
    vtkSmartPointer<vtkDataSet> volume; ///< elements of dimension 3, or null
    vtkSmartPointer<vtkPolyData> faces; ///< elements of dimension 2 on the same points, or null
};

struct EnsightGeometry {
    EnsightStream::Encoding encoding = EnsightStream::Encoding::Text;
    bool swapped = false;                     ///< the order of bytes is not this machine's
    std::map<std::size_t, EnsightPart> parts; ///< by number
    /// No part has elements of dimension 3: those of dimension 2 take their place, in sections too.
    bool plane = false;
};

/// Reads the parts. Points are 32 bits; blanked points of blocks carry vtkGhostType. Quadratic elements are
/// not read. Error: NotFound, Io, Corrupt, Unsupported, OverLimit.
core::Result<EnsightGeometry> read_ensight_geometry(const NamedFile& file);

/// Says whether both have the same parts, points and elements.
bool same_geometry(const EnsightGeometry& one, const EnsightGeometry& other);

} // namespace wakesurf::importer
