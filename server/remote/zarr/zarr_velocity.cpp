#include "server/remote/zarr/zarr_velocity.hpp"

#include "store/velocity_names.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::FieldInfo;
using core::Result;

namespace {

/// Returns the field's name; the root itself, if it is an array, has none.
std::string name_of(const ZarrField& field) {
    return field.array->name.empty() ? "velocity" : field.array->name;
}

FieldInfo scalar_named(const std::string& name) {
    return {name, 1, FieldInfo::Source::Point, {0.0, 0.0}, {}};
}

std::string listed(const ZarrGroup& group) {
    std::string out;
    for (const ZarrArray& array : group.arrays)
        out += (out.empty() ? "there is " : ", ") +
               (array.name.empty() ? "one array with " + std::to_string(array.shape.size()) +
                                         " axes, which is the root"
                                   : array.name);
    for (const auto& [name, error] : group.refused)
        out += (out.empty() ? "there is " : ", ") + name + " (" + error.message + ")";
    return out.empty() ? "it has no arrays" : out;
}

/// Returns the error of an unreadable array that would be the velocity, or a part of it: it says more than
/// that there is none.
std::optional<Error> refused_velocity(const ZarrGroup& group, std::vector<FieldInfo> scalars) {
    for (const auto& [name, error] : group.refused)
        scalars.push_back(scalar_named(name));
    const auto triples = store::velocity_components(scalars, FieldInfo::Source::Point);
    for (const auto& [name, error] : group.refused) {
        const auto is_it = [&name = name](const FieldInfo& part) { return part.name == name; };
        if (store::meaning_of_vector(name) == store::VectorName::Velocity ||
            (!triples.empty() && std::ranges::any_of(triples[0], is_it)))
            return Error{error.code, name + ": " + error.message, error.hint};
    }
    return std::nullopt;
}

} // namespace

std::vector<ZarrField> zarr_fields(const ZarrGroup& group) {
    std::vector<ZarrField> out;
    for (const ZarrArray& array : group.arrays)
        if (const auto axes = zarr_axes(array))
            out.push_back({&array, *axes});
    return out;
}

Result<ZarrVelocity> choose_zarr_velocity(const ZarrGroup& group,
                                          const std::vector<ZarrField>& fields) {
    std::vector<ZarrField> vectors;
    std::vector<ZarrField> named;
    std::vector<FieldInfo> scalars;
    for (const ZarrField& field : fields) {
        const auto meaning = store::meaning_of_vector(name_of(field));
        if (!field.axes.component)
            scalars.push_back(scalar_named(field.array->name));
        else if (meaning != store::VectorName::Other && meaning != store::VectorName::Momentum)
            vectors.push_back(field);
        if (field.axes.component && meaning == store::VectorName::Velocity)
            named.push_back(field);
    }
    const auto triples = store::velocity_components(scalars, FieldInfo::Source::Point);
    if (named.empty() && triples.empty())
        if (auto refused = refused_velocity(group, scalars))
            return tl::unexpected(std::move(*refused));
    if (named.empty() && triples.empty() && vectors.size() == 1)
        named = vectors;
    if (named.size() > 1 || (named.empty() && (triples.size() > 1 || vectors.size() > 1)))
        return fail(Error::Code::InvalidArgument, "it is not clear which array is the velocity",
                    listed(group) + "; put the velocity into a group of its own");
    if (named.size() == 1)
        return ZarrVelocity{named, name_of(named[0]),
                            vectors.size() == 1 ? "the only array with three components"
                                                : "the only vector with the name of a velocity"};
    if (triples.empty())
        return fail(
            Error::Code::NotFound,
            "the Zarr has no velocity: neither arrays u, v and w of the axes (time, z, y, x), "
            "nor one with an axis of three components",
            listed(group));
    ZarrVelocity out{{}, {}, "three arrays with the names of its components"};
    for (const FieldInfo& part : triples[0]) {
        const auto found =
            std::ranges::find(fields, part.name, [](const ZarrField& f) { return f.array->name; });
        out.parts.push_back(*found);
        out.name += (out.name.empty() ? "" : ", ") + part.name;
        if (found->array->shape != out.parts[0].array->shape ||
            found->array->dimensions != out.parts[0].array->dimensions)
            return fail(Error::Code::Unsupported,
                        out.parts[0].array->name + " and " + part.name +
                            " are on different nodes, as of a staggered grid",
                        "interpolate the velocity to common nodes first");
    }
    return out;
}

} // namespace wakesurf::server
