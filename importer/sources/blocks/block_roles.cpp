#include "importer/sources/blocks/block_roles.hpp"

#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"

#include <algorithm>

namespace wakesurf::importer {

using core::FieldInfo;

namespace {

using Fields = std::vector<FieldInfo>;

bool has_names_of(const Fields& here, const Fields& wanted) {
    return std::all_of(wanted.begin(), wanted.end(), [&](const FieldInfo& field) {
        return std::any_of(here.begin(), here.end(),
                           [&](const FieldInfo& other) { return other.name == field.name; });
    });
}

bool has_vector(const Fields& here) {
    return std::any_of(here.begin(), here.end(),
                       [](const FieldInfo& field) { return field.components == 3; });
}

std::vector<bool>
find_fluid(const std::vector<Fields>& of_blocks, const Fields& all, const std::string& wish) {
    std::vector<bool> out;
    const auto velocity = choose_velocity(all, wish);
    for (const auto& here : of_blocks)
        out.push_back(velocity ? has_names_of(here, velocity->parts.arrays) : has_vector(here));
    if (std::find(out.begin(), out.end(), true) == out.end())
        out.assign(of_blocks.size(), true);
    return out;
}

} // namespace

BlockRoles block_roles(const Blocks& blocks, const std::string& velocity) {
    Fields all;
    std::vector<Fields> of_blocks(blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        add_fields(*blocks[i], of_blocks[i]);
        add_fields(*blocks[i], all);
    }
    BlockRoles out{find_fluid(of_blocks, all, velocity), {}, {}};
    Blocks fluid;
    std::vector<std::string> left_out;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (out.fluid[i])
            fluid.push_back(blocks[i]);
    out.fields = common_fields(fluid);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        for (const FieldInfo& field : of_blocks[i])
            if (out.fluid[i] && !has_names_of(out.fields, {field}) &&
                std::find(left_out.begin(), left_out.end(), field.name) == left_out.end())
                left_out.push_back(field.name);
    out.note = only_on_some_parts(left_out);
    return out;
}

std::string only_on_some_parts(const std::vector<std::string>& names) {
    std::string out;
    for (const auto& name : names)
        out += (out.empty() ? "left out, as only some parts have them: " : ", ") + name;
    return out;
}

} // namespace wakesurf::importer
