#include "protocol/files/recipe.hpp"

#include "core/base/crc32c.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/generated/limits.hpp"
#include "protocol/api/generated/names.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/files/base64.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>
#include <utility>

namespace wakesurf::protocol {

namespace {

constexpr std::string_view marker = "wakesurf-recipe:";
constexpr char end_mark = '.';
constexpr std::size_t sum_length = 8;
constexpr std::size_t line_length = 900;
constexpr std::size_t longest_recipe = std::size_t{1} << 20;

// A stranger may fill a file with markers, each of which is tried.
constexpr std::size_t most_damaged = 64;

// Between a line of a recipe and the next: the end of the line, and the word for a comment.
constexpr std::size_t between_lines = 32;

constexpr std::size_t longest_name = 4096;
constexpr std::uint64_t most_quads = 100'000'000; // of --max-quads

template <class Io>
void rake_members(Io& io, Of<Io, core::Rake>& of) {
    io.needed("kind", of.kind);
    io.needed("points", of.points, {.hi = limits::rake_points});
    io.needed("seeds", of.seeds, {.lo = limits::seeds_least, .hi = limits::seeds_most});
}

struct RecipeRake {
    core::Rake rake;
};

template <class Io>
void members(Io& io, Of<Io, RecipeRake>& of) {
    rake_members(io, of.rake);
}

std::string checksum_of(std::string_view json) {
    return fmt::format("{:08x}", core::crc32c(std::as_bytes(std::span(json))));
}

} // namespace

template <class Io>
void members(Io& io, Of<Io, Recipe>& of) {
    // What a record limits more narrowly than the command line stands beside it.
    SurfaceRecord surface;
    surface.surface = "s";
    surface.rake = "r";
    surface.parameters = of.parameters;
    surface.parameters.max_quads = 1;
    std::optional<RecipeRake> second;
    if (of.parameters.rake2) {
        surface.rake2 = "r2";
        second = RecipeRake{*of.parameters.rake2};
    }
    if (of.twin)
        surface.twin = Twin{{}, *of.twin};
    RecipeRake first{of.rake};
    std::uint64_t quads = of.parameters.max_quads;
    io.needed("wakesurf", of.version, {.hi = 256, .text = Text::Line});
    io.needed("dataset", of.dataset, {.hi = longest_name});
    io.some("flow", of.flow, {.hi = longest_name});
    io.some("values", of.values, {.hi = 256, .text = Text::Line});
    io.needed("surface", surface);
    io.needed("rake", first);
    io.some("rake2", second);
    io.needed("maxQuads", quads, {.lo = 1, .hi = most_quads});
    io.some("deformation", of.parameters.deformation);
    io.some("tangents", of.parameters.tangents);
    io.some("fields", of.fields, {.hi = 1024});
    io.some("format", of.format, {.hi = 16, .text = Text::Line});
    io.some("draco", of.draco, {}, true);
    io.some("tessellate", of.tessellate, {.lo = 1, .hi = 64}, 1U);
    io.some("lines", of.lines, {.hi = 256, .text = Text::Line});
    io.some("time", of.time, {.lo = -largest_float, .hi = largest_float});
    io.some("times", of.times);
    io.some("look", of.look, {.hi = longest_name});
    io.some("step", of.step);
    io.some("coarse", of.coarse);
    io.some("unrepeatable", of.unrepeatable, {.hi = longest_name});
    io.some("mesh", of.mesh, {.hi = seal_length, .text = Text::Line});
    io.some("shape", of.shape, {.hi = seal_length, .text = Text::Line});
    io.some("rounding", of.rounding, {.hi = seal_length, .text = Text::Line});
    if constexpr (Io::reads) {
        const bool deformation = of.parameters.deformation;
        const bool tangents = of.parameters.tangents;
        of.parameters = std::move(surface.parameters);
        of.parameters.max_quads = quads;
        of.parameters.deformation = deformation;
        of.parameters.tangents = tangents;
        of.rake = std::move(first.rake);
        if (surface.twin)
            of.twin = surface.twin->settings;
        if (second)
            of.parameters.rake2 = std::move(second->rake);
    }
}

std::string recipe_text(const Recipe& recipe) {
    const std::string json = json_text(kept(recipe));
    std::string text(marker);
    text.append(seal_length, '0');
    text += checksum_of(json);
    append_base64(text, json);
    return text += end_mark;
}

std::vector<std::string> recipe_lines(std::string_view text) {
    std::vector<std::string> lines;
    text.remove_prefix(std::min(marker.size(), text.size()));
    while (!text.empty()) {
        lines.push_back(std::string(marker).append(text.substr(0, line_length - marker.size())));
        text.remove_prefix(std::min(line_length - marker.size(), text.size()));
    }
    return lines;
}

namespace {

struct RecipeText {
    std::string text; ///< behind the marker, without its end
    std::size_t end = 0;
};

/// Puts the lines of a recipe together. @param begin  of the first marker
std::optional<RecipeText> text_at(std::string_view file, std::size_t begin) {
    RecipeText out;
    std::size_t at = begin + marker.size();
    while (out.text.size() <= longest_recipe) {
        const std::size_t first = at;
        while (at < file.size() && is_base64(file[at]) && at - first <= longest_recipe)
            ++at;
        out.text += file.substr(first, at - first);
        if (at < file.size() && file[at] == end_mark) {
            out.end = at + 1;
            return out;
        }
        const std::size_t next = file.substr(at, between_lines).find(marker);
        if (next == std::string_view::npos || at == first)
            return std::nullopt;
        at += next + marker.size();
    }
    return std::nullopt;
}

std::optional<FoundRecipe> recipe_of(const RecipeText& found, std::size_t begin) {
    if (found.text.size() < seal_length + sum_length)
        return std::nullopt;
    const std::string_view text = found.text;
    const auto json = base64_bytes(text.substr(seal_length + sum_length));
    if (!json || checksum_of(*json) != text.substr(seal_length, sum_length))
        return std::nullopt;
    auto recipe = parse_json(*json, {longest_recipe, 16}).and_then([](const nlohmann::json& value) {
        return parse_kept<Recipe>(value);
    });
    if (!recipe)
        return std::nullopt;
    FoundRecipe out{*std::move(recipe), begin, found.end, std::string(text.substr(0, seal_length)),
                    std::string(marker)};
    out.text.append(seal_length, '0').append(text.substr(seal_length)) += end_mark;
    return out;
}

} // namespace

std::size_t FoundRecipe::seal_begin() const {
    return begin + marker.size();
}

FoundRecipes find_recipes(std::string_view file) {
    FoundRecipes out;
    std::size_t at = 0;
    while (out.damaged < most_damaged && (at = file.find(marker, at)) != std::string_view::npos) {
        const auto text = text_at(file, at);
        auto found = text ? recipe_of(*text, at) : std::nullopt;
        at = found ? found->end : at + marker.size();
        if (found)
            out.sound.push_back(*std::move(found));
        else
            ++out.damaged;
    }
    return out;
}

} // namespace wakesurf::protocol
