// Streamlines as bytes, and back: the answer to lines.bin. protocol/wire/FORMAT.md, Lines file. Twin:
// web-client/src/protocol/linesFile.ts.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/lines/stream_lines.hpp"
#include "protocol/wire/bytes.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace wakesurf::protocol {

inline constexpr std::size_t lines_header_bytes = 88;

/// Returns how many bytes so many lines and points take.
std::size_t lines_file_bytes(std::size_t lines, std::size_t points);

/// Writes points as 32-bit numbers from the middle of all of them. @param time  at which the lines hold
std::string lines_file(const core::StreamLines& lines, double time);

struct LinesFile {
    core::StreamLines lines; ///< without `times`
    double time = 0.0;
};

/// Error: Corrupt.
core::Result<LinesFile> read_lines_file(std::span<const std::byte> bytes);

} // namespace wakesurf::protocol
