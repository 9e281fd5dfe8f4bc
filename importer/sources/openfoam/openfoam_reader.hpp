// One folder of an OpenFOAM case that holds a mesh, one time-step at a time: VTK reads the mesh, our own code the values.
#pragma once

#include "core/base/result.hpp"
#include "importer/base/source.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/openfoam/openfoam_case.hpp"

#include <vtkOpenFOAMReader.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

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

/// The values of a field's file, text and binary, plain and compressed (openfoam_values.cpp). They are not read by VTK's reader: it
/// takes a field's name from inside the file, fails on dimensions that name units, "[m s^-1]", and on entries for
/// groups of patches.
struct FoamValues {
    std::vector<float> inside; ///< the value of one cell, if it counts for all, or of each
    /// The values of faces, by patch, likewise; patches without a value are left out.
    std::map<std::string, std::vector<float>> patches;
};

/// Reads the values. Error: Corrupt, Unsupported (numbers of another machine). @param name  of the file in
/// messages
core::Result<FoamValues>
read_foam_values(const std::filesystem::path& file, const std::string& name, int components);

} // namespace wakesurf::importer
