#include "server/data/surface_scalars.hpp"

#include "core/field/sample_scalar.hpp"
#include "core/field/velocity_gradient.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "server/base/field_names.hpp"

#include <algorithm>
#include <limits>

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

/// What every export has, as a scalar.
std::vector<float> own_values(const core::QuadComplex& mesh, const std::string& name) {
    std::vector<float> out(mesh.vertices(), std::numeric_limits<float>::quiet_NaN());
    const auto copy = [&](const auto& given) {
        std::copy(given.begin(), given.end(), out.begin());
    };
    if (name == core::deformation_name) {
        copy(mesh.deformation);
    } else if (name == core::approximated_name) {
        copy(mesh.approximated);
    } else if (name == core::error_name) {
        copy(mesh.error);
    } else if (name == core::interval_error_name) {
        copy(mesh.interval_error);
    } else {
        for (std::size_t v = 0; v < out.size(); ++v)
            out[v] = static_cast<float>(mesh.speed(static_cast<core::VertexId>(v)));
    }
    return out;
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

core::Result<std::vector<core::AveragedField>>
averaged_fields(const LoadedDataset& dataset,
                const std::vector<std::string>& fields,
                std::string_view parameter) {
    if (auto known = check_fields(dataset, fields, parameter); !known)
        return tl::unexpected(known.error());
    std::vector<core::AveragedField> out;
    const auto unit_of = [&](const std::string& name) {
        if (component_here(dataset, name) && !core::is_normal_component(name))
            return core::unit_of(dataset.info, dataset.info.velocity);
        const bool length = name == core::error_name || name == core::interval_error_name;
        return length && !stored(dataset, name) ? dataset.info.length_unit
                                                : core::unit_of(dataset.info, name);
    };
    for (const std::string& name : fields) {
        if (std::ranges::find(out, name, &core::AveragedField::name) != out.end())
            continue;
        out.push_back(
            {name, unit_of(name),
             [&dataset, name](const core::QuadComplex& mesh, const std::vector<double>& times,
                              const std::stop_token& stop) -> core::Result<std::vector<float>> {
                 if (written_anyhow(dataset, name))
                     return own_values(mesh, name);
                 return surface_scalars(dataset, mesh, times, {name}, stop)
                     .map([&](protocol::MeshScalars scalars) { return std::move(scalars[name]); });
             }});
    }
    return out;
}

} // namespace wakesurf::server
