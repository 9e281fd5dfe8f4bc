#include "store/velocity_names.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <span>

namespace wakesurf::store {

using core::FieldInfo;

namespace {

using Words = std::vector<std::string>;

bool letter_or_digit(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

bool capital(char c) {
    return std::isupper(static_cast<unsigned char>(c)) != 0;
}

char small(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

// Makes "Velocity[i]" of "Velocity[i] (m/s)": what stands in brackets at the end is a unit where it holds
// more than an index.
std::string without_unit(const std::string& name) {
    constexpr std::string_view ends = ")]";
    if (name.empty() || ends.find(name.back()) == std::string_view::npos)
        return name;
    const auto open = name.find_last_of("([");
    if (open == std::string::npos || open == 0 ||
        name.find_first_of("/^ .-", open) == std::string::npos)
        return name;
    return name.substr(0, open);
}

// Returns lower case, letters and digits only: "Velocity_X" and "velocity-x" are one name. u' is no u.
std::string plain(const std::string& name) {
    std::string out;
    for (const char c : without_unit(name))
        if (letter_or_digit(c))
            out += small(c);
        else if (c == '\'')
            out += "prime";
    return out;
}

// "GridVelocity", "grid_velocity" and "UMean" are two words each, in lower case.
Words words_in(const std::string& given) {
    const std::string name = without_unit(given);
    Words out;
    bool apart = true;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (!letter_or_digit(name[i])) {
            apart = true;
            continue;
        }
        const bool begins =
            i > 0 && capital(name[i]) &&
            (!capital(name[i - 1]) || (i + 1 < name.size() && letter_or_digit(name[i + 1]) &&
                                       std::islower(static_cast<unsigned char>(name[i + 1])) != 0));
        if (apart || begins)
            out.emplace_back();
        out.back() += small(name[i]);
        apart = false;
    }
    return out;
}

bool any_of(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool holds_any_of(const std::string& name, std::span<const std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

bool any_word_of(const Words& words, std::span<const std::string_view> wanted) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return any_of(wanted, word); });
}

constexpr auto exact_velocities =
    std::to_array<std::string_view>({"u", "v", "velocity", "velocities", "vel", "uvw"});
constexpr auto velocity_words =
    std::to_array<std::string_view>({"u", "vel", "velocity", "velocities"});
constexpr auto words_of_the_fluid = std::to_array<std::string_view>(
    {"flow",  "fluid",  "gas",      "liquid",  "air",      "water",   "wind",
     "field", "vector", "vec",      "local",   "absolute", "abs",     "total",
     "cell",  "cells",  "centered", "centred", "cc",       "point",   "points",
     "node",  "nodal",  "nodes",    "current", "xyz",      "instant", "instantaneous"});
constexpr auto momentum_names =
    std::to_array<std::string_view>({"momentum", "rhou", "rhov", "rhouvw", "momentumdensity"});
constexpr auto density_names =
    std::to_array<std::string_view>({"density", "rho", "massdensity", "dens", "gasdensity"});
constexpr auto average_words =
    std::to_array<std::string_view>({"mean", "avg", "average", "averaged", "tavg"});

// Anywhere in a name, since GRIDVEL and umesh are no two words.
constexpr auto signs_of_others = std::to_array<std::string_view>(
    {"momentum", "vorticity",  "gradient", "grad",     "normal",   "displacement", "coordinate",
     "shear",    "force",      "curl",     "magnetic", "electric", "grid",         "mesh",
     "angular",  "friction",   "rotation", "rotor",    "fluct",    "prime",        "variance",
     "wall",     "boundary",   "particle", "acoustic", "sound",    "group",        "alfven",
     "drift",    "settling",   "terminal", "diffus",   "residual", "error",        "adjoint",
     "stress",   "accel",      "flux",     "position", "structur", "deviation",    "perturb",
     "stddev",   "temperature"});
constexpr auto words_of_others = std::to_array<std::string_view>(
    {"rms", "slip", "solid", "body", "tau", "star", "min", "max", "old", "prev", "wave", "std",
     "var", "moving", "base", "blade", "omega"});
// Name what is derived from one component: its gradient, or a statistic of it.
constexpr auto component_words =
    std::to_array<std::string_view>({"x", "y", "z", "w", "ux", "uy", "uz", "vx", "vy", "vz", "velx",
                                     "vely", "velz", "u1", "u2", "u3", "vel1", "vel2", "vel3"});

using Triple = std::array<std::string, 3>;
using Names = std::array<std::string_view, 3>;

constexpr std::array<Names, 6> axes_behind{{{"x", "y", "z"},
                                            {"1", "2", "3"},
                                            {"0", "1", "2"},
                                            {"i", "j", "k"},
                                            {"u", "v", "w"},
                                            {"x1", "x2", "x3"}}};
constexpr std::array<Names, 2> axes_before{{{"x", "y", "z"}, {"u", "v", "w"}}};
constexpr auto velocity_stems =
    std::to_array<std::string_view>({"velocity", "vel", "u", "v", "velocities", "wind",
                                     "flowvelocity", "fluidvelocity", "gasvelocity"});
constexpr auto velocity_tails =
    std::to_array<std::string_view>({"velocity", "vel", "velocities", "wind", "velocitycomponent",
                                     "componentofvelocity", "componentofwind", "interp"});
constexpr auto momentum_stems =
    std::to_array<std::string_view>({"momentum", "mom", "rhou", "momentumdensity"});
constexpr auto momentum_tails =
    std::to_array<std::string_view>({"momentum", "mom", "momentumdensity"});

std::vector<Triple> names_of(std::span<const std::string_view> stems,
                             std::span<const std::string_view> tails) {
    std::set<Triple> out;
    const auto add = [&](const Names& axes, const auto& name) {
        out.insert({name(axes[0]), name(axes[1]), name(axes[2])});
    };
    for (const auto stem : stems)
        for (const Names& axes : axes_behind)
            if (!(stem.size() == 1 && axes[0] == "u")) // uu and uv are stresses
                add(axes, [&](std::string_view axis) { return std::string(stem).append(axis); });
    for (const auto tail : tails)
        for (const Names& axes : axes_before)
            add(axes, [&](std::string_view axis) { return std::string(axis).append(tail); });
    return {out.begin(), out.end()};
}

// Returns the pattern of a name: U_X matches u_x, Vel_Y matches Vel_X.
std::string look_of(const std::string& name) {
    std::string out;
    for (const char c : name)
        out += !letter_or_digit(c) ? c : capital(c) ? 'A' : 'a';
    return out;
}

// Adds one triple for each pattern of the first component's name; the others may have another one if that is
// clear: Vx, VY, vz.
void add_triples(const std::vector<FieldInfo>& fields,
                 const Triple& names,
                 FieldInfo::Source source,
                 std::vector<Components>& out) {
    std::array<Components, 3> found;
    for (const auto& field : fields)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (field.components == 1 && field.source == source && plain(field.name) == names[axis])
                found[axis].push_back(field);
    for (const auto& first : found[0]) {
        Components triple{first};
        for (const std::size_t axis : {1u, 2u}) {
            const auto alike =
                std::find_if(found[axis].begin(), found[axis].end(), [&](const FieldInfo& field) {
                    return found[axis].size() == 1 || look_of(field.name) == look_of(first.name);
                });
            if (alike != found[axis].end())
                triple.push_back(*alike);
        }
        if (triple.size() == 3)
            out.push_back(std::move(triple));
    }
}

std::vector<Components> triples_of(const std::vector<FieldInfo>& fields,
                                   FieldInfo::Source source,
                                   const std::vector<Triple>& all) {
    std::vector<Components> out;
    for (const Triple& names : all)
        add_triples(fields, names, source, out);
    return out;
}

bool is_of_something_else(const std::string& name, const Words& words) {
    return holds_any_of(name, signs_of_others) || any_word_of(words, words_of_others) ||
           (any_word_of(words, component_words) && words.size() > 1);
}

// Recognises U.air, U.particles: OpenFOAM names the velocity of each phase so.
bool is_of_a_phase(const std::string& name) {
    return name.starts_with("U.") && name.size() > 2 && !holds_any_of(plain(name), average_words);
}

} // namespace

VectorName meaning_of_vector(const std::string& given) {
    const std::string name = plain(given);
    const Words words = words_in(given);
    if (any_of(exact_velocities, name))
        return VectorName::Velocity;
    if (any_of(momentum_names, name))
        return VectorName::Momentum;
    if (is_of_a_phase(given))
        return VectorName::Qualified;
    if (is_of_something_else(name, words))
        return VectorName::Other;
    if (any_word_of(words, average_words) || holds_any_of(name, average_words))
        return VectorName::Average;
    const auto velocity = [](const std::string& word) { return any_of(velocity_words, word); };
    if (std::any_of(words.begin(), words.end(), velocity) &&
        std::all_of(words.begin(), words.end(), [&](const std::string& word) {
            return velocity(word) || any_of(words_of_the_fluid, word);
        }))
        return VectorName::Qualified;
    return name.find("velocity") != std::string::npos || any_word_of(words, velocity_words)
               ? VectorName::Unclear
               : VectorName::Unknown;
}

bool is_density(const FieldInfo& field) {
    return field.components == 1 && any_of(density_names, plain(field.name));
}

std::vector<Components> velocity_components(const std::vector<FieldInfo>& fields,
                                            FieldInfo::Source source) {
    static const auto names = [] {
        auto out = names_of(velocity_stems, velocity_tails);
        out.push_back({"u", "v", "w"});
        return out;
    }();
    return triples_of(fields, source, names);
}

std::vector<Components> momentum_components(const std::vector<FieldInfo>& fields,
                                            FieldInfo::Source source) {
    static const auto names = [] {
        auto out = names_of(momentum_stems, momentum_tails);
        out.push_back({"rhou", "rhov", "rhow"});
        return out;
    }();
    return triples_of(fields, source, names);
}

} // namespace wakesurf::store
