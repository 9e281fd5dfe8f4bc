#include "server/base/field_names.hpp"

#include "core/field/velocity_gradient.hpp"
#include "core/surface/builder/interval_errors.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "protocol/api/base/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace wakesurf::server {

namespace {

void add(std::vector<std::string>& names, std::span<const std::string_view> more) {
    for (const std::string_view each : more)
        if (std::ranges::find(names, each) == names.end())
            names.emplace_back(each);
}

} // namespace

std::vector<std::string> node_field_names(std::vector<std::string> stored,
                                          const std::string& velocity) {
    add(stored, std::array<std::string_view, 1>{velocity});
    add(stored, core::gradient_field_names);
    add(stored, core::velocity_component_names);
    return stored;
}

bool has_interval_errors(const core::DatasetInfo& info) {
    return info.grid != core::GridKind::Analytic && !info.steady &&
           info.times.size() >= core::least_stored_times;
}

std::vector<std::string> vertex_field_names(std::vector<std::string> stored,
                                            const core::DatasetInfo& info) {
    const bool its_own = std::ranges::find(stored, core::interval_error_name) != stored.end();
    add(stored, std::array<std::string_view, 1>{info.velocity});
    add(stored, core::derived_vertex_names);
    if (!its_own && !has_interval_errors(info))
        std::erase(stored, core::interval_error_name);
    add(stored, core::gradient_field_names);
    add(stored, core::velocity_component_names);
    add(stored, core::normal_component_names);
    return stored;
}

bool is_taken(std::string_view name,
              std::string_view velocity,
              std::span<const core::FieldInfo> fields) {
    constexpr std::array<std::string_view, 6> ours{"speed", "s", "t", "x", "y", "z"};
    const auto& components = core::velocity_component_names;
    return std::ranges::find(fields, name, &core::FieldInfo::name) != fields.end() ||
           std::ranges::find(ours, name) != ours.end() || name == velocity ||
           std::ranges::find(core::derived_vertex_names, name) !=
               core::derived_vertex_names.end() ||
           core::find_gradient_field(name) ||
           std::ranges::find(components, name) != components.end();
}

std::string field_hint(std::string_view name, std::span<const std::string> there) {
    const std::string meant = protocol::nearest_name(name, there);
    return meant.empty()
               ? fmt::format("there is {}", fmt::join(there, ", "))
               : fmt::format("did you mean {}? There is {}", meant, fmt::join(there, ", "));
}

core::Error no_such_field(std::string_view parameter,
                          const std::string& name,
                          std::span<const std::string> there,
                          std::span<const core::FieldInfo> of_files) {
    const auto found = std::ranges::find(of_files, name, &core::FieldInfo::name);
    const std::string problem =
        found == of_files.end() ? "a field the dataset does not have: "
        : found->components > 1
            ? "a vector field that was not stored as such when the dataset was imported, since a "
              "store holds one vector: "
            : "a field that was not stored when the dataset was imported: ";
    return {core::Error::Code::NotFound,
            fmt::format("`{}` names {}{}", parameter, problem, name.substr(0, 64)),
            field_hint(name, there)};
}

} // namespace wakesurf::server
