// What the importer itself reads of OpenFOAM's files, plain or compressed with gzip: headers, units, patches. The
// values are VTK's business, or that of openfoam_values.hpp. Format: OpenFOAM User Guide, "Basic input/output file format".
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

/// A header lies within these.
constexpr std::size_t foam_header_bytes = 4096;

struct FoamHeader {
    std::string type;         ///< its `class` entry: volVectorField, polyBoundaryMesh ...
    std::string object;       ///< the file's name for itself
    bool names_units = false; ///< its `dimensions` entry is "[m s^-1]", not "[0 1 -1 0 0 0 0]"
    std::uint64_t values = 0; ///< of its internalField, which says their number; 0: one for all
    std::string unit; ///< of its `dimensions` entry: "m/s"; empty without one, or where it has none
};

struct FoamPatch {
    std::string name;
    std::string type;      ///< wall, patch, empty, processor ...
    std::size_t faces = 0; ///< its `nFaces`
    std::string neighbour; ///< of a cyclic one: its `neighbourPatch`; may be empty
    std::string
        part_of; ///< of one between processors: the cyclic one it is cut from, its `referPatch`
};

/// `file`, or `file` + ".gz" where only that exists.
std::optional<std::filesystem::path> foam_file(const std::filesystem::path& file);

/// What a file holds, unpacked. Nothing where it cannot be read, or ends before its checksum.
std::optional<std::string> foam_content(const std::filesystem::path& file, std::size_t at_most);

/// Reads that many bytes at most. Nothing where that is no header of an OpenFOAM file.
std::optional<FoamHeader> read_foam_header(const std::filesystem::path& file);

/// Reads polyMesh/boundary, called `name` in errors. Error: Io, Corrupt.
core::Result<std::vector<FoamPatch>> read_foam_patches(const std::filesystem::path& file,
                                                       const std::string& name);

/// Does a field look as people write initial ones: with a directive (#includeEtc, #codeStream ...) behind its header, or one value
/// for all cells? Then it may name its patches by groups as well. Reads the first 64 KiB. False where it cannot be read.
bool written_by_hand(const std::filesystem::path& file);

/// False where a file ends as none that OpenFOAM has closed: neither with a brace nor with a comment. True for compressed files, whose end
/// is known only after all of them has been read, and where it cannot be read.
bool ends_as_written(const std::filesystem::path& file);

/// Are they equal but for their headers? False where one cannot be read.
bool same_foam_body(const std::filesystem::path& one, const std::filesystem::path& other);

/// "[0 1 -1 0 0 0 0]" -> "m/s": exponents of kg, m, s, K, mol, A, cd; "[m s^-1]" likewise, of Pa too. Empty for other text and for pure numbers.
std::string foam_unit(std::string_view dimensions);

} // namespace wakesurf::importer
