// What is taken of a surface instead of its cells, and its file: its points, or lines on it: timelines, the streamlines, pathlines or
// streaklines that the surface consists of, ribbons along them, arrows (core/surface/contour_lines.hpp, even_lines.hpp,
// surface_cutouts.hpp).
#pragma once

#include "core/base/result.hpp"
#include "core/surface/contour_lines.hpp"
#include "core/surface/surface_cutouts.hpp"
#include "core/surface/surface_parameters.hpp"
#include "protocol/files/mesh_file.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

struct LinesWanted {
    enum class Along : std::uint8_t {
        Release, ///< timelines: particles of one age
        Seed     ///< lines of the particles of one seed
    };
    enum class Form : std::uint8_t { Lines, Ribbons, Arrows, Points };

    Along along = Along::Release;
    /// The number of lines, at values evenly spaced between the ends of the surface; 0: by the distance
    /// between them.
    std::uint32_t values = 0;
    Form form = Form::Lines;
    double spacing = 0.0; ///< length on the surface from one to the next
    double width = 0.0;   ///< length: of ribbons, and of arrows' heads
    /// True if the particles of one seed form lines of the flow, as on stream and path surfaces: arrows bend
    /// with them.
    bool seeds_flow = true;

    bool operator==(const LinesWanted&) const = default;
};

inline constexpr std::uint32_t most_line_values = 1000;

/// Parses `timelines:N`, or the lines that a kind of surface consists of: `streamlines:N`, `pathlines:N` or
/// `streaklines:N`; N from 1 to most_line_values, or `every=D`, the distance between them. Ribbons take the
/// same and `,width=W`; arrows take `arrows:every=D,width=W`, and are the only ones of time surfaces. `points`
/// are the vertices of any kind, and a matter of mesh_file. Error: InvalidArgument, naming what the kind has,
/// or the formats that there are for it.
core::Result<LinesWanted>
read_lines(std::string_view text, core::SurfaceKind kind, MeshFormat format = MeshFormat::Vtp);

/// Holds lines, or the pieces cut out of the surface.
struct SurfaceLines {
    std::vector<core::ContourLine> lines;
    core::Cutouts cutouts;
};

/// Computes the lines. Error: NotFound if the surface has none of the form, OverLimit for too many lines,
/// InvalidArgument for ribbons that are wider than the surface. REQUIRES: not points
/// @param closed  the surface comes from a closed rake
core::Result<SurfaceLines>
surface_lines(const core::QuadComplex& mesh, const LinesWanted& wanted, bool closed = false);

/// Returns `t` or `s`, the parameter that is constant along such lines.
std::string_view parameter(const LinesWanted& wanted);

/// Writes lines (.vtp lines, .obj `l`, .ply edges, .glb LINES) or polygons (.vtp and .ply polygons, .obj `f`,
/// .glb triangles), with the value of s or t for each; in a .glb, which is never compressed, at each vertex.
/// Same input, same bytes. Error: Unsupported for .drc, Corrupt for coordinates that a .glb cannot hold.
core::Result<std::string> lines_file(MeshFormat format,
                                     const SurfaceLines& lines,
                                     const LinesWanted& wanted,
                                     const MeshMetadata& metadata);

} // namespace wakesurf::protocol
