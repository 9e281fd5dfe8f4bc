#include "core/surface/vertex_attributes.hpp"

#include <cmath>

namespace wakesurf::core {

namespace {

std::vector<float> deformation_of(const SheetMesh& mesh,
                                  const std::vector<Vec3>& velocity,
                                  const SeedingCurve& seeding,
                                  const std::vector<Vec3>& seed_velocity) {
    std::vector<float> result(mesh.complex.vertices());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double now = glm::length(glm::cross(mesh.stretch[i], velocity[i]));
        const double birth =
            glm::length(glm::cross(seeding.tangent(mesh.complex.s[i]), seed_velocity[i]));
        // A rake along the flow sweeps no area; the ratio is then taken as unchanged.
        result[i] = now > 0.0 && birth > 0.0 ? static_cast<float>(std::log2(now / birth)) : 0.0f;
    }
    return result;
}

} // namespace

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
    for (std::size_t i = 0; i < seeds.size(); ++i)
        seeds[i] = plan.seeding.at(complex.s[i]);
    times.assign(complex.vertices(), p.from);
    std::vector<Vec3> at_birth(complex.vertices());
    if (auto sampled = flow.sample(seeds, times, at_birth, stop, smooth); !sampled)
        return sampled;
    complex.deformation = deformation_of(mesh, velocity, plan.seeding, at_birth);
    return {};
}

} // namespace wakesurf::core
