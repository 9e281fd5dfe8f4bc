// An animation as one page: the viewer that the page's build makes (web-client/dist/animation.html), with a
// description and the frames of all steps in it. It opens from a disk, and asks nobody for anything.
#pragma once

#include "core/base/result.hpp"

#include <string>
#include <string_view>

namespace wakesurf::protocol {

/// Returns the page. Nothing in the description can act as markup, whoever wrote the names in it.
/// @param viewer       without data
/// @param description  JSON: AnimationDescription of web-client/src/animation/animationFile.ts
/// @param frames       of the wire, the first of a KEY, each preceded by its length as u32
/// Error: Corrupt if the viewer is not one.
core::Result<std::string>
animation_page(std::string_view viewer, std::string_view description, std::string_view frames);

} // namespace wakesurf::protocol
