// An array as the XML files of VTK have it inline: cut into blocks, each compressed by zlib, and all of it as
// base64. Readers that cannot take appended data, as Debian 12's ParaView, read this.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace wakesurf::protocol {

/// Returns the text between the tags of a `<DataArray format="binary">` in a file that says
/// header_type="UInt64" and compressor="vtkZLibDataCompressor". Same bytes, same text, on any number of
/// threads. Cost: 15 ms a MB and core.
std::string vtk_inline(std::span<const std::byte> data);

} // namespace wakesurf::protocol
