#include "server/import/field_choice.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace wakesurf::server {

using core::Error;
using core::FieldInfo;

namespace {

constexpr std::array<std::string_view, 3> velocity_names{"u", "velocity", "vel"};
constexpr std::array<std::string_view, 4> fluid_names{"mask", "fluid", "fluid_mask",
                                                      "vtkvalidpointmask"};
constexpr std::array<std::string_view, 3> solid_names{"solid", "solid_mask", "obstacle"};

template <class Names>
bool called_one_of(const FieldInfo& field, const Names& names) {
    std::string lower = field.name;
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(names.begin(), names.end(), lower) != names.end();
}

template <class Condition>
std::vector<FieldInfo> pick(const std::vector<FieldInfo>& fields, Condition condition) {
    std::vector<FieldInfo> out;
    std::copy_if(fields.begin(), fields.end(), std::back_inserter(out), condition);
    return out;
}

std::string listed(const std::vector<FieldInfo>& fields) {
    std::string out;
    for (const auto& field : fields)
        out += (out.empty() ? "" : ", ") + field.name + " (" + std::to_string(field.components) +
               (field.components == 1 ? " component, " : " components, ") +
               (field.source == FieldInfo::Source::Cell ? "cell)" : "point)");
    return out.empty() ? "no arrays at all" : out;
}

bool is_mask(const FieldInfo& field) {
    return field.components == 1 &&
           (called_one_of(field, fluid_names) || called_one_of(field, solid_names));
}

core::Result<void> check_wanted(const std::vector<FieldInfo>& fields,
                                const std::vector<std::string>& wanted) {
    for (const auto& name : wanted) {
        const auto found = pick(fields, [&](const FieldInfo& f) { return f.name == name; });
        if (found.empty())
            return core::fail(Error::Code::NotFound,
                              "there is no field " + name + "; there is " + listed(fields));
        if (std::none_of(found.begin(), found.end(),
                         [](const FieldInfo& f) { return f.components == 3 || is_mask(f); }))
            return core::fail(Error::Code::Unsupported,
                              "field " + name + " is neither a velocity (3 components) nor a mask",
                              "leave it out of --fields; a store holds the velocity and the mask");
    }
    return {};
}

core::Result<FieldInfo> the_only(const std::vector<FieldInfo>& candidates) {
    if (candidates.size() > 1)
        return core::fail(Error::Code::InvalidArgument,
                          "several fields could be the velocity: " + listed(candidates),
                          "choose one with --fields NAME");
    return candidates.front();
}

core::Result<FieldChoice> choose_velocity(const std::vector<FieldInfo>& vectors) {
    FieldChoice choice;
    for (const auto source : {FieldInfo::Source::Point, FieldInfo::Source::Cell}) {
        const auto here = pick(vectors, [&](const FieldInfo& f) { return f.source == source; });
        const auto named =
            pick(here, [](const FieldInfo& f) { return called_one_of(f, velocity_names); });
        if (here.empty())
            continue;
        const auto chosen = the_only(named.empty() ? here : named);
        if (!chosen)
            return tl::unexpected(chosen.error());
        choice.velocity = *chosen;
        choice.why = named.empty() ? "the only 3-component field"
                                   : "the only 3-component field with the name of a velocity";
        if (source == FieldInfo::Source::Cell)
            choice.why += "; its cell values are averaged to the points";
        return choice;
    }
    return core::fail(Error::Code::NotFound, "no vector field");
}

} // namespace

core::Result<FieldChoice> choose_fields(const std::vector<FieldInfo>& fields,
                                        const std::vector<std::string>& wanted) {
    if (auto known = check_wanted(fields, wanted); !known)
        return tl::unexpected(known.error());
    const auto is_wanted = [&](const FieldInfo& f) {
        return wanted.empty() || std::find(wanted.begin(), wanted.end(), f.name) != wanted.end();
    };
    auto vectors = pick(fields, [&](const FieldInfo& f) { return f.components == 3; });
    if (vectors.empty())
        return core::fail(Error::Code::NotFound,
                          "there is no vector field; there is " + listed(fields),
                          "write the velocity as one array of 3 components");
    const auto asked = pick(vectors, is_wanted);
    auto choice = choose_velocity(asked.empty() ? vectors : asked);
    if (!choice)
        return choice;
    if (!wanted.empty() && !asked.empty())
        choice->why = "chosen by --fields" +
                      choice->why.substr(std::min(choice->why.find(';'), choice->why.size()));
    for (const auto source : {FieldInfo::Source::Cell, FieldInfo::Source::Point})
        for (const auto& field : fields)
            if (is_mask(field) && field.source == source)
                choice->mask = field;
    choice->mask_marks_solid = choice->mask && called_one_of(*choice->mask, solid_names);
    return choice;
}

} // namespace wakesurf::server
