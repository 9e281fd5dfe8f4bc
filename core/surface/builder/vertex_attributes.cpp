#include "core/surface/builder/vertex_attributes.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/patches/side_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

std::vector<float> deformation_of(const SheetMesh& mesh,
                                  const std::vector<Vec3>& velocity,
                                  const SeedingCurve& seeding,
                                  const std::vector<Vec3>& seed_velocity) {
    std::vector<float> result(mesh.complex.vertices());
    for_each_index(result.size(), [&](std::size_t i) {
        const double now = glm::length(glm::cross(mesh.stretch[i], velocity[i]));
        const double birth =
            glm::length(glm::cross(seeding.tangent(mesh.complex.s[i]), seed_velocity[i]));
        // A rake along the flow sweeps no area; the ratio is then taken as unchanged.
        result[i] = now > 0.0 && birth > 0.0 ? static_cast<float>(std::log2(now / birth)) : 0.0f;
    });
    return result;
}

/// Returns the index of a name among the names; their number if it is none of them.
template <std::size_t Count>
std::size_t place_in(const std::array<std::string_view, Count>& names, std::string_view name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::optional<Vec3> normal_of(const QuadComplex& mesh, std::size_t v) {
    if (!mesh.normal.empty())
        return Vec3(mesh.normal[v]);
    return v < mesh.tangents.size() ? unit_normal(mesh.tangents[v]) : std::nullopt;
}

} // namespace

bool is_normal_component(std::string_view name) {
    return place_in(normal_component_names, name) < normal_component_names.size();
}

bool is_vertex_component(std::string_view name) {
    return is_normal_component(name) ||
           place_in(velocity_component_names, name) < velocity_component_names.size();
}

std::optional<std::vector<float>> vertex_component(const QuadComplex& mesh, std::string_view name) {
    if (!is_vertex_component(name))
        return std::nullopt;
    const bool of_normal = is_normal_component(name);
    const auto axis = static_cast<int>(of_normal ? place_in(normal_component_names, name)
                                                 : place_in(velocity_component_names, name));
    std::vector<float> out(mesh.vertices(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t v = 0; v < out.size(); ++v)
        if (!of_normal)
            out[v] = mesh.velocity[v][axis];
        else if (const auto normal = normal_of(mesh, v))
            out[v] = static_cast<float>((*normal)[axis]);
    return out;
}

Result<void> add_attributes(SheetMesh& mesh, const SurfacePlan& plan, std::stop_token stop) {
    const Flow& flow = *plan.flow;
    const SurfaceParameters& p = plan.parameters;
    QuadComplex& complex = mesh.complex;
    const bool smooth = p.interpolation == Interpolation::Smooth;
    std::vector<double> times(complex.vertices(), p.from);
    if (p.kind == SurfaceKind::Path)
        for (std::size_t i = 0; i < times.size(); ++i)
            times[i] += complex.t[i];
    std::vector<Vec3> velocity(complex.vertices());
    if (auto sampled = flow.sample(complex.position, times, velocity, stop, smooth); !sampled)
        return sampled;
    complex.velocity.assign(velocity.begin(), velocity.end());
    if (p.tangents)
        for (std::size_t i = 0; i < velocity.size(); ++i)
            complex.tangents.push_back({mesh.stretch[i], velocity[i]});
    if (!p.deformation)
        return {};

    std::vector<Vec3> seeds(complex.vertices());
    for_each_index(seeds.size(), [&](std::size_t i) { seeds[i] = plan.seeding.at(complex.s[i]); });
    times.assign(complex.vertices(), p.from);
    std::vector<Vec3> at_birth(complex.vertices());
    if (auto sampled = flow.sample(seeds, times, at_birth, stop, smooth); !sampled)
        return sampled;
    complex.deformation = deformation_of(mesh, velocity, plan.seeding, at_birth);
    return {};
}

} // namespace wakesurf::core
