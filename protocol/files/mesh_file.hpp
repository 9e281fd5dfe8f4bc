// The file formats a surface can be written in, by their extensions: one place for the command line and the
// downloads.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "protocol/files/mesh_glb.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/mesh_ply.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::protocol {

enum class MeshFormat { Vtp, Glb, Ply, Obj, Drc };

inline constexpr std::array mesh_formats{MeshFormat::Vtp, MeshFormat::Glb, MeshFormat::Ply,
                                         MeshFormat::Obj, MeshFormat::Drc};

/// Returns the extension without its dot: `vtp`, `glb`, ...
std::string_view extension(MeshFormat format);

/// Returns the media type, a registered one if there is one.
std::string_view content_type(MeshFormat format);

/// Returns the format of an extension without its dot; empty if there is none.
std::optional<MeshFormat> mesh_format(std::string_view extension);

/// Returns all extensions with dots, for messages: `.vtp, .glb, .ply, .obj or .drc`.
std::string mesh_extensions();

/// Returns the bytes of a file. Same input, same bytes. Error: of .glb and .drc, see encode_triangles.
/// REQUIRES: as mesh_vtp. @param glb, ply  are ignored for other formats
core::Result<std::string> mesh_file(MeshFormat format,
                                    const core::QuadComplex& mesh,
                                    const MeshMetadata& metadata,
                                    const MeshScalars& scalars,
                                    GlbCoding glb = GlbCoding::Draco,
                                    PlyElements ply = PlyElements::Cells);

} // namespace wakesurf::protocol
