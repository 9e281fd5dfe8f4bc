#include "server/app/name_mapping.hpp"

#include "protocol/api/base/methods.hpp"
#include "protocol/api/generated/surface_options.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace wakesurf::server {

namespace {

constexpr std::array<CommandOfMethod, 13> known_commands{{
    {"dataset.describe", "wakesurf info"},
    {"dataset.open", "wakesurf import"},
    {"family.make", "wakesurf family"},
    {"family.remove", "wakesurf family --remove"},
    {"mean.make", "wakesurf means"},
    {"mean.remove", "wakesurf means --remove"},
    {"surface.set", "wakesurf surface"},
    {"session.list", "wakesurf sessions list"},
    {"session.rename", "wakesurf sessions rename"},
    {"session.export", "wakesurf sessions export"},
    {"session.import", "wakesurf sessions import"},
    {"session.delete", "wakesurf sessions delete"},
    {"session.restore", "wakesurf sessions restore"},
}};

/// Parameters whose options are declared here, beside those made from the description of surface.set.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> more_options{{
    {"maxQuads", "--max-quads"},
    {"fields", "--fields"},
    {"tessellate", "--tessellate"},
}};

using Spelling = std::function<std::optional<std::string>(std::string_view name)>;

/// Replaces each name in backticks that `spelt` knows, backticks included.
std::string spell(std::string_view text, const Spelling& spelt) {
    std::string out;
    while (true) {
        const auto begin = text.find('`');
        const auto end = begin == text.npos ? text.npos : text.find('`', begin + 1);
        if (end == text.npos)
            return out.append(text);
        const auto words = spelt(text.substr(begin + 1, end - begin - 1));
        out.append(text.substr(0, begin));
        out.append(words ? std::string_view(*words) : text.substr(begin, end + 1 - begin));
        text.remove_prefix(end + 1);
    }
}

std::optional<std::string> command_of(std::string_view method) {
    for (const CommandOfMethod& each : known_commands)
        if (each.method == method)
            return '`' + std::string(each.command) + '`';
    return std::nullopt;
}

std::optional<std::string> option_of(std::string_view parameter) {
    for (const auto& [name, option] : more_options)
        if (name == parameter)
            return std::string(option);
    for (const protocol::SurfaceOption& each : protocol::surface_options)
        if (each.parameter == parameter)
            return each.option;
    return std::nullopt;
}

} // namespace

std::span<const CommandOfMethod> commands_of_methods() {
    return known_commands;
}

core::Error with_commands(core::Error error) {
    bool leads_nowhere = false;
    error.message = spell(error.message, command_of);
    error.hint = spell(error.hint, [&](std::string_view name) {
        auto command = command_of(name);
        leads_nowhere = leads_nowhere || (!command && protocol::described_method(name) != nullptr);
        return command;
    });
    if (leads_nowhere)
        error.hint.clear();
    return error;
}

core::Error with_options(core::Error error) {
    error.message = spell(error.message, option_of);
    error.hint = spell(error.hint, option_of);
    return error;
}

} // namespace wakesurf::server
