// One folder of an OpenFOAM case that holds a mesh, read by VTK, one time-step at a time. Fields whose
// dimensions name units are read beside it (openfoam_values.hpp).
#pragma once

#include "importer/base/source.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/openfoam/openfoam_case.hpp"

#include <vtkOpenFOAMReader.h>

namespace wakesurf::importer {

/// Says whether a leaf holds cells, not faces of a patch.
bool is_inside(const Leaf& leaf);

/// Returns the region's name as in FoamRegion.
std::string region_of(const Leaf& leaf);

/// Reads time-steps and keeps the mesh between them. Not thread-safe.
class OpenfoamReader {
  public:
    /// REQUIRES: `found` outlives this.
    OpenfoamReader(const FoamCase& found, std::string part);

    /// Says whether the part has a cell in any region, as far as its files say.
    bool has_cells() const;

    /// Returns VTK's output, copied shallowly, so that reading on does not change it: paths end in
    /// "internalMesh", or in "boundary" and a patch's name, behind the name of the region if it has one.
    /// After an error nothing is kept. Error: NotFound, Corrupt, OverLimit.
    core::Result<std::vector<Leaf>> read(const FoamTime& time,
                                         const std::vector<core::FieldInfo>& fields);

  private:
    core::Result<void> check_files(const FoamTime& time,
                                   const std::vector<core::FieldInfo>& fields) const;
    core::Result<void> check_headers(const std::string& time) const;
    core::Result<void> open(const std::string& what);
    std::vector<std::string> expected_messages() const;
    void choose_patches();
    core::Result<void> add_values(const FoamTime& time,
                                  const std::vector<core::FieldInfo>& fields,
                                  std::vector<Leaf>& leaves) const;

    const FoamCase& found_;
    std::string part_;
    vtkSmartPointer<vtkOpenFOAMReader> reader_;
};

} // namespace wakesurf::importer
