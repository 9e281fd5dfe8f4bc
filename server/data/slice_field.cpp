#include "server/data/slice_field.hpp"

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

bool differ(const std::string& a, const std::string& b) {
    return !a.empty() && !b.empty() && a != b;
}

bool share_a_place(const core::Box& a, const core::Box& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.lo[axis] > b.hi[axis] || b.lo[axis] > a.hi[axis])
            return false;
    return true;
}

} // namespace

core::Result<core::SampledField> slice_field(const std::string& name,
                                             const core::DatasetInfo& info,
                                             const store::StoreScalars* scalars,
                                             const core::Vec3& normal,
                                             std::string_view parameter) {
    const bool taken =
        name == info.velocity || (scalars != nullptr && scalars->find(name).has_value());
    if (name == velocity_normal_name && !taken)
        return core::VelocityAlong{glm::normalize(normal)};
    return find_node_field(name, info, scalars, parameter).map([&](const NodeField& field) {
        return sampled(field, scalars);
    });
}

core::Result<core::SampledField> subtracted_field(const std::string& name,
                                                  const core::DatasetInfo& from,
                                                  const core::DatasetInfo& other,
                                                  const store::StoreScalars* scalars_of_other,
                                                  const core::Vec3& normal) {
    const std::string there = name == from.velocity ? other.velocity : name;
    auto field = slice_field(there, other, scalars_of_other, normal);
    if (!field) {
        field.error().message = "in " + other.name + ", " + field.error().message;
        return field;
    }
    const auto other_units = [&](const std::string& what, const std::string& a,
                                 const std::string& b) {
        return fail(Error::Code::InvalidArgument,
                    what + " in " + a + " in " + from.name + " and in " + b + " in " + other.name,
                    "only values in the same unit can be subtracted: convert one of the datasets");
    };
    const bool derived = core::unit_of(from, name).empty() && core::unit_of(other, there).empty();
    if (const auto a = core::unit_of(from, derived ? from.velocity : name),
        b = core::unit_of(other, derived ? other.velocity : there);
        differ(a, b))
        return other_units((derived ? "the velocity" : name) + " is", a, b);
    if (differ(from.time_unit, other.time_unit))
        return other_units("times are", from.time_unit, other.time_unit);
    if (differ(from.length_unit, other.length_unit))
        return other_units("lengths are", from.length_unit, other.length_unit);
    if (!share_a_place(from.bounds, other.bounds))
        return fail(Error::Code::OutOfDomain,
                    from.name + " and " + other.name + " have no place in common",
                    "only values at the same places can be subtracted");
    return field;
}

} // namespace wakesurf::server
