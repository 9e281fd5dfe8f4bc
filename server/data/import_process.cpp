#include "server/data/import_process.hpp"

#include "core/base/machine_memory.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/dataset_json.hpp"
#include "server/base/shipped_files.hpp"
#include "server/data/child_process.hpp"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string_view>

namespace wakesurf::server {

using core::Error;

namespace {

constexpr std::string_view program_name = "wakesurf-import";

/// A file that was changed so recently may still grow.
constexpr std::chrono::seconds still_written{5};

constexpr int deepest_folder = 3;
constexpr int most_files = 20'000;

bool within_a_name(std::string_view text, std::size_t at) {
    const auto alphanumeric = [&](std::size_t i) {
        return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])) != 0;
    };
    if (at >= text.size())
        return false;
    return alphanumeric(at) || text[at] == '_' || text[at] == '-' ||
           (text[at] == '.' && alphanumeric(at + 1));
}

bool speaks_of(std::string_view words, std::string_view name) {
    for (auto at = words.find(name); at != std::string_view::npos; at = words.find(name, at + 1))
        if ((at == 0 || !within_a_name(words, at - 1)) && !within_a_name(words, at + name.size()))
            return true;
    return false;
}

bool speaks_of_a_part(const std::string& words, const std::filesystem::path& file) {
    for (const auto& part : file)
        if (speaks_of(words, part.string()))
            return true;
    return false;
}

/// Returns the name of a file in the source's folder, or three folders below, that `words` (of a reader)
/// name and that was changed within the last `still_written`: what cannot be read of it is not damage. A
/// time folder of a case stands for the files in it.
std::optional<std::string> file_being_written(const std::filesystem::path& source,
                                              const std::string& words) {
    std::error_code error;
    std::filesystem::path folder =
        std::filesystem::is_directory(source, error) ? source : source.parent_path();
    if (folder.empty())
        folder = ".";
    const auto since = std::filesystem::file_time_type::clock::now() - still_written;
    int seen = 0;
    for (std::filesystem::recursive_directory_iterator entry(folder, error), end;
         !error && entry != end && seen < most_files; entry.increment(error), ++seen) {
        if (entry.depth() >= deepest_folder)
            entry.disable_recursion_pending();
        std::error_code unknown;
        const auto changed = std::filesystem::last_write_time(entry->path(), unknown);
        if (unknown || changed < since || !entry->is_regular_file(unknown))
            continue;
        const auto name = entry->path().lexically_relative(folder);
        if (speaks_of_a_part(words, name))
            return name.string();
    }
    return std::nullopt;
}

std::filesystem::path program_of(const ImportCommand& command) {
    if (!command.program.empty())
        return command.program;
    return this_program().parent_path() / program_name;
}

std::vector<std::string> arguments_of(const ImportCommand& command) {
    std::vector<std::string> arguments;
    if (!command.fields.empty()) {
        std::string names;
        for (const auto& field : command.fields)
            names += (names.empty() ? "" : ",") + field;
        arguments.push_back("--fields=" + names);
    }
    if (!command.times.empty())
        arguments.push_back("--times=" + command.times);
    if (!command.precision.empty())
        arguments.push_back("--precision=" + command.precision);
    if (!command.layout.empty())
        arguments.push_back("--layout=" + command.layout);
    if (command.jobs > 0)
        arguments.push_back("--jobs=" + std::to_string(command.jobs));
    if (command.memory > 0)
        arguments.push_back("--memory=" + std::to_string(command.memory));
    if (command.growing)
        arguments.emplace_back("--growing");
    if (command.library_words)
        arguments.emplace_back("--told-to-others");
    for (const auto& secret : command.secrets)
        arguments.push_back("--secret=" + secret.string());
    for (auto& argument : arguments_of(command.taken))
        arguments.push_back(std::move(argument));
    return arguments;
}

// Returns the machine's memory, so that a file which claims to be enormous fails instead of swapping
// everything out.
std::size_t address_space() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return 0; // the sanitizers' shadow memory takes terabytes of addresses
#else
    const std::size_t memory = core::machine_memory();
    constexpr std::size_t libraries = std::size_t{2} << 30;
    return memory > 0 ? memory + libraries : 0;
#endif
}

// Returns the rest of the last line that begins with `prefix`.
std::string last_words(const std::string& errors, std::string_view prefix) {
    std::string words;
    for (std::size_t start = 0; start < errors.size();) {
        const auto end = std::min(errors.find('\n', start), errors.size());
        if (errors.compare(start, prefix.size(), prefix) == 0)
            words = errors.substr(start + prefix.size(), end - start - prefix.size());
        start = end + 1;
    }
    return words;
}

bool speaks_of_damage(const std::string& words) {
    constexpr std::array<std::string_view, 8> signs{
        "damaged", "truncated",      "is empty",     "incomplete",
        "cut off", "does not exist", "is not there", "cannot be read"};
    return words.find("of a format that") == std::string::npos &&
           std::any_of(signs.begin(), signs.end(), [&](std::string_view sign) {
               return words.find(sign) != std::string::npos;
           });
}

Error error_of(const ImportCommand& command, int status, const std::string& words) {
    if (words.empty())
        return {Error::Code::Corrupt, "the importer failed and did not say why", {}};
    const auto file = status == 1 && speaks_of_damage(words)
                          ? file_being_written(command.source, words)
                          : std::nullopt;
    if (file)
        return {Error::Code::Corrupt, words,
                *file + " was changed less than " + std::to_string(still_written.count()) +
                    " s ago: if it is still being written, try again when it is complete"};
    if (words.find("an import may take ") != std::string::npos)
        return {Error::Code::OverLimit, words, {}, {}, command.memory};
    return {status == 2 ? Error::Code::InvalidArgument : Error::Code::Corrupt, words, {}};
}

core::Result<void>
judge(const ImportCommand& command, const ChildOutcome& outcome, const std::stop_token& stop) {
    if (stop.stop_requested())
        return core::fail(Error::Code::Cancelled, "the import was interrupted",
                          "the next import of this source resumes where it ended");
    if (outcome.signal != 0)
        return core::fail(Error::Code::Io,
                          "the importer was killed (signal " + std::to_string(outcome.signal) + ")",
                          outcome.signal == SIGKILL
                              ? "someone killed it, or the machine ran out of memory"
                              : "this is a fault of wakesurf or of a library; run wakesurf-import "
                                "by hand to see more");
    if (outcome.exit_status == 0)
        return {};
    return tl::unexpected(
        error_of(command, outcome.exit_status, last_words(outcome.errors, "wakesurf-import: ")));
}

/// @param instead  what is done with the source instead of writing a store; else empty
core::Result<void> run(const ImportCommand& command,
                       const std::string& instead,
                       const std::function<void(std::string_view)>& line,
                       const std::stop_token& stop) {
    auto arguments = arguments_of(command);
    arguments.push_back("--parent=" + std::to_string(::getpid()));
    if (!instead.empty())
        arguments.push_back(instead);
    arguments.emplace_back("--"); // a path that begins with a dash is still a path
    arguments.push_back(command.source.string());
    if (instead.empty())
        arguments.push_back(command.store.string());
    return run_child(program_of(command), arguments, address_space(), line, stop)
        .and_then([&](const ChildOutcome& outcome) {
            const auto words = last_words(outcome.errors, "library: ");
            if (command.library_words && !words.empty())
                command.library_words(words);
            return judge(command, outcome, stop);
        });
}

} // namespace

core::Result<void>
run_import_process(const ImportCommand& command,
                   const std::function<void(const store::ImportProgress&)>& listener,
                   std::stop_token stop) {
    const auto line = [&](std::string_view text) {
        if (const auto progress = store::parse_progress_line(text))
            listener(*progress);
    };
    return run(command, {}, line, stop);
}

core::Result<core::DatasetInfo> describe_with_import_process(const ImportCommand& command,
                                                             std::stop_token stop) {
    constexpr protocol::JsonLimits limits{std::size_t{64} << 20, 16};
    std::string text;
    const auto line = [&](std::string_view part) {
        if (text.size() <= limits.bytes) // more is refused below
            text.append(part).append("\n");
    };
    if (auto described = run(command, "--describe", line, stop); !described)
        return tl::unexpected(described.error());
    return protocol::parse_json(text, limits).and_then(protocol::parse_kept<core::DatasetInfo>);
}

core::Result<std::vector<core::Vec3>>
read_rake_with_import_process(const std::filesystem::path& file, bool separate) {
    std::vector<core::Vec3> points;
    const auto line = [&](std::string_view text) {
        std::array<double, 3> xyz{};
        for (double& each : xyz) {
            const auto read = std::from_chars(text.data(), text.data() + text.size(), each);
            text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
            text.remove_prefix(text.starts_with(','));
        }
        points.emplace_back(xyz[0], xyz[1], xyz[2]);
    };
    ImportCommand command;
    command.source = file;
    return run(command, separate ? "--rake=points" : "--rake=line", line, {}).map([&] {
        return std::move(points);
    });
}

} // namespace wakesurf::server
