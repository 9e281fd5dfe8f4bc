#include "importer/fields/velocity_choice.hpp"

#include "store/velocity_names.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;
using store::Components;
using store::is_density;
using store::meaning_of_vector;
using store::momentum_components;
using store::VectorName;
using store::velocity_components;

namespace {

using Fields = std::vector<FieldInfo>;

template <class Condition>
Fields pick(const Fields& fields, const Condition& condition) {
    Fields out;
    std::copy_if(fields.begin(), fields.end(), std::back_inserter(out), condition);
    return out;
}

bool is_vector(const FieldInfo& field, VectorName meaning) {
    return field.components == 3 && meaning_of_vector(field.name) == meaning;
}

constexpr std::array<FieldInfo::Source, 2> field_places{FieldInfo::Source::Point,
                                                        FieldInfo::Source::Cell};

std::string joined(const Fields& fields) {
    std::string out;
    for (const auto& field : fields)
        out += (out.empty() ? "" : ", ") + field.name;
    return out;
}

std::string choose_one(const Fields& fields) {
    const bool vectors = std::any_of(fields.begin(), fields.end(),
                                     [](const FieldInfo& f) { return f.components == 3; });
    return std::string("choose ") + (vectors ? "one with --velocity NAME, or " : "") +
           "three scalars with --velocity U,V,W";
}

VelocityChoice made(Fields parts, Fields divisor, std::string why) {
    if (parts.front().source == FieldInfo::Source::Cell)
        why += "; its cell values are averaged to the points";
    std::string name = joined(parts) + (divisor.empty() ? "" : " / " + divisor.front().name);
    return {{std::move(parts), std::move(divisor), 3}, std::move(name), std::move(why)};
}

using Found = core::Result<std::optional<VelocityChoice>>;

// Chooses by rules if no field was asked for.
class Rules {
  public:
    Rules(const Fields& fields, const std::vector<StatedComponents>& stated)
        : fields_(fields), stated_(stated) {}

    // Returns an empty outer list if the rules find nothing.
    Found run() const {
        using Rule = Found (Rules::*)(FieldInfo::Source) const;
        constexpr std::array<Rule, 7> rules{&Rules::stated,    &Rules::named,    &Rules::components,
                                            &Rules::qualified, &Rules::momentum, &Rules::spoken_of,
                                            &Rules::only};
        for (const Rule rule : rules)
            for (const auto source : field_places) {
                auto found = (this->*rule)(source);
                if (!found || found->has_value())
                    return found;
            }
        return std::nullopt;
    }

  private:
    template <class Condition>
    Found vector(FieldInfo::Source source, const Condition& condition, const char* why) const {
        const Fields here = pick(fields_, [&](const FieldInfo& f) {
            return f.components == 3 && f.source == source && condition(f);
        });
        if (here.size() > 1)
            return core::fail(Error::Code::InvalidArgument,
                              "several fields could be the velocity: " + listed(here),
                              choose_one(fields_));
        if (here.empty())
            return std::nullopt;
        return made(here, {}, why);
    }

    Found called(FieldInfo::Source source, VectorName meaning, const char* why) const {
        const bool alone = std::count_if(fields_.begin(), fields_.end(), [&](const FieldInfo& f) {
                               return f.components == 3 && f.source == source;
                           }) == 1;
        return vector(
            source, [&](const FieldInfo& f) { return is_vector(f, meaning); },
            alone ? "the only 3-component field" : why);
    }

    static Found
    triple(const std::vector<Components>& found, const Fields& divisor, const char* why) {
        if (found.size() > 1) {
            std::string all;
            for (const auto& parts : found)
                all += (all.empty() ? "" : " or ") + joined(parts);
            return core::fail(Error::Code::InvalidArgument,
                              "several fields could be the velocity: " + all,
                              "choose three with --velocity U,V,W");
        }
        if (found.empty())
            return std::nullopt;
        return made(found[0], divisor, why);
    }

    static Found doubted(Found found) {
        if (found && *found)
            (*found)->doubt = (*found)->name + " is taken for the velocity, though its name does "
                                               "not say that it is the fluid's: choose with "
                                               "--velocity if it is another";
        return found;
    }

    // Components by their names that are none of the stated could be meant as well.
    Found stated(FieldInfo::Source source) const {
        std::vector<Components> found;
        for (const auto& names : stated_) {
            Components parts;
            for (const auto& name : names)
                for (const auto& field : fields_)
                    if (field.name == name && field.source == source && field.components == 1)
                        parts.push_back(field);
            if (parts.size() == 3)
                found.push_back(std::move(parts));
        }
        if (found.size() == 1)
            for (const auto& other : velocity_components(fields_, source))
                if (std::ranges::none_of(other, [&](const FieldInfo& field) {
                        return std::ranges::find(found[0], field.name, &FieldInfo::name) !=
                               found[0].end();
                    })) {
                    found.push_back(other);
                    break;
                }
        return triple(found, {}, "the file states that they are its components");
    }

    Found named(FieldInfo::Source source) const {
        return called(source, VectorName::Velocity,
                      "the only 3-component field with the name of a velocity");
    }

    Found components(FieldInfo::Source source) const {
        return triple(velocity_components(fields_, source), {},
                      "three fields with the names of its components");
    }

    Found qualified(FieldInfo::Source source) const {
        return called(source, VectorName::Qualified,
                      "the only 3-component field whose name suggests the fluid's velocity");
    }

    Found momentum(FieldInfo::Source source) const {
        const Fields vectors = pick(fields_, [&](const FieldInfo& f) {
            return f.source == source && is_vector(f, VectorName::Momentum);
        });
        const Fields density =
            pick(fields_, [&](const FieldInfo& f) { return f.source == source && is_density(f); });
        if (density.size() != 1 || vectors.size() > 1)
            return std::nullopt;
        const char* const why = "there is no fluid velocity, so the momentum is divided by "
                                "the density";
        if (vectors.size() == 1)
            return made(vectors, density, why);
        return triple(momentum_components(fields_, source), density, why);
    }

    Found spoken_of(FieldInfo::Source source) const {
        return doubted(called(source, VectorName::Unclear,
                              "the only 3-component field whose name suggests a velocity"));
    }

    Found only(FieldInfo::Source source) const {
        const auto meaning = [](const FieldInfo& f) { return meaning_of_vector(f.name); };
        return doubted(vector(
            source,
            [&](const FieldInfo& f) {
                return meaning(f) != VectorName::Other && meaning(f) != VectorName::Momentum;
            },
            "the only 3-component field whose name does not say that it is something else"));
    }

    const Fields& fields_;
    const std::vector<StatedComponents>& stated_;
};

std::string trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    return std::string(text);
}

// Chooses the field that was asked for by name.
class Wish {
  public:
    Wish(const Fields& fields, const std::string& text) : fields_(fields), names_{text} {
        if (has(text))
            return;
        names_.clear();
        for (std::string_view rest = text;;) {
            const auto comma = rest.find(',');
            names_.push_back(trimmed(rest.substr(0, comma)));
            if (comma == std::string_view::npos)
                return;
            rest.remove_prefix(comma + 1);
        }
    }

    core::Result<VelocityChoice> find() const {
        for (const auto& name : names_)
            if (!has(name))
                return core::fail(Error::Code::NotFound,
                                  "there is no field " + name + "; there is " + listed(fields_),
                                  "--velocity takes the name of one vector, or of three scalars");
        for (const auto source : field_places)
            if (auto found = find_in(source))
                return *found;
        if (names_.size() == 1 && all_of(3) && meaning_of_vector(names_[0]) == VectorName::Momentum)
            return core::fail(Error::Code::Unsupported,
                              "momentum is not velocity; the fields are " + listed(fields_),
                              "name its density as well: --velocity MOMENTUM,DENSITY");
        return core::fail(Error::Code::Unsupported,
                          "no velocity is made of " + listed(pick(fields_, is_named())),
                          "--velocity takes one vector, three scalars, or a momentum and its "
                          "density, all at points or all in cells");
    }

  private:
    bool has(const std::string& name) const {
        return std::any_of(fields_.begin(), fields_.end(),
                           [&](const FieldInfo& f) { return f.name == name; });
    }

    std::function<bool(const FieldInfo&)> is_named() const {
        return [this](const FieldInfo& f) {
            return std::find(names_.begin(), names_.end(), f.name) != names_.end();
        };
    }

    bool all_of(int components) const {
        return std::ranges::all_of(pick(fields_, is_named()),
                                   [&](const FieldInfo& f) { return f.components == components; });
    }

    std::optional<VelocityChoice> find_in(FieldInfo::Source source) const {
        Fields parts;
        for (const auto& name : names_)
            for (const auto& field : fields_)
                if (field.name == name && field.source == source)
                    parts.push_back(field);
        std::string shape;
        for (const auto& part : parts)
            shape += std::to_string(part.components);
        if (parts.size() != names_.size())
            return std::nullopt;
        Fields divisor;
        if (shape == "3" && is_vector(parts[0], VectorName::Momentum)) {
            divisor = pick(fields_,
                           [&](const FieldInfo& f) { return f.source == source && is_density(f); });
            if (divisor.size() != 1)
                return std::nullopt;
        } else if (shape == "31" || shape == "1111") {
            divisor = {parts.back()};
            parts.pop_back();
        } else if (shape != "3" && shape != "111") {
            return std::nullopt;
        }
        const char* const why = divisor.empty() ? "chosen by --velocity"
                                                : "chosen by --velocity; the momentum is divided "
                                                  "by the density";
        return made(std::move(parts), std::move(divisor), why);
    }

    const Fields& fields_;
    std::vector<std::string> names_;
};

} // namespace

std::string listed(const Fields& fields) {
    std::string out;
    for (const auto& field : fields)
        out += (out.empty() ? "" : ", ") + field.name + " (" + std::to_string(field.components) +
               (field.components == 1 ? " component, " : " components, ") +
               (field.source == FieldInfo::Source::Cell ? "cell)" : "point)");
    return out.empty() ? "no array that all its parts have" : out;
}

std::set<std::string> possible_velocity(const Fields& fields,
                                        const std::string& wish,
                                        const std::vector<StatedComponents>& stated) {
    std::set<std::string> out;
    const auto add = [&](const Fields& some) {
        for (const auto& field : some)
            out.insert(field.name);
    };
    if (const auto velocity = choose_velocity(fields, wish, stated)) {
        add(velocity->parts.arrays);
        add(velocity->parts.divisor);
    } else {
        add(pick(fields, [](const FieldInfo& f) { return f.components == 3; }));
    }
    return out;
}

std::vector<std::string> velocity_candidates(const Fields& fields,
                                             const std::vector<StatedComponents>& stated) {
    constexpr std::size_t most = 32;
    std::vector<std::string> out;
    const auto add = [&](const std::string& wish) {
        if (out.size() < most && std::find(out.begin(), out.end(), wish) == out.end() &&
            Wish(fields, wish).find())
            out.push_back(wish);
    };
    const auto add_vectors = [&](bool something_else) {
        for (const auto& field : fields)
            if (field.components == 3 && !is_vector(field, VectorName::Momentum) &&
                is_vector(field, VectorName::Other) == something_else)
                add(field.name);
    };
    for (const auto& parts : stated)
        add(parts[0] + "," + parts[1] + "," + parts[2]);
    add_vectors(false);
    for (const auto source : field_places)
        for (const auto& parts : velocity_components(fields, source))
            add(parts[0].name + "," + parts[1].name + "," + parts[2].name);
    for (const auto& momentum : fields)
        for (const auto& density : fields)
            if (is_vector(momentum, VectorName::Momentum) && is_density(density))
                add(momentum.name + "," + density.name);
    add_vectors(true);
    return out;
}

core::Result<VelocityChoice> choose_velocity(const Fields& fields,
                                             const std::string& wish,
                                             const std::vector<StatedComponents>& stated) {
    if (!wish.empty())
        return Wish(fields, wish).find();
    auto choice = Rules(fields, stated).run();
    if (!choice)
        return tl::unexpected(choice.error());
    if (choice->has_value())
        return std::move(**choice);
    const bool vectors = std::any_of(fields.begin(), fields.end(),
                                     [](const FieldInfo& f) { return f.components == 3; });
    return core::fail(Error::Code::NotFound,
                      std::string(vectors ? "no field is a velocity" : "there is no vector field") +
                          "; there is " + listed(fields),
                      vectors ? "if one of them is, " + choose_one(fields)
                              : "write the velocity as one array of 3 components, or " +
                                    choose_one(fields));
}

} // namespace wakesurf::importer
