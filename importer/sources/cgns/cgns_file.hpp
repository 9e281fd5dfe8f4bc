// A CGNS file as the CGNS library opens it.
#pragma once

#include "core/base/result.hpp"

#include <vtk_cgns.h>
// clang-format off
#include VTK_CGNS(cgnslib.h)
// clang-format on

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

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

} // namespace wakesurf::importer
