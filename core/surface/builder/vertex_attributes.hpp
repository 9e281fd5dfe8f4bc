// Computes what is known at every vertex besides its place: velocity, and how much the surface has been
// stretched.
#pragma once

#include "core/surface/columns/sheet_mesh.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <array>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace wakesurf::core {

/// Name what the engine knows of every vertex besides its place and velocity, as files and frames do.
inline constexpr std::string_view deformation_name = "deformation";
inline constexpr std::string_view approximated_name = "approximated";
inline constexpr std::string_view error_name = "error";
inline constexpr std::string_view interval_error_name = "interval_error";
/// Of a surface that is compared with a twin.
inline constexpr std::string_view twin_distance_name = "twin_distance";
inline constexpr std::string_view twin_lag_name = "twin_lag";

inline bool is_twin_name(std::string_view name) {
    return name == twin_distance_name || name == twin_lag_name;
}

inline constexpr std::array derived_vertex_names{deformation_name, approximated_name, error_name,
                                                 interval_error_name};
/// Name the components of the velocity, along x, y and z.
inline constexpr std::array<std::string_view, 3> velocity_component_names{
    "velocity_x", "velocity_y", "velocity_z"};

/// Name the components of the surface's normal, of length 1.
inline constexpr std::array<std::string_view, 3> normal_component_names{"normal_x", "normal_y",
                                                                        "normal_z"};

/// Returns a component of the velocity or of the normal, by one of the names above: one number a vertex, NaN
/// where there is no normal; nothing for other names. Normals are those of the mesh, or else of its tangents.
/// Cost: O(vertices).
std::optional<std::vector<float>> vertex_component(const QuadComplex& mesh, std::string_view name);

/// Returns whether it is such a name.
bool is_vertex_component(std::string_view name);

/// Returns whether it is such a name and needs tangents.
bool is_normal_component(std::string_view name);

/// Fills velocity, and tangents and deformation when asked for: log2 of the area element |dx/ds x v| over
/// what it was at release. Error: what sampling reports. Cost: one sample a vertex, two with deformation.
Result<void> add_attributes(SheetMesh& mesh, const SurfacePlan& plan, std::stop_token stop);

} // namespace wakesurf::core
