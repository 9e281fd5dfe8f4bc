#include "server/data/surface_scalars.hpp"

#include "core/field/sample_scalar.hpp"
#include "core/field/velocity_gradient.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "server/base/field_names.hpp"

#include <algorithm>

namespace wakesurf::server {

namespace {

bool stored(const LoadedDataset& dataset, const std::string& name) {
    return dataset.scalars != nullptr && dataset.scalars->find(name);
}

/// Says whether every export has it, unless the dataset has a field of that name.
bool written_anyhow(const LoadedDataset& dataset, const std::string& name) {
    const bool derived =
        std::ranges::find(core::derived_vertex_names, name) != core::derived_vertex_names.end();
    return name == dataset.info.velocity || (derived && !stored(dataset, name));
}

/// Derives a gradient field; a stored field of that name goes before it.
std::optional<core::GradientField> derived_here(const LoadedDataset& dataset,
                                                const std::string& name) {
    return stored(dataset, name) ? std::nullopt : core::find_gradient_field(name);
}

/// Says whether to derive a component of the velocity; a stored field of that name goes before it.
bool component_here(const LoadedDataset& dataset, const std::string& name) {
    return core::is_vertex_component(name) && !stored(dataset, name);
}

} // namespace

core::Result<void> check_fields(const LoadedDataset& dataset,
                                const std::vector<std::string>& fields,
                                std::string_view parameter) {
    const auto there = vertex_field_names(
        dataset.scalars ? dataset.scalars->names() : std::vector<std::string>(), dataset.info);
    for (const std::string& name : fields)
        if (std::ranges::find(there, name) == there.end())
            return tl::unexpected(no_such_field(parameter, name, there, dataset.info.fields));
    return {};
}

core::Result<protocol::MeshScalars> surface_scalars(const LoadedDataset& dataset,
                                                    const core::QuadComplex& mesh,
                                                    const std::vector<double>& times,
                                                    const std::vector<std::string>& fields,
                                                    const std::stop_token& stop) {
    if (auto known = check_fields(dataset, fields); !known)
        return tl::unexpected(known.error());
    protocol::MeshScalars scalars;
    std::vector<core::GradientField> derived;
    std::vector<std::string> derived_names;
    for (const std::string& name : fields) {
        if (written_anyhow(dataset, name))
            continue;
        if (component_here(dataset, name)) {
            scalars[name] = *core::vertex_component(mesh, name);
            continue;
        }
        if (const auto field = derived_here(dataset, name)) {
            derived.push_back(*field);
            derived_names.push_back(name);
            continue;
        }
        auto values = core::sample_scalar(*dataset.flow, *dataset.scalars,
                                          *dataset.scalars->find(name), mesh.position, times, stop);
        if (!values)
            return tl::unexpected(values.error());
        scalars[name] = std::move(*values);
    }
    if (derived.empty())
        return scalars;
    auto values = core::sample_gradient_fields(derived, *dataset.flow, mesh.position, times, stop);
    if (!values)
        return tl::unexpected(values.error());
    for (std::size_t k = 0; k < derived.size(); ++k)
        scalars[derived_names[k]] = std::move((*values)[k]);
    return scalars;
}

} // namespace wakesurf::server
