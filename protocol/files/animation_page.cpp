#include "protocol/files/animation_page.hpp"

#include "protocol/files/base64.hpp"

namespace wakesurf::protocol {

namespace {

constexpr std::string_view description_begin =
    R"(<script type="application/json" id="description">)";
constexpr std::string_view frames_begin = R"(<script type="text/plain" id="frames">)";
constexpr std::string_view element_end = "</script>";

/// Writes `<` of JSON as \u003c, which means the same there: no text then ends the element, or begins a
/// comment in it.
std::string without_markup(std::string_view json) {
    std::string out;
    out.reserve(json.size());
    for (const char c : json)
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    return out;
}

/// Returns where the content of an empty element begins.
std::size_t place_of(std::string_view viewer, std::string_view begin) {
    const std::size_t at = viewer.find(begin);
    const std::size_t content = at + begin.size();
    const bool alone = at != std::string_view::npos &&
                       viewer.substr(content).starts_with(element_end) &&
                       viewer.find(begin, content) == std::string_view::npos;
    return alone ? content : std::string_view::npos;
}

} // namespace

core::Result<std::string>
animation_page(std::string_view viewer, std::string_view description, std::string_view frames) {
    const std::size_t first = place_of(viewer, description_begin);
    const std::size_t second = place_of(viewer, frames_begin);
    if (first == std::string_view::npos || second == std::string_view::npos || second < first)
        return core::fail(core::Error::Code::Corrupt,
                          "the viewer of animations is not the one that belongs to this program",
                          "build the web client again, or install all of wakesurf again");
    std::string page;
    page.reserve(viewer.size() + description.size() + frames.size() / 3 * 4 + 1024);
    page += viewer.substr(0, first);
    page += without_markup(description);
    page += viewer.substr(first, second - first);
    append_base64(page, frames);
    page += viewer.substr(second);
    return page;
}

} // namespace wakesurf::protocol
