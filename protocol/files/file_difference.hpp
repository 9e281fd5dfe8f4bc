// Where two files of a surface differ, in words: the first value of a vertex or a cell that is another.
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::protocol {

struct FileDifference {
    /// `the position of vertex 12 is (1, 2, 3) instead of (1, 2, 4)`; empty: all values, and all else that is not compressed, are the same.
    std::string what;
    bool recompressed = false; ///< compressed bytes differ that say the same
};

/// Returns the first difference. Only the structure of `right` is believed, which a writer here has made; the other file may be a stranger's.
/// @param format  extension: of a mesh file, or of an animation
/// Cost: as comparing the bytes; where compressed arrays of a .vtp differ, as decompressing them.
FileDifference
first_difference(std::string_view format, std::string_view given, std::string_view right);

} // namespace wakesurf::protocol
