#include "importer/fields/field_choice.hpp"

#include "importer/base/text.hpp"
#include "importer/fields/physical_units.hpp"
#include "importer/fields/velocity_choice.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <set>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

constexpr std::array<std::string_view, 4> fluid_names{"mask", "fluid", "fluid_mask",
                                                      "vtkvalidpointmask"};
constexpr std::array<std::string_view, 3> solid_names{"solid", "solid_mask", "obstacle"};

template <class Names>
bool called_one_of(const FieldInfo& field, const Names& names) {
    return std::find(names.begin(), names.end(), lower_case(field.name)) != names.end();
}

bool is_mask(const FieldInfo& field, const FieldWish& wish) {
    return field.components == 1 && wish.mask_use != MaskUse::Scalar &&
           std::find(wish.no_masks.begin(), wish.no_masks.end(), field.name) ==
               wish.no_masks.end() &&
           (called_one_of(field, fluid_names) || called_one_of(field, solid_names));
}

bool same_array(const FieldInfo& a, const FieldInfo& b) {
    return a.name == b.name && a.source == b.source;
}

bool contains(const std::vector<FieldInfo>& fields, const FieldInfo& field) {
    return std::any_of(fields.begin(), fields.end(),
                       [&](const FieldInfo& other) { return same_array(field, other); });
}

core::Result<void> check_wanted(const std::vector<FieldInfo>& fields,
                                const std::vector<std::string>& wanted) {
    for (const auto& name : wanted) {
        const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldInfo& f) {
            return told_apart(f, fields) == name;
        });
        if (found == fields.end())
            return core::fail(Error::Code::NotFound,
                              "there is no field " + name + "; there is " + listed(fields));
        if (found->components != 1 && found->components != 3)
            return core::fail(Error::Code::Unsupported,
                              "field " + name + " has " + std::to_string(found->components) +
                                  " components: it is neither a velocity nor a scalar",
                              "leave it out of --fields");
    }
    return {};
}

// Refuses a vertical velocity in Pa s-1 beside two in m s-1: they are no vector.
core::Result<void> check_units(const std::vector<FieldInfo>& parts) {
    std::string units;
    bool same = true;
    for (const auto& part : parts) {
        units += (units.empty() ? "" : ", ") + part.name + " in " +
                 (part.unit.empty() ? "no unit" : part.unit);
        same = same && may_be_same(part.unit, parts.front().unit);
    }
    if (same)
        return {};
    return core::fail(Error::Code::Unsupported,
                      "the parts of the velocity have different units: " + units,
                      "convert them to one unit, or choose others with --velocity");
}

// Returns a part of file names: lower case, digits and single dashes.
std::string slug(const std::string& name) {
    constexpr std::size_t longest = 56;
    std::string out;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!out.empty() && out.back() != '-')
            out += '-';
    out = out.substr(0, longest);
    while (!out.empty() && out.back() == '-')
        out.pop_back();
    return out.empty() ? "scalar" : out;
}

std::string stored_name(const FieldInfo& field, const std::vector<FieldInfo>& all) {
    return field.components == 1 ? told_apart(field, all) : field.name + " magnitude";
}

// Returns the scalars of points before those of cells.
std::vector<FieldInfo> possible_scalars(const std::vector<FieldInfo>& fields,
                                        const FieldParts& velocity,
                                        const FieldWish& wish) {
    std::vector<FieldInfo> out;
    for (const auto source : {FieldInfo::Source::Point, FieldInfo::Source::Cell})
        for (const auto& field : fields) {
            const bool component = velocity.arrays.size() > 1 && contains(velocity.arrays, field);
            const bool vector = field.components == 3 && !contains(velocity.arrays, field) &&
                                field.name != velocity.arrays.front().name;
            if (field.source == source && (field.components == 1 || vector) &&
                !is_mask(field, wish) && !component)
                out.push_back(field);
        }
    return out;
}

// Keeps the first of fields with one name; a scalar of the source goes before a magnitude.
std::vector<FieldInfo> each_name_once(const std::vector<FieldInfo>& fields,
                                      const std::vector<FieldInfo>& all) {
    std::vector<FieldInfo> out;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        bool stays = true;
        for (std::size_t j = 0; j < fields.size(); ++j)
            if (j != i && stored_name(fields[j], all) == stored_name(fields[i], all))
                stays = stays && (fields[i].components < fields[j].components ||
                                  (fields[i].components == fields[j].components && i < j));
        if (stays)
            out.push_back(fields[i]);
    }
    return out;
}

void choose_scalars(const std::vector<FieldInfo>& fields,
                    const FieldWish& wish,
                    FieldChoice& choice) {
    const auto& wanted = wish.kept;
    const auto found = possible_scalars(fields, choice.velocity, wish);
    std::vector<FieldInfo> named;
    std::copy_if(found.begin(), found.end(), std::back_inserter(named),
                 [&](const FieldInfo& field) {
                     const std::string name = told_apart(field, fields);
                     return std::find(wanted.begin(), wanted.end(), name) != wanted.end() &&
                            !contains(choice.velocity.divisor, field);
                 });
    std::set<std::string> taken{std::string(store::velocity_stem)};
    for (const auto& field : each_name_once(named.empty() ? found : named, fields)) {
        const std::string name = stored_name(field, fields);
        const std::string first = slug(name);
        std::string stem = first;
        for (int i = 2; !taken.insert(stem).second; ++i)
            stem = first + "-" + std::to_string(i);
        choice.scalars.push_back({field, {name, stem}});
    }
}

void note_what_is_left_out(const std::vector<FieldInfo>& fields, FieldChoice& choice) {
    std::string names;
    std::string magnitudes;
    for (const ChosenScalar& each : choice.scalars)
        if (each.is_magnitude())
            magnitudes += (magnitudes.empty() ? "" : ", ") + each.field.name;
    const auto stored = [&](const FieldInfo& field) {
        return std::any_of(choice.scalars.begin(), choice.scalars.end(),
                           [&](const ChosenScalar& each) { return same_array(each.field, field); });
    };
    for (const auto& field : fields)
        if (field.components > 1 && !contains(choice.velocity.arrays, field) && !stored(field)) {
            names += (names.empty() ? "" : ", ") + field.name;
            const auto twin = [&](const FieldInfo& other) {
                return other.name == field.name && other.source != field.source;
            };
            if (std::any_of(fields.begin(), fields.end(), twin))
                names +=
                    field.source == FieldInfo::Source::Cell ? " of the cells" : " of the points";
        }
    if (!magnitudes.empty())
        choice.note = "stored as magnitudes, since a store holds one vector: " + magnitudes;
    if (!names.empty())
        choice.note += (choice.note.empty() ? "" : "; ") +
                       ("left out, since a store holds one vector: " + names);
}

} // namespace

std::string told_apart(const FieldInfo& field, const std::vector<FieldInfo>& all) {
    const bool twin = field.source == FieldInfo::Source::Cell &&
                      std::any_of(all.begin(), all.end(), [&](const FieldInfo& other) {
                          return other.name == field.name &&
                                 other.source == FieldInfo::Source::Point &&
                                 other.components == field.components;
                      });
    if (!twin)
        return field.name;
    const auto taken = [&](const std::string& name) {
        return std::any_of(all.begin(), all.end(),
                           [&](const FieldInfo& other) { return other.name == name; });
    };
    std::string name = field.name + " (cells)";
    for (int i = 2; taken(name); ++i)
        name = field.name + " (cells " + std::to_string(i) + ")";
    return name;
}

FieldInfo ChosenScalar::info() const {
    return {stored.name, 1, field.source, field.range, field.unit};
}

std::vector<FieldInfo> FieldChoice::arrays() const {
    std::vector<FieldInfo> out;
    const auto add = [&](const FieldInfo& field) {
        if (!contains(out, field))
            out.push_back(field);
    };
    std::for_each(velocity.arrays.begin(), velocity.arrays.end(), add);
    std::for_each(velocity.divisor.begin(), velocity.divisor.end(), add);
    for (const auto& scalar : scalars)
        add(scalar.field);
    if (mask)
        add(*mask);
    return out;
}

core::Result<FieldChoice> choose_fields(const std::vector<FieldInfo>& fields,
                                        const FieldWish& wish) {
    if (auto known = check_wanted(fields, wish.kept); !known)
        return tl::unexpected(known.error());
    auto velocity = choose_velocity(fields, wish.velocity, wish.stated);
    if (!velocity)
        return tl::unexpected(velocity.error());
    if (auto same = check_units(velocity->parts.arrays); !same)
        return tl::unexpected(same.error());
    FieldChoice choice;
    choice.velocity = std::move(velocity->parts);
    choice.velocity_name = std::move(velocity->name);
    choice.why = std::move(velocity->why);
    for (const auto source : {FieldInfo::Source::Cell, FieldInfo::Source::Point})
        for (const auto& field : fields)
            if (is_mask(field, wish) && field.source == source)
                choice.mask = field;
    choice.mask_use = wish.mask_use;
    if (choice.mask && choice.mask_use == MaskUse::Gap)
        add_note(choice.note, "where " + choice.mask->name +
                                  " marks a body at a time there is no fluid then: --mask gap");
    choice.mask_marks_solid = choice.mask && called_one_of(*choice.mask, solid_names);
    choose_scalars(fields, wish, choice);
    note_what_is_left_out(fields, choice);
    add_note(choice.note, velocity->doubt);
    for (const auto& name : wish.no_masks)
        add_note(choice.note,
                 name +
                     " is a scalar, not a mask as its name suggests: it is not 0 or 1 everywhere");
    return choice;
}

} // namespace wakesurf::importer
