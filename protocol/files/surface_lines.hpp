// The lines on a surface, instead of its cells, as a file of polylines: timelines, and the streamlines, pathlines or streaklines that the
// surface consists of (core/surface/contour_lines.hpp).
#pragma once

#include "core/base/result.hpp"
#include "core/surface/contour_lines.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/files/mesh_file.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// At so many values, evenly spaced between the ends of the surface.
struct LinesWanted {
    enum class Along : std::uint8_t {
        Release, ///< timelines: particles of one age
        Seed     ///< what particles of one seed form
    };

    Along along = Along::Release;
    std::uint32_t values = 0;

    bool operator==(const LinesWanted&) const = default;
};

inline constexpr std::uint32_t most_line_values = 1000;

/// `timelines:N`, or the lines that a kind of surface consists of: `streamlines:N`, `pathlines:N` or `streaklines:N`; N from 1 to
/// most_line_values. Error: InvalidArgument, naming what the kind has.
core::Result<LinesWanted> read_lines(std::string_view text, core::SurfaceKind kind);

/// Error: NotFound where there is no such line.
core::Result<std::vector<core::ContourLine>> surface_lines(const core::QuadComplex& mesh,
                                                           const LinesWanted& wanted);

/// A .vtp (lines; the value of s or t for each) or an .obj (`l`). Same input, same bytes. Error: Unsupported for another format.
core::Result<std::string> lines_file(MeshFormat format,
                                     const std::vector<core::ContourLine>& lines,
                                     const LinesWanted& wanted,
                                     const MeshMetadata& metadata);

} // namespace wakesurf::protocol
