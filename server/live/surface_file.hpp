// A surface as a file with its recipe: of a download, of `wakesurf surface`, and of `wakesurf verify`, which makes it again.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/recipe.hpp"
#include "server/data/open_dataset.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// The data of a recipe.
struct RecipeData {
    std::string dataset; ///< its name in files
    std::string flow;    ///< LoadedDataset::flow_text
    std::string values;  ///< values_of
};

/// Returns the recipe of the surface at its end; the caller says what is made of it.
protocol::Recipe recipe_of(const core::SurfacePlan& plan, RecipeData data);
protocol::Recipe recipe_of(const core::SurfacePlan& plan, const LoadedDataset& dataset);

/// Returns a mark of how this machine rounds sines, powers and the like. Libraries of mathematical functions differ in some of the last
/// digits, also one from itself on processors without fused multiply and add; so then do surfaces.
const std::string& rounding_mark();

/// Returns a mark of a surface's cells by their vertices' places, s and t: the same in whatever order vertices and cells come, as that
/// depends on the times at which a moving surface was shown before. It is no protection against forgery. Cost: 5 ms for 100,000 cells.
std::string shape_mark(const core::QuadComplex& mesh);

/// Returns the digest of a surface: of its vertices with all their arrays, its cells, and the fields by name. Cost: 0.1 s for a million
/// vertices on processors with instructions for SHA-256, else 0.4 s.
std::string mesh_digest(const core::QuadComplex& mesh, const protocol::MeshScalars& scalars);

/// A file, and what it was made from.
struct SurfaceFile {
    std::string bytes;
    std::string mesh; ///< mesh_digest
};

/// Puts a file together, and seals it. Error: as mesh_file, surface_lines and lines_file.
/// @param recipe  of which `mesh` is filled in
/// @param mesh    what the file shows: at the recipe's time, cut as often as it says
/// @param text    stands in the file for that of the recipe; empty: the recipe's own
core::Result<SurfaceFile> surface_file(protocol::Recipe recipe,
                                       const core::QuadComplex& mesh,
                                       const core::SurfaceStatistics& statistics,
                                       const protocol::MeshScalars& scalars,
                                       const std::string& text = {});

/// Puts the digest of the file in place of the zeros of the seal in its recipe.
void seal(std::string& file);

/// Says whether a file is byte for byte as it was sealed.
bool seal_holds(std::string file, const protocol::FoundRecipe& recipe);

/// Says how memory for a file is counted.
struct FileMemory {
    const core::MemoryAccount* account;
    core::MemoryAccount::Share* share; ///< of the file: grown to what it takes
    std::chrono::milliseconds patience;
};

/// Builds the surface of a recipe, and makes its file. The same recipe and data give the same bytes, on any number of threads. Error: as
/// surface_at, tessellate, surface_scalars and surface_file; OverLimit.
/// @param plan  of the recipe's rake and parameters
/// @param twin  of other data; null: of the recipe's twin, if that has one
core::Result<SurfaceFile> make_surface_file(const protocol::Recipe& recipe,
                                            const core::SurfacePlan& plan,
                                            const LoadedDataset& dataset,
                                            const std::stop_token& stop,
                                            const FileMemory& memory,
                                            const std::string& text = {},
                                            const core::SurfacePlan* twin = nullptr);

} // namespace wakesurf::server
