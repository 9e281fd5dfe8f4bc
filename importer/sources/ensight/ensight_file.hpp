// The files of EnSight Gold: a run of lines, whole numbers and numbers, whichever of three encodings a file is in, and what
// geometry and variable files hold. (VTK's readers of the format do not notice where a file ends: they repeat the last number
// they saw.)
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/sources/files/source_files.hpp"

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

/// One file, read from its beginning to its end.
class EnsightStream {
  public:
    /// Reads the whole file. Error: NotFound, Io, OverLimit (memory).
    static core::Result<EnsightStream> open(const NamedFile& file);

    /// Geometry files state whether they are binary; variables have the encoding of their geometry.
    enum class Encoding { Text, CBinary, FortranBinary };
    /// Detects the encoding of a geometry file, and skips the first line if that names one.
    Encoding detect();

    void set_encoding(Encoding encoding, bool swapped) {
        encoding_ = encoding;
        swapped_ = swapped;
    }

    bool swapped() const { return swapped_; }

    std::size_t size() const { return text_.size(); } ///< of the file in bytes

    /// Says whether only space is left.
    bool at_end();
    /// The functions below return Corrupt, naming the file, if it ends too early or holds something else.
    core::Result<std::string> line();
    core::Result<std::vector<std::int32_t>> integers(std::size_t count);
    core::Result<std::vector<float>> numbers(std::size_t count);
    /// Reads a whole number of at least 0. The first one in a file decides on the order of its bytes.
    core::Result<std::size_t> count();

    /// Steps back before the line read last.
    void unread_line() { at_ = before_line_; }

    tl::unexpected<core::Error> damaged(const std::string& what) const;

  private:
    template <class T>
    core::Result<std::vector<T>> values(std::size_t count);
    core::Result<std::string_view> bytes(std::size_t count);
    core::Result<std::string_view> word();

    std::string name_;
    std::string text_;
    std::size_t at_ = 0;
    std::size_t before_line_ = 0;
    Encoding encoding_ = Encoding::Text;
    bool swapped_ = false;
    bool order_known_ = false;
};

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

/// Holds a part's values; those of elements are split by their dimension like EnsightPart. NaN stands for
/// undefined.
struct EnsightValues {
    vtkSmartPointer<vtkFloatArray> volume; ///< also those of nodes
    vtkSmartPointer<vtkFloatArray> faces;
};

/// Returns values by the number of the part, without parts that have none. Error: NotFound, Io, Corrupt,
/// Unsupported (partial values), OverLimit.
core::Result<std::map<std::size_t, EnsightValues>> read_ensight_variable(
    const NamedFile& file, const EnsightGeometry& geometry, const core::FieldInfo& field);

} // namespace wakesurf::importer
