// What an exported file says about its surface, the same for every format, and how formats spell fields and numbers.
#pragma once

#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"
#include "core/surface/surface_statistics.hpp"

#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// Describes how the surface of a file was made.
struct MeshMetadata {
    core::Rake rake{};                    ///< the rake of the surface
    core::SurfaceParameters parameters{}; ///< the parameters asked for
    double separation = 0.0; ///< of the mesh: the quad budget may have raised the one asked for
    std::uint32_t tessellate = 1; ///< quads that a cell of that separation was cut into, each way
    std::string dataset;          ///< id or name of the data
    std::string version;          ///< of wakesurf
    /// The time at which the surface is shown, if that is not its end.
    std::optional<double> time{};
    /// The reason why the surface is not what was asked for; usually empty.
    std::string stopped{};
    /// What the surface's statistics state of its errors, by their names there.
    std::map<std::string, double> errors{};
    /// The text of its recipe (recipe.hpp); empty: it has none.
    std::string recipe{};
};

/// Says whether a file states the kind of a rake: three points of a circle would be taken for a polyline.
inline bool tells_kind(core::Rake::Kind kind) {
    return kind == core::Rake::Kind::Circle || kind == core::Rake::Kind::Points;
}

/// Returns `error99`, `intervalError99` and `intervalUnresolved`, those that there are.
std::map<std::string, double> stated_errors(const core::SurfaceStatistics& statistics);

/// Holds further vertex arrays by name, each with one value a vertex.
using MeshScalars = std::map<std::string, std::vector<float>>;

/// Returns the metadata as lines, without the recipe: `kind stream`, `rake 0,0,0 1,0,0`, ...; no line has a control character in it, for any name of the
/// dataset.
std::vector<std::string> mesh_lines(const MeshMetadata& metadata);

/// Returns the comments of .ply and .obj: those lines after those of the recipe, each begun with `word` and ended.
std::string mesh_comments(const MeshMetadata& metadata, std::string_view word);

/// Names of fields where a format takes one word only: a word for each scalar, in order: any character but ASCII letters, digits and `_` becomes `_`, and
/// a word that is in `taken`, or was given before, gets a number behind it.
std::vector<std::string> one_word_names(const MeshScalars& scalars, std::set<std::string> taken);

/// Returns such words in capitals behind a `_`, which glTF prescribes for attributes of applications.
std::vector<std::string> gltf_names(const MeshScalars& scalars, std::set<std::string> taken);

/// A number as the shortest decimal text that reads back the same.
template <class T>
std::string number_text(T value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

} // namespace wakesurf::protocol
