#include "core/base/plain_text.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/utc_text.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/sessions/journal/state_copy.hpp"

#include <CLI/CLI.hpp>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <ctime>

namespace wakesurf::server {

using nlohmann::json;

namespace {

constexpr int all_sound = 0;
constexpr int failed = 1;

std::string counts(const StateContent& content) {
    return fmt::format("{} record{} of {} session{}", content.records(),
                       content.records() == 1 ? "" : "s", content.sessions.size(),
                       content.sessions.size() == 1 ? "" : "s");
}

void print_aside(const StateContent& content) {
    for (const auto* rows : {&content.aside, &content.damaged})
        for (const AsideRow& each : *rows)
            tell("    {}: {} (since {:%Y-%m-%d})\n", each.session, each.label.why,
                 fmt::gmtime(static_cast<std::time_t>(each.label.since)));
}

int check(const StateCommandOptions& options) {
    const auto verdict = check_state(options.folder);
    if (!verdict)
        return report_failure(verdict.error());
    const StateContent& content = verdict->content;
    const std::size_t damaged = content.damaged.size();
    if (content.layout == 0 && !verdict->fault)
        tell("sound: nothing is stored there yet\n");
    else
        tell("{}: {}\n",
             verdict->fault ? "damaged; what can be read"
             : damaged > 0  ? fmt::format("{} record{} damaged; sound", damaged,
                                         damaged == 1 ? " is" : "s are")
                            : "sound",
             counts(content));
    if (content.layout > 0)
        tell("  layout      {}{}\n", content.layout,
             content.head.writer.empty() ? "" : ", written by wakesurf " + content.head.writer);
    tell("  kept aside  {}\n", content.aside.size() + damaged);
    print_aside(content);
    if (verdict->fault)
        return report_failure(*verdict->fault);
    return damaged > 0 ? failed : all_sound;
}

/// Returns JSON as it is, so that it can be corrected and set again; anything else as text.
json record_of(const std::string& text) {
    return protocol::parse_json(text, {text.size()}).value_or(json(text));
}

/// Lists the records set aside, also of a damaged state: that is when users look for them.
int aside(const StateCommandOptions& options) {
    const auto verdict = check_state(options.folder);
    if (!verdict)
        return report_failure(verdict.error());
    json records = json::array();
    for (const auto* rows : {&verdict->content.aside, &verdict->content.damaged})
        for (const AsideRow& each : *rows)
            records.push_back({{"session", each.session},
                               {"type", each.label.type},
                               {"id", each.label.id},
                               {"why", each.label.why},
                               {"since", protocol::utc_text(std::clamp<std::int64_t>(
                                             each.label.since, 0, protocol::last_utc_second))},
                               {"record", record_of(each.json)}});
    const json all{{"wakesurfKeptAside", 1}, {"records", std::move(records)}};
    tell("{}\n", protocol::json_text(all, 2));
    return all_sound;
}

int backup(const StateCommandOptions& options) {
    const auto made = back_up_state(options.folder, options.file);
    if (!made)
        return report_failure(made.error());
    tell("backed up: {}, {} kept aside\n", counts(*made), made->aside.size());
    return all_sound;
}

int restore(const StateCommandOptions& options) {
    const auto restored = restore_state(options.folder, options.file, options.damaged);
    if (!restored)
        return report_failure(restored.error());
    const StateContent& content = restored->content;
    tell("restored: {}, {} kept aside\n", counts(content),
         content.aside.size() + content.damaged.size());
    if (restored->made_folder)
        tell("  into a new folder, which was not there: {}\n",
             core::printable_line(options.folder));
    for (const std::string& fault : content.faults)
        tell("  not restored: {}\n", fault);
    if (!restored->replaced.empty())
        tell("  the previous sessions are {} in that folder\n", restored->replaced);
    return all_sound;
}

} // namespace

void add_state_commands(CLI::App& command,
                        StateCommandOptions& options,
                        std::function<int()>& chosen) {
    command.require_subcommand(1);
    const auto add = [&](const char* name, const char* about,
                         int (*run)(const StateCommandOptions&)) {
        CLI::App* const added = command.add_subcommand(name, about);
        added->add_option("STATE_DIR", options.folder, "The folder given to `serve --state`")
            ->required();
        added->callback([&, run] { chosen = [&options, run] { return run(options); }; });
        return added;
    };
    add("check", "Check that everything saved is intact, and count it; changes nothing", check);
    add("aside", "Print as JSON the records the server could not use; works while it runs", aside);
    add("backup", "Copy the sessions to one file; works while the server runs", backup)
        ->add_option("FILE", options.file, "File to create; an existing file is never overwritten")
        ->required();
    CLI::App* const back =
        add("restore", "Replace the sessions by a backup; the old ones stay beside it", restore);
    back->add_option("FILE", options.file, "A backup, or any sessions.sqlite")->required();
    back->add_flag("--damaged", options.damaged, "Restore what can be read of a damaged file");
}

} // namespace wakesurf::server
