// An animation as one page: the viewer that the page's build makes (web-client/dist/animation.html), with a
// description, the frames of all steps, those of the body, and a recipe in it. It opens from a disk, and asks nobody for anything.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::protocol {

/// The extension of such a page.
inline constexpr std::string_view animation_extension = "html";

/// What the viewer says of an animation: AnimationDescription of web-client/src/animation/animationFile.ts.
struct AnimationDescription {
    /// Something that can be shown in colours.
    struct Value {
        std::string name;  ///< as the frames have it
        std::string title; ///< for people, with its unit
        std::array<double, 2> range{};
        bool is_signed = false; ///< zero is its middle
    };

    std::string title;
    std::string kind;
    double from = 0.0; ///< when the surface begins
    std::array<double, 6> bounds{};
    core::Vec3 lattice_origin{};
    double lattice_step = 0.0;
    int lattice_bits = 0;
    std::vector<std::string> attributes; ///< of the frames, in their order
    std::vector<Value> values;
    std::vector<double> times;
    std::string length_unit;
    std::string time_unit;
    std::vector<std::string> facts; ///< sentences: how it was made, how exact it is
    std::string look{};             ///< as read_look returned it; empty: the usual
};

/// Returns the text of a look: a JSON object of what the page's styles of surfaces consist of, in one spelling. What it says is
/// for the viewer to judge. Error: InvalidArgument for anything else, or more than 2 kB.
core::Result<std::string> read_look(const std::string& text);

/// What goes into the viewer.
struct AnimationParts {
    AnimationDescription description;
    std::string_view
        frames;            ///< of the wire, the first of a KEY, each preceded by its length as u32
    std::string_view body; ///< one KEY, likewise; empty: there is none
    std::string_view recipe; ///< recipe_text
};

/// Returns the page. Nothing in it can act as markup, whoever wrote the names in the description.
/// @param viewer  without data
/// Error: Corrupt if the viewer is not one.
core::Result<std::string> animation_page(std::string_view viewer, const AnimationParts& parts);

/// Says where two pages differ, in words: first in what they show, then in the viewer. Only `right` is believed to be a page.
std::string animation_difference(std::string_view given, std::string_view right);

} // namespace wakesurf::protocol
