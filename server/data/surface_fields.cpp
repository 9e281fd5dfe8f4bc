#include "server/data/surface_fields.hpp"

#include "core/field/sample_scalar.hpp"
#include "core/field/velocity_gradient.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "server/base/field_names.hpp"
#include "server/base/limits.hpp"
#include "server/data/datasets.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace wakesurf::server {

namespace {

static_assert(protocol::surface_attributes.size() + limits::fields <= protocol::max_attributes);

/// Returns nothing where the name is none of the dataset's and of ours.
std::optional<SurfaceField> lookup(const OpenDataset& dataset, const std::string& name) {
    using Source = SurfaceField::Source;
    if (dataset.scalars != nullptr && dataset.scalars->find(name))
        return SurfaceField{name, Source::Scalar};
    if (name == dataset.info.velocity)
        return SurfaceField{name, Source::Speed};
    if (core::is_vertex_component(name))
        return SurfaceField{name, core::is_normal_component(name) ? Source::NormalComponent
                                                                  : Source::VelocityComponent};
    if (name == core::deformation_name)
        return SurfaceField{name, Source::Deformation};
    if (name == core::approximated_name)
        return SurfaceField{name, Source::Approximated};
    if (name == core::error_name)
        return SurfaceField{name, Source::Error};
    if (name == core::interval_error_name && has_interval_errors(dataset.info))
        return SurfaceField{name, Source::IntervalError};
    if (name == core::twin_distance_name)
        return SurfaceField{name, Source::TwinDistance};
    if (name == core::twin_lag_name)
        return SurfaceField{name, Source::TwinLag};
    if (core::find_gradient_field(name))
        return SurfaceField{name, Source::Gradient};
    return std::nullopt;
}

/// Returns all `missing` where the mesh has none.
template <class T>
std::vector<float>
values_of(const std::vector<T>& given, const core::QuadComplex& mesh, float missing = 0.0F) {
    std::vector<float> out(given.begin(), given.end());
    out.resize(mesh.vertices(), missing);
    return out;
}

std::vector<float> speeds_of(const core::QuadComplex& mesh) {
    std::vector<float> out(mesh.vertices());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = static_cast<float>(mesh.speed(static_cast<core::VertexId>(i)));
    return out;
}

} // namespace

std::vector<std::string> field_names(const OpenDataset& dataset) {
    auto names = vertex_field_names(
        dataset.scalars ? dataset.scalars->names() : std::vector<std::string>(), dataset.info);
    for (const std::string_view name : {core::twin_distance_name, core::twin_lag_name})
        if (std::ranges::find(names, name) == names.end())
            names.emplace_back(name);
    return names;
}

core::Result<SurfaceField> find_field(const OpenDataset& dataset, const std::string& name) {
    if (auto found = lookup(dataset, name))
        return *found;
    auto error = no_such_field("fields", name, field_names(dataset), dataset.info.fields);
    error.code = core::Error::Code::InvalidArgument;
    return tl::unexpected(std::move(error));
}

core::Result<std::vector<std::string>> fields_once(const OpenDataset& dataset,
                                                   const std::vector<std::string>& names) {
    std::vector<std::string> out;
    for (const std::string& name : names) {
        if (auto known = find_field(dataset, name); !known)
            return tl::unexpected(known.error());
        if (std::ranges::find(out, name) == out.end())
            out.push_back(name);
    }
    return out;
}

std::vector<SurfaceField> fields_there(const OpenDataset& dataset,
                                       const std::vector<std::string>& names) {
    std::vector<SurfaceField> out;
    for (const std::string& name : names)
        if (auto found = lookup(dataset, name);
            found && out.size() < limits::fields && std::ranges::find(out, *found) == out.end())
            out.push_back(std::move(*found));
    return out;
}

bool asks_for(std::span<const SurfaceField> fields, SurfaceField::Source source) {
    return std::ranges::any_of(
        fields, [source](const SurfaceField& each) { return each.source == source; });
}

core::Result<protocol::MeshFields> sample_fields(std::span<const SurfaceField> fields,
                                                 const core::Flow& flow,
                                                 const store::StoreScalars* scalars,
                                                 const core::QuadComplex& mesh,
                                                 const std::function<std::vector<double>()>& times,
                                                 const std::stop_token& stop) {
    using Source = SurfaceField::Source;
    protocol::MeshFields out;
    std::vector<double> when;
    if (asks_for(fields, Source::Scalar) || asks_for(fields, Source::Gradient))
        when = times();
    // Together: each of them takes seven samples a vertex.
    std::vector<core::GradientField> derived;
    for (const SurfaceField& field : fields)
        if (field.source == Source::Gradient)
            derived.push_back(*core::find_gradient_field(field.name));
    auto gradients = core::sample_gradient_fields(derived, flow, mesh.position, when, stop);
    if (!gradients)
        return tl::unexpected(gradients.error());
    std::size_t next = 0;
    for (const SurfaceField& field : fields) {
        if (field.source == Source::Speed) {
            out.push_back(speeds_of(mesh));
        } else if (field.source == Source::VelocityComponent ||
                   field.source == Source::NormalComponent) {
            out.push_back(*core::vertex_component(mesh, field.name));
        } else if (field.source == Source::Deformation) {
            out.push_back(values_of(mesh.deformation, mesh));
        } else if (field.source == Source::Approximated) {
            out.push_back(values_of(mesh.approximated, mesh));
        } else if (field.source == Source::Error) {
            out.push_back(values_of(mesh.error, mesh, std::numeric_limits<float>::quiet_NaN()));
        } else if (field.source == Source::IntervalError) {
            out.push_back(
                values_of(mesh.interval_error, mesh, std::numeric_limits<float>::quiet_NaN()));
        } else if (field.source == Source::TwinDistance || field.source == Source::TwinLag) {
            out.push_back(values_of<float>({}, mesh, std::numeric_limits<float>::quiet_NaN()));
        } else if (field.source == Source::Gradient) {
            out.push_back(std::move((*gradients)[next++]));
        } else {
            const auto scalar = scalars->find(field.name);
            if (!scalar) {
                out.push_back(values_of<float>({}, mesh, std::numeric_limits<float>::quiet_NaN()));
                continue;
            }
            auto values = core::sample_scalar(flow, *scalars, *scalar, mesh.position, when, stop);
            if (!values)
                return tl::unexpected(values.error());
            out.push_back(std::move(*values));
        }
    }
    return out;
}

} // namespace wakesurf::server
