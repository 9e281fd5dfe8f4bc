// Readers of exported meshes, written from the formats' own descriptions and not from our writers.
#pragma once

#include "core/base/vec3.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::tests {

struct ReadMesh {
    std::vector<core::Vec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    std::map<std::string, std::vector<double>> arrays; ///< all components of a vertex in a row
    std::map<std::string, std::string> about; ///< first word of a comment or metadata -> the rest
    std::string json;                         ///< .glb: the first chunk
};

/// The readers throw std::runtime_error for a malformed file.
ReadMesh read_ply(const std::string& bytes);
ReadMesh read_obj(const std::string& text);

/// Names arrays as the attributes' metadata does.
ReadMesh read_drc(std::string_view bytes);

/// Names arrays as the primitive's attributes, through the extension's ids; checks the container's lengths,
/// and the accessors against Draco's output.
ReadMesh read_glb(const std::string& bytes);

/// Counts how many faces use each undirected edge.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_uses(const ReadMesh& mesh);

} // namespace wakesurf::tests
