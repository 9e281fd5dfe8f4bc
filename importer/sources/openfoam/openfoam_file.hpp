// The parts of OpenFOAM's files, plain or compressed with gzip, that the importer itself reads: headers,
// units, patches. VTK reads the values, or openfoam_values.cpp. Format: OpenFOAM User Guide, "Basic
// input/output file format".
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

/// The bound within which a header lies.
constexpr std::size_t foam_header_bytes = 4096;

struct FoamHeader {
    std::string type;   ///< its `class` entry: volVectorField, polyBoundaryMesh ...
    std::string object; ///< the file's name for itself
    /// The number of values that its internalField states; 0: one for all.
    std::uint64_t values = 0;
    /// The unit of its `dimensions` entry: "m/s"; empty without an entry, or for a pure number.
    std::string unit;
};

struct FoamPatch {
    std::string name;
    std::string type;      ///< wall, patch, empty, processor ...
    std::size_t faces = 0; ///< its `nFaces`
    std::string neighbour; ///< of a cyclic one: its `neighbourPatch`; may be empty
    /// The cyclic patch that one between processors is cut from, its `referPatch`.
    std::string part_of;
    std::vector<std::string> groups; ///< its `inGroups`
};

/// Returns `file`, or `file` + ".gz" if only that exists.
std::optional<std::filesystem::path> foam_file(const std::filesystem::path& file);

/// Returns the unpacked content of a file. Empty if it cannot be read, or ends before its checksum.
std::optional<std::string> foam_content(const std::filesystem::path& file, std::size_t at_most);

/// Returns the words of a dictionary behind its header, and its brackets and semicolons, without comments and
/// quotes. Reads the first MiB. Empty if it cannot be read.
std::vector<std::string> foam_words(const std::filesystem::path& file);

/// Reads at most foam_header_bytes. Empty if they are no header of an OpenFOAM file.
std::optional<FoamHeader> read_foam_header(const std::filesystem::path& file);

/// Reads polyMesh/boundary, called `name` in errors. Error: Io, Corrupt.
core::Result<std::vector<FoamPatch>> read_foam_patches(const std::filesystem::path& file,
                                                       const std::string& name);

/// Says whether a field looks like an initial one written by a person: with a directive (#includeEtc,
/// #codeStream ...) behind its header, or one value for all cells. It may then name its patches by groups as
/// well. Reads the first 64 KiB. False if it cannot be read.
bool written_by_hand(const std::filesystem::path& file);

/// Says whether a mesh's file has a directive (#include "file" ...), which VTK would follow, outside of comments and
/// quotes. Of a binary one it reads up to the first list.
bool has_directive(const std::filesystem::path& file);

/// Says whether any file has an #include up to the end of its header.
bool has_include_in_header(const std::filesystem::path& file);

/// Returns false if a file ends unlike those that OpenFOAM has closed: neither with a brace nor with a
/// comment. True for compressed files, whose end is known only after reading all, and for files that cannot
/// be read.
bool ends_as_written(const std::filesystem::path& file);

/// Says whether two files are equal but for their headers; false if one cannot be read.
bool same_foam_body(const std::filesystem::path& one, const std::filesystem::path& other);

/// Converts "[0 1 -1 0 0 0 0]" to "m/s": exponents of kg, m, s, K, mol, A, cd; "[m s^-1]" likewise, of Pa
/// too. Empty for other text and for pure numbers.
std::string foam_unit(std::string_view dimensions);

} // namespace wakesurf::importer
