#include "protocol/files/animation_page.hpp"

#include "protocol/api/base/json_text.hpp"
#include "protocol/files/base64.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <optional>

namespace wakesurf::protocol {

namespace {

using nlohmann::json;
using std::string_view;

/// The elements of the viewer that take data, in their order.
constexpr std::array<string_view, 4> places{
    R"(<script type="text/plain" id="recipe">)",
    R"(<script type="application/json" id="description">)",
    R"(<script type="text/plain" id="body">)",
    R"(<script type="text/plain" id="frames">)",
};
constexpr string_view element_end = "</script>";
constexpr std::size_t longest_look = 2048;

/// Writes `<` of JSON as \u003c, which means the same there: no text then ends the element, or begins a
/// comment in it.
std::string without_markup(string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text)
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    return out;
}

std::string json_of(const AnimationDescription& d) {
    json values = json::array();
    for (const AnimationDescription::Value& each : d.values)
        values.push_back({{"name", each.name},
                          {"title", each.title},
                          {"range", each.range},
                          {"signed", each.is_signed}});
    const core::Vec3& origin = d.lattice_origin;
    json out{{"title", d.title},
             {"kind", d.kind},
             {"from", d.from},
             {"bounds", d.bounds},
             {"lattice",
              {{"origin", {origin.x, origin.y, origin.z}},
               {"step", d.lattice_step},
               {"bits", d.lattice_bits}}},
             {"attributes", d.attributes},
             {"values", values},
             {"times", d.times},
             {"lengthUnit", d.length_unit},
             {"timeUnit", d.time_unit},
             {"facts", d.facts}};
    if (!d.look.empty())
        out["look"] = json::parse(d.look, nullptr, false);
    return without_markup(json_text(out));
}

/// Where each place begins behind its tag; nothing where one is missing, or not the only one, or not in order.
std::optional<std::array<std::size_t, places.size()>> contents_of(string_view page) {
    std::array<std::size_t, places.size()> out{};
    std::size_t before = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::size_t at = page.find(places[k]);
        if (at == string_view::npos || at < before ||
            page.find(places[k], at + 1) != string_view::npos)
            return std::nullopt;
        before = out[k] = at + places[k].size();
    }
    return out;
}

/// A page in its parts: the data, and what is left of it, the viewer.
struct Parted {
    std::array<string_view, places.size()> content;
    std::string viewer;
};

std::optional<Parted> parted(string_view page) {
    const auto begins = contents_of(page);
    if (!begins)
        return std::nullopt;
    Parted out;
    std::size_t done = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::size_t begin = (*begins)[k];
        const std::size_t end = page.find(element_end, begin);
        if (end == string_view::npos)
            return std::nullopt;
        out.content[k] = page.substr(begin, end - begin);
        out.viewer += page.substr(done, begin - done);
        done = end;
    }
    out.viewer += page.substr(done);
    return out;
}

std::size_t mismatch_of(string_view a, string_view b) {
    return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

std::string description_difference(string_view given, string_view right) {
    const json ours = json::parse(right, nullptr, false);
    const json theirs = json::parse(given, nullptr, false);
    if (theirs.is_object())
        for (const auto& [name, value] : ours.items())
            if (const auto found = theirs.find(name); found == theirs.end() || *found != value)
                return fmt::format("its description differs in `{}`", name);
    return fmt::format("its description differs, at byte {}", mismatch_of(given, right));
}

/// Returns which frame holds the first difference.
std::string frames_difference(string_view given, string_view right) {
    const std::string bytes = base64_bytes(right).value_or("");
    const std::size_t wrong = mismatch_of(given, right) / 4 * 3;
    std::size_t frame = 0;
    std::size_t count = 0;
    for (std::size_t at = 0; at + 4 <= bytes.size(); ++count) {
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + at, sizeof length);
        frame = at <= wrong ? count : frame;
        at += sizeof length + length;
    }
    return fmt::format("the surface differs, in frame {} of {}", frame + 1, count);
}

} // namespace

core::Result<std::string> read_look(const std::string& text) {
    if (text.empty())
        return text;
    const auto value = parse_json(text, {longest_look, 3});
    if (!value || !value->is_object())
        return core::fail(
            core::Error::Code::InvalidArgument,
            fmt::format("`look` is not a JSON object of at most {} bytes", longest_look),
            R"(as in ?look={"map":"inferno","range":[0,2]})");
    return json_text(*value);
}

core::Result<std::string> animation_page(string_view viewer, const AnimationParts& parts) {
    const auto begins = contents_of(viewer);
    const bool is_viewer = begins && std::ranges::all_of(*begins, [&](std::size_t begin) {
                               return viewer.substr(begin).starts_with(element_end);
                           });
    if (!is_viewer)
        return core::fail(core::Error::Code::Corrupt,
                          "the viewer of animations is not the one that belongs to this program",
                          "build the web client again, or install all of wakesurf again");
    const std::string description = json_of(parts.description);
    std::string page;
    page.reserve(viewer.size() + parts.recipe.size() + description.size() +
                 (parts.body.size() + parts.frames.size()) / 3 * 4 + 1024);
    std::size_t done = 0;
    const auto up_to = [&](std::size_t place) {
        page += viewer.substr(done, (*begins)[place] - done);
        done = (*begins)[place];
    };
    up_to(0);
    page += parts.recipe;
    up_to(1);
    page += description;
    up_to(2);
    append_base64(page, parts.body);
    up_to(3);
    append_base64(page, parts.frames);
    page += viewer.substr(done);
    return page;
}

std::string animation_difference(string_view given, string_view right) {
    if (given == right)
        return {};
    const auto theirs = parted(given);
    const auto ours = parted(right);
    if (!ours || !theirs)
        return fmt::format("it is not built as an animation is, from byte {} on",
                           mismatch_of(given, right));
    const auto& [recipe, description, body, frames] = ours->content;
    if (theirs->content[3] != frames)
        return frames_difference(theirs->content[3], frames);
    if (theirs->content[2] != body)
        return body.empty()                 ? "it has a body, and the data have none"
               : theirs->content[2].empty() ? "it lacks the body of the data"
                                            : "the body differs";
    if (theirs->content[1] != description)
        return description_difference(theirs->content[1], description);
    if (theirs->content[0] != recipe)
        return fmt::format("its recipe differs, at byte {} of it",
                           mismatch_of(theirs->content[0], recipe));
    return fmt::format("its viewer differs, at byte {} of it; what it shows is the same",
                       mismatch_of(theirs->viewer, ours->viewer));
}

} // namespace wakesurf::protocol
