// The recipe of a file: what its surface was made from, and the digest of what was made, so that `wakesurf verify` can make it again
// and compare. It is one text that stands in a file of any format.
#pragma once

#include "core/surface/rake.hpp"
#include "core/surface/surface_parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// What a file was made from.
struct Recipe {
    std::string version; ///< of wakesurf
    std::string dataset; ///< its name, as the file has it
    std::string flow{};  ///< built-in flow, behind `flow:`; empty: data
    std::string
        values{};      ///< identifies the values of data, on any machine: store::ValueMarks::text
    core::Rake rake{}; ///< of the plan: inside the domain
    core::SurfaceParameters parameters{};     ///< of the plan: with a separation and a direction
    std::optional<core::TwinSettings> twin{}; ///< settings of a twin of the same data
    std::vector<std::string> fields{};        ///< scalars at the vertices
    std::string format{};                     ///< extension of a mesh file
    bool draco = true;                        ///< of a .glb
    std::uint32_t tessellate = 1;             ///< quads that each cell was cut into, each way
    std::string lines{};          ///< what was written instead of the cells; empty: the cells
    std::optional<double> time{}; ///< at which the surface is shown; empty: at its end
    std::vector<double> times{};  ///< of the steps of an animation
    std::string look{};           ///< of an animation, as read_look returned it
    bool step = false;          ///< one of a series of times, in which stream surfaces grow as well
    bool coarse = false;        ///< of an early pass
    std::string unrepeatable{}; ///< why making it again leads to something else; usually empty
    /// Of a mesh file: SHA-256 of the surface, 64 hexadecimal digits; of an animation, of the frames of its steps and the body.
    std::string mesh{};
    std::string shape{};    ///< of a picture: the mark of what it shows, 32 digits
    std::string rounding{}; ///< the mark of how the machine's mathematical functions round

    bool operator==(const Recipe&) const = default;
};

/// The length of a seal: the SHA-256 of the file in which the seal itself is zeros.
inline constexpr std::size_t seal_length = 64;

/// Returns `wakesurf-recipe:`, a seal of zeros, the checksum of the rest and the rest in base64, and a full stop. 0.9 kB for a rake of two points; a
/// point of the rake takes up to 80 bytes.
std::string recipe_text(const Recipe& recipe);

/// Returns the same in lines of at most 900 characters, each with the marker before it: readers of .ply stop at 1024.
std::vector<std::string> recipe_lines(std::string_view text);

/// A recipe in a file.
struct FoundRecipe {
    Recipe recipe;
    std::size_t begin = 0; ///< of its text in the file
    std::size_t end = 0;
    std::string seal;
    std::string text; ///< as recipe_text wrote it, with a seal of zeros

    /// Returns the place of the seal in the file.
    std::size_t seal_begin() const;
};

struct FoundRecipes {
    std::vector<FoundRecipe> sound;
    std::size_t damaged = 0; ///< markers without a sound recipe behind them
};

/// Finds all recipes in the bytes of a file, of any format. The file may be a stranger's: what is in a recipe is checked by the rules of
/// the API, and one of more than 1 MB is damaged. Cost: one search through the file.
FoundRecipes find_recipes(std::string_view file);

} // namespace wakesurf::protocol
