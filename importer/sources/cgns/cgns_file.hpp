// A CGNS file as the CGNS library opens it: its time-steps, and its zones where VTK's reader cannot read them. CFD General
// Notation System, Standard Interface Data Structures.
#pragma once

#include "core/base/result.hpp"

#include <vtk_cgns.h>
// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/series/file_series.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

/// CGNS names have 32 characters.
using CgnsName = std::array<char, 34>;

class CgnsFile {
  public:
    explicit CgnsFile(const std::filesystem::path& path)
        : sound_(cg_open(path.c_str(), CG_MODE_READ, &id_) == CG_OK) {}

    ~CgnsFile() {
        if (sound_)
            cg_close(id_);
    }

    CgnsFile(const CgnsFile&) = delete;
    CgnsFile& operator=(const CgnsFile&) = delete;

    bool sound() const { return sound_; }

    int id() const { return id_; }

  private:
    int id_ = 0;
    bool sound_ = false;
};

/// Returns the library's error. Call it directly after a call of the CGNS library that failed.
inline tl::unexpected<core::Error> cgns_damage(const std::string& file) {
    return core::fail(core::Error::Code::Corrupt,
                      file + " is damaged, or not the kind of file that it claims to be (CGNS: " +
                          cg_get_error() + ")");
}

/// Describes a zone, by the file's numbers.
struct CgnsZone {
    std::string name; ///< of the file
    int file = 0;
    int base = 0;
    int zone = 0;
    int dimension = 3; ///< of its cells
    int space = 3;     ///< coordinates of a node
    bool structured = false;
    /// Counts nodes, then cells, along each axis; or the nodes and the cells of an unstructured zone.
    std::array<cgsize_t, 9> size{};
};

constexpr std::array<cgsize_t, 3> cgns_first{1, 1, 1};

/// Is true of elements of a dimension, 2 or 3, of any order. REQUIRES: not MIXED, NGON_n or NFACE_n.
inline bool has_dimension(CGNS_ENUMT(ElementType_t) type, int dimension) {
    const std::string_view name = cg_ElementTypeName(type);
    if (dimension == 2)
        return name.starts_with("TRI") || name.starts_with("QUAD");
    return name.starts_with("TETRA") || name.starts_with("PYRA") || name.starts_with("PENTA") ||
           name.starts_with("HEXA");
}

struct CgnsUnits {
    /// The factor from coordinates to the unit of length of the velocities.
    double coordinates = 1.0;
    /// Says what was converted; may be empty.
    std::string note;
};

struct CgnsSurvey {
    /// The times of BaseIterativeData, as they are; empty if there are none.
    std::vector<double> times;
    CgnsUnits units;
    int dimension = 3; ///< of the cells that are read: 2 of a plane
    /// True if cells of a zone are not numbered from 1 to their count: elements of boundaries come before
    /// them.
    bool cells_have_other_numbers = false;
};

/// Reads everything but the values (cgns_survey.cpp), times as in chapter 11: vtkCGNSReader would choose among them without a
/// message. Error: Corrupt (not CGNS, cut off, pointers that do not fit the number of
/// time-steps), Unsupported (no base with cells in space or in a plane; bases with times of their own; several solutions at
/// one place without times, which are ambiguous; zones in different units).
core::Result<CgnsSurvey> survey_cgns(const ListedFile& file);

/// Reads all zones with the CGNS library alone (cgns_zones.cpp), a leaf each, for files whose elements are numbered as VTK's reader
/// cannot read them: it takes for cells the elements numbered up to the count of cells, boundary or not, and leaves out the others
/// without a message. Error: Corrupt, Unsupported.
/// @param dimension  of the cells: zones of other bases are left out. @param step  its index among the times of the file; empty if it has none
core::Result<std::vector<Leaf>> read_cgns_zones(const ListedFile& file,
                                                int dimension,
                                                std::optional<std::size_t> step,
                                                const WantedArrays& wanted);

} // namespace wakesurf::importer
