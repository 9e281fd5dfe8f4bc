#include "protocol/files/mesh_metadata.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/files/recipe.hpp"

#include <cctype>

namespace wakesurf::protocol {

namespace {

std::string word(const std::string& name) {
    std::string out;
    for (const char c : name)
        out += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return out.empty() ? "_" : out;
}

std::string capitals(const std::string& name) {
    std::string out = "_";
    for (const char c : word(name))
        out += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return out;
}

template <class Spelling>
std::vector<std::string>
spelt(const MeshScalars& scalars, std::set<std::string> taken, Spelling spelling) {
    std::vector<std::string> out;
    for (const auto& [name, values] : scalars) {
        const std::string first = spelling(name);
        std::string free = first;
        for (int number = 2; !taken.insert(free).second; ++number)
            free = first + "_" + std::to_string(number);
        out.push_back(free);
    }
    return out;
}

} // namespace

std::map<std::string, double> stated_errors(const core::SurfaceStatistics& statistics) {
    std::map<std::string, double> out;
    if (statistics.error)
        out["error99"] = statistics.error->error99;
    if (statistics.interval_error) {
        out["intervalError99"] = statistics.interval_error->error99;
        out["intervalUnresolved"] = statistics.interval_error->unresolved;
    }
    return out;
}

std::vector<std::string> one_word_names(const MeshScalars& scalars, std::set<std::string> taken) {
    return spelt(scalars, std::move(taken), word);
}

std::vector<std::string> gltf_names(const MeshScalars& scalars, std::set<std::string> taken) {
    return spelt(scalars, std::move(taken), capitals);
}

namespace {

std::string points_text(const std::vector<core::Vec3>& points) {
    std::string out;
    for (const core::Vec3& p : points)
        out += (out.empty() ? "" : " ") + number_text(p.x) + "," + number_text(p.y) + "," +
               number_text(p.z);
    return out;
}

std::string printable(std::string text) {
    for (char& c : text)
        if (std::iscntrl(static_cast<unsigned char>(c)) != 0)
            c = ' ';
    return text;
}

} // namespace

std::vector<std::string> mesh_lines(const MeshMetadata& metadata) {
    std::vector<std::string> lines{"wakesurf " + printable(metadata.version),
                                   "kind " + std::string(name(metadata.parameters.kind)),
                                   "dataset " + printable(metadata.dataset)};
    lines.push_back(metadata.parameters.field ? "field " + printable(*metadata.parameters.field)
                                              : "rake " + points_text(metadata.rake.points));
    if (!metadata.parameters.field && tells_kind(metadata.rake.kind))
        lines.push_back("rakeKind " + std::string(name(metadata.rake.kind)));
    if (metadata.parameters.rake2)
        lines.push_back("rake2 " + points_text(metadata.parameters.rake2->points));
    if (metadata.parameters.rake2 && tells_kind(metadata.parameters.rake2->kind))
        lines.push_back("rake2Kind " + std::string(name(metadata.parameters.rake2->kind)));
    if (metadata.parameters.sweep)
        lines.push_back("sweep " + points_text({*metadata.parameters.sweep}));
    lines.push_back("from " + number_text(metadata.parameters.from));
    lines.push_back("to " + number_text(metadata.parameters.to));
    if (metadata.time)
        lines.push_back("time " + number_text(*metadata.time));
    for (const auto& [name, value] : given_numbers(metadata.parameters))
        lines.push_back(std::string(name) + " " + number_text(value));
    lines.push_back("separation " + number_text(metadata.separation));
    if (metadata.tessellate > 1)
        lines.push_back("tessellate " + std::to_string(metadata.tessellate));
    for (const auto& [name, value] : metadata.errors)
        lines.push_back(name + " " + number_text(value));
    if (!metadata.stopped.empty())
        lines.push_back("stopped " + printable(metadata.stopped));
    return lines;
}

std::string mesh_comments(const MeshMetadata& metadata, std::string_view word) {
    std::string out;
    for (const auto& lines : {recipe_lines(metadata.recipe), mesh_lines(metadata)})
        for (const std::string& line : lines)
            ((out += word) += line) += '\n';
    return out;
}

} // namespace wakesurf::protocol
