#include "server/app/implied_command.hpp"

#include "protocol/api/base/nearest_name.hpp"
#include "server/data/dataset_argument.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>

namespace wakesurf::server {

namespace {

std::vector<std::string> command_names(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* each : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    return names;
}

/// Commands consist of letters and dashes; files have dots, folders slashes, flows a colon.
bool looks_like_command(const std::string& word) {
    return word.find_first_of("./:") == std::string::npos;
}

} // namespace

core::Result<CommandWords> with_command(const CLI::App& program, std::vector<std::string> words) {
    const auto as_serve = [&words] {
        words.insert(words.begin(), "serve");
        return CommandWords{std::move(words), true};
    };
    if (words.empty())
        return as_serve();
    const std::string first = words.front();
    if (first.starts_with('-')) {
        const bool known = program.get_option_no_throw(first) != nullptr;
        return known ? CommandWords{std::move(words), false} : as_serve();
    }
    const auto names = command_names(program);
    if (std::find(names.begin(), names.end(), first) != names.end())
        return CommandWords{std::move(words), false};
    if (const auto there = resolve_dataset(first);
        there || there.error().code != core::Error::Code::NotFound || !looks_like_command(first))
        return as_serve(); // which explains the error
    const std::string meant = protocol::nearest_name(first, names);
    return core::fail(core::Error::Code::InvalidArgument,
                      "`" + first + "` is no command, and there is no file or folder of this name",
                      meant.empty() ? "wakesurf --help lists the commands"
                                    : "did you mean `wakesurf " + meant + "`?");
}

} // namespace wakesurf::server
