#include "server/import/velocity_choice.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

namespace wakesurf::server {

using core::Error;
using core::FieldInfo;

namespace {

using Fields = std::vector<FieldInfo>;

// Lower case, letters and digits only: "Velocity_X" and "velocity-x" are one name.
std::string plain(std::string_view name) {
    std::string out;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

template <class Names>
bool any_of(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Condition>
Fields pick(const Fields& fields, const Condition& condition) {
    Fields out;
    std::copy_if(fields.begin(), fields.end(), std::back_inserter(out), condition);
    return out;
}

bool is_momentum(const FieldInfo& field) {
    constexpr std::array<std::string_view, 5> names{"momentum", "rhou", "rhov", "rhouvw",
                                                    "momentumdensity"};
    return field.components == 3 && any_of(names, plain(field.name));
}

bool is_density(const FieldInfo& field) {
    constexpr std::array<std::string_view, 3> names{"density", "rho", "massdensity"};
    return field.components == 1 && any_of(names, plain(field.name));
}

bool is_named_velocity(const FieldInfo& field) {
    constexpr std::array<std::string_view, 3> names{"u", "velocity", "vel"};
    return field.components == 3 && any_of(names, plain(field.name));
}

bool is_average(const std::string& name) {
    constexpr std::array<std::string_view, 6> words{"mean", "avg",   "average",
                                                    "rms",  "prime", "fluct"};
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

bool speaks_of_velocity(const FieldInfo& field) {
    const std::string name = plain(field.name);
    return field.components == 3 && name.find("velocity") != std::string::npos && !is_average(name);
}

// Vectors whose names tell that they are no velocity.
bool is_something_else(const FieldInfo& field) {
    constexpr std::array<std::string_view, 11> words{
        "momentum",   "vorticity", "gradient", "grad", "normal",  "displacement",
        "coordinate", "shear",     "force",    "curl", "magnetic"};
    const std::string name = plain(field.name);
    return is_momentum(field) ||
           std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

constexpr std::array<FieldInfo::Source, 2> places{FieldInfo::Source::Point,
                                                  FieldInfo::Source::Cell};

using Triple = std::array<std::string_view, 3>;

constexpr std::array<Triple, 14> component_names{{{"u", "v", "w"},
                                                  {"velocityx", "velocityy", "velocityz"},
                                                  {"xvelocity", "yvelocity", "zvelocity"},
                                                  {"uvelocity", "vvelocity", "wvelocity"},
                                                  {"velocityu", "velocityv", "velocityw"},
                                                  {"vx", "vy", "vz"},
                                                  {"ux", "uy", "uz"},
                                                  {"velx", "vely", "velz"},
                                                  {"xvel", "yvel", "zvel"},
                                                  {"uvel", "vvel", "wvel"},
                                                  {"velocity0", "velocity1", "velocity2"},
                                                  {"u0", "u1", "u2"},
                                                  {"uwind", "vwind", "wwind"},
                                                  {"uinterp", "vinterp", "winterp"}}};
constexpr std::array<Triple, 3> momentum_names{{{"momentumx", "momentumy", "momentumz"},
                                                {"rhou", "rhov", "rhow"},
                                                {"rhoux", "rhouy", "rhouz"}}};

std::optional<Fields>
triple_of(const Fields& fields, const Triple& names, FieldInfo::Source source) {
    Fields parts;
    for (const auto name : names) {
        const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldInfo& f) {
            return f.components == 1 && f.source == source && plain(f.name) == name;
        });
        if (found == fields.end())
            return std::nullopt;
        parts.push_back(*found);
    }
    return parts;
}

std::string joined(const Fields& fields) {
    std::string out;
    for (const auto& field : fields)
        out += (out.empty() ? "" : ", ") + field.name;
    return out;
}

class Choice {
  public:
    Choice(const Fields& fields, bool asked) : fields_(fields), asked_(asked) {}

    // The outer list is empty where the rules find nothing.
    core::Result<std::optional<VelocityChoice>> run() const {
        using Rule =
            core::Result<std::optional<VelocityChoice>> (Choice::*)(FieldInfo::Source) const;
        constexpr std::array<Rule, 5> rules{&Choice::named, &Choice::components, &Choice::spoken_of,
                                            &Choice::momentum, &Choice::only};
        for (const Rule rule : rules)
            for (const auto source : places) {
                auto found = (this->*rule)(source);
                if (!found || found->has_value())
                    return found;
            }
        return std::nullopt;
    }

    VelocityChoice made(Fields parts, Fields divisor, std::string name, std::string why) const {
        if (asked_)
            why = "chosen by --fields" + (divisor.empty() ? std::string() : "; " + why);
        if (parts.front().source == FieldInfo::Source::Cell)
            why += "; its cell values are averaged to the points";
        return {{std::move(parts), std::move(divisor), 3}, std::move(name), std::move(why)};
    }

  private:
    using Found = core::Result<std::optional<VelocityChoice>>;

    template <class Condition>
    Found vector(FieldInfo::Source source, const Condition& condition, const char* why) const {
        const Fields here = pick(fields_, [&](const FieldInfo& f) {
            return f.components == 3 && f.source == source && condition(f);
        });
        if (here.size() > 1)
            return core::fail(Error::Code::InvalidArgument,
                              "several fields could be the velocity: " + listed(here),
                              "choose one with --fields NAME");
        if (here.empty())
            return std::nullopt;
        return made(here, {}, here.front().name, why);
    }

    Found named(FieldInfo::Source source) const {
        const bool alone = std::count_if(fields_.begin(), fields_.end(), [&](const FieldInfo& f) {
                               return f.components == 3 && f.source == source;
                           }) == 1;
        return vector(source, is_named_velocity,
                      alone ? "the only 3-component field"
                            : "the only 3-component field with the name of a velocity");
    }

    Found components(FieldInfo::Source source) const {
        std::vector<Fields> found;
        for (const Triple& names : component_names)
            if (auto parts = triple_of(fields_, names, source))
                found.push_back(std::move(*parts));
        if (found.size() > 1)
            return core::fail(Error::Code::InvalidArgument,
                              "several fields could be the velocity: " + joined(found[0]) + " or " +
                                  joined(found[1]),
                              "choose three with --fields U,V,W");
        if (found.empty())
            return std::nullopt;
        return made(found[0], {}, joined(found[0]),
                    "three fields with the names of its components");
    }

    Found spoken_of(FieldInfo::Source source) const {
        return vector(source, speaks_of_velocity,
                      "the only 3-component field whose name suggests a velocity");
    }

    Found momentum(FieldInfo::Source source) const {
        Fields parts =
            pick(fields_, [&](const FieldInfo& f) { return f.source == source && is_momentum(f); });
        for (const Triple& names : momentum_names)
            if (parts.empty())
                parts = triple_of(fields_, names, source).value_or(Fields());
        const Fields density =
            pick(fields_, [&](const FieldInfo& f) { return f.source == source && is_density(f); });
        const bool one_vector =
            parts.size() == 1 || (parts.size() == 3 && parts[0].components == 1);
        if (!one_vector || density.size() != 1)
            return std::nullopt;
        return made(parts, density, joined(parts) + " / " + density.front().name,
                    "there is no velocity, so the momentum is divided by the density");
    }

    Found only(FieldInfo::Source source) const {
        return vector(
            source,
            [&](const FieldInfo& f) { return asked_ ? !is_momentum(f) : !is_something_else(f); },
            "the only 3-component field");
    }

    const Fields& fields_;
    bool asked_;
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

std::set<std::string> possible_velocity(const Fields& fields) {
    std::set<std::string> out;
    const auto add = [&](const Fields& some) {
        for (const auto& field : some)
            out.insert(field.name);
    };
    if (const auto velocity = choose_velocity(fields, {})) {
        add(velocity->parts.arrays);
        add(velocity->parts.divisor);
    } else {
        add(pick(fields, [](const FieldInfo& f) { return f.components == 3; }));
    }
    return out;
}

core::Result<VelocityChoice> choose_velocity(const Fields& fields,
                                             const std::vector<std::string>& wanted) {
    const Fields asked = pick(fields, [&](const FieldInfo& f) {
        return std::find(wanted.begin(), wanted.end(), f.name) != wanted.end();
    });
    if (!asked.empty()) {
        auto choice = Choice(asked, true).run();
        if (!choice)
            return tl::unexpected(choice.error());
        if (choice->has_value())
            return std::move(**choice);
        if (std::any_of(asked.begin(), asked.end(), is_momentum))
            return core::fail(Error::Code::Unsupported,
                              "momentum is not velocity; the fields are " + listed(fields),
                              "name its density as well: --fields MOMENTUM,DENSITY");
    }
    auto choice = Choice(fields, false).run();
    if (!choice)
        return tl::unexpected(choice.error());
    if (choice->has_value())
        return std::move(**choice);
    // Three scalars of any names are a velocity where somebody says so and nothing else is one.
    Fields three;
    for (const auto& name : wanted)
        for (const auto source : places)
            for (const auto& field : asked)
                if (field.name == name && field.source == source && field.components == 1 &&
                    (three.empty() ||
                     (three.front().source == source && three.back().name != name)))
                    three.push_back(field);
    if (three.size() == 3 && wanted.size() == 3)
        return Choice(fields, true).made(three, {}, joined(three), "");
    const bool vectors = std::any_of(fields.begin(), fields.end(),
                                     [](const FieldInfo& f) { return f.components == 3; });
    return core::fail(Error::Code::NotFound,
                      std::string(vectors ? "no field is a velocity" : "there is no vector field") +
                          "; there is " + listed(fields),
                      vectors ? "if one of them is, choose it with --fields NAME"
                              : "write the velocity as one array of 3 components, or as three "
                                "called u, v and w");
}

} // namespace wakesurf::server
