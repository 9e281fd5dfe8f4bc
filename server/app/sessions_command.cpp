#include "protocol/api/base/json_text.hpp"
#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/environment.hpp"
#include "server/app/output_files.hpp"
#include "server/app/session_server.hpp"
#include "server/base/limits.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace wakesurf::server {

using core::Error;
using core::fail;
using nlohmann::json;

namespace {

core::Result<std::unique_ptr<SessionServer>> find_server(const SessionsOptions& options) {
    const bool changes = options.action != "list" && options.action != "export";
    if (!options.state.empty())
        return sessions_in(options.state, changes);
    if (const std::string url =
            options.url.empty() ? from_environment("WAKESURF_URL") : options.url;
        !url.empty())
        return server_at(url, options.authority);
    if (const std::string state = from_environment("WAKESURF_STATE"); !state.empty())
        return sessions_in(state, changes);
    return fail(Error::Code::InvalidArgument, "neither a server nor a folder of sessions is named",
                "give --url (or WAKESURF_URL) with the address of a running server, "
                "http://HOST:PORT/#token=..., or --state with a folder that no server uses");
}

/// Returns an error with the server's words.
tl::unexpected<Error> fault_of(const json& answer, unsigned status) {
    const auto text = [](const json& value, const char* name) {
        return value.is_object() && value.contains(name) && value[name].is_string()
                   ? value[name].get<std::string>()
                   : std::string();
    };
    const json error = answer.is_object() && answer.contains("error") ? answer["error"] : json();
    const json data = error.is_object() && error.contains("data") ? error["data"] : json();
    std::string message = text(error, "message");
    if (message.empty())
        message = fmt::format("the answer (status {}) did not come from wakesurf", status);
    return fail(Error::Code::Io, std::move(message), text(data, "hint"));
}

core::Result<json> parsed(const core::Result<SessionServer::Answer>& answer) {
    if (!answer)
        return tl::unexpected(answer.error());
    constexpr protocol::JsonLimits most{4 * limits::session_file_bytes, 48};
    auto value = protocol::parse_json(answer->body, most);
    if (!value || answer->status != 200 || value->contains("error"))
        return fault_of(value ? *value : json(), answer->status);
    return std::move(*value);
}

core::Result<json> call(SessionServer& server, const std::string& method, const json& parameters) {
    const json message{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", parameters}};
    return parsed(server.ask("POST", "/rpc", message.dump())).map([](json&& answer) {
        return answer["result"];
    });
}

/// Pads a text to a width; a character of UTF-8 counts as one.
std::string padded(const std::string& given, std::size_t width) {
    std::string text = core::printable_line(given);
    std::size_t length = 0;
    for (const char c : text)
        length += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    text.append(width > length ? width - length : 0, ' ');
    return text;
}

/// Prints the most recently used first.
void print(const json& list, bool trash) {
    auto sessions = list["sessions"].get<std::vector<json>>();
    std::sort(sessions.begin(), sessions.end(),
              [](const json& a, const json& b) { return a["lastUsed"] > b["lastUsed"]; });
    tell("{}  {}  {}  {}\n", padded("SESSION", 12), padded("NAME", 32),
         padded(trash ? "GONE FOR GOOD" : "LAST USED", 20), "WHAT AND WHO");
    for (const json& each : sessions) {
        std::string people;
        for (const json& person : each["people"])
            people += (people.empty() ? "" : ", ") + person["name"].get<std::string>();
        const std::string what =
            fmt::format("{} rakes, {} surfaces, {} notes, {} views{}{}", each["rakes"].get<int>(),
                        each["surfaces"].get<int>(), each["annotations"].get<int>(),
                        each["bookmarks"].get<int>(), people.empty() ? "" : "; ", people);
        tell("{}  {}  {}  {}\n", padded(each["session"], 12), padded(each["name"], 32),
             padded(each[trash ? "deletedUntil" : "lastUsed"], 20), what);
    }
    tell("{} of {}\n", sessions.size(), list[trash ? "trashLimit" : "limit"].get<std::size_t>());
}

core::Result<void> list(SessionServer& server, const SessionsOptions& options) {
    return call(server, "session.list", {{"trash", options.trash}}).map([&](const json& answer) {
        if (options.json)
            tell("{}\n", protocol::json_text(answer, 1));
        else
            print(answer, options.trash);
    });
}

core::Result<void> export_session(SessionServer& server, const SessionsOptions& options) {
    const std::string& id = options.session;
    if (id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos)
        return fail(Error::Code::NotFound, "there is no session `" + id + "`",
                    "`wakesurf sessions list` lists them");
    const std::string file = options.file.empty() ? id + ".session.json" : options.file;
    std::error_code ignored;
    if (!options.overwrite && std::filesystem::exists(file, ignored))
        return fail(Error::Code::InvalidArgument, file + " already exists",
                    "name another file with -o, or give --overwrite");
    auto answer = server.ask("GET", "/api/v1/sessions/" + id + "/session.json", "");
    if (const auto sound = parsed(answer); !sound)
        return tl::unexpected(sound.error());
    return write_whole_file(file, answer->body).map([&] { tell("{}\n", file); });
}

core::Result<void> import(SessionServer& server, const SessionsOptions& options) {
    std::ifstream stream(options.file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream)
        return fail(Error::Code::Io, "cannot read " + options.file,
                    "name a file that `wakesurf sessions export` wrote");
    const auto made = parsed(server.ask("POST", "/api/v1/sessions", text.str()));
    if (!made)
        return tl::unexpected(made.error());
    if (!options.name.empty())
        if (const auto named = call(server, "session.rename",
                                    {{"session", (*made)["session"]}, {"name", options.name}});
            !named)
            return tl::unexpected(named.error());
    for (const json& note : (*made)["notes"])
        tell(stderr, "wakesurf: {}\n", note.get<std::string>());
    tell("{}\n", (*made)["session"].get<std::string>());
    return {};
}

core::Result<void> rename(SessionServer& server, const SessionsOptions& options) {
    return call(server, "session.rename", {{"session", options.session}, {"name", options.name}})
        .map([](const json&) {});
}

core::Result<void> remove(SessionServer& server, const SessionsOptions& options) {
    return call(server, "session.delete",
                {{"session", options.session}, {"forever", options.forever}})
        .map([](const json& answer) {
            if (answer.contains("deletedUntil"))
                tell("in the trash until {}\n", answer["deletedUntil"].get<std::string>());
        });
}

core::Result<void> restore(SessionServer& server, const SessionsOptions& options) {
    return call(server, "session.restore", {{"session", options.session}}).map([](const json&) {});
}

} // namespace

void add_sessions_options(CLI::App& command, SessionsOptions& options) {
    command.require_subcommand(1);
    auto* const url = command.add_option(
        "--url", options.url, "address that a running server printed (default: $WAKESURF_URL)");
    command
        .add_option("--state", options.state,
                    "or: folder of sessions that no server uses "
                    "(default: $WAKESURF_STATE, without a --url)")
        ->excludes(url);
    command
        .add_option("--ca", options.authority,
                    "PEM certificate of the authority that signed the server's, if the system does "
                    "not trust it")
        ->check(CLI::ExistingFile);
    const auto action = [&](const char* name, const char* about) {
        CLI::App* const added = command.add_subcommand(name, about);
        added->fallthrough();
        added->callback([&options, name] { options.action = name; });
        return added;
    };
    const auto on_session = [&](const char* name, const char* about) {
        CLI::App* const added = action(name, about);
        added->add_option("SESSION", options.session, "its id, from `list`")->required();
        return added;
    };
    auto* const listing = action("list", "List the sessions: who used them, and when");
    listing->add_flag("--trash", options.trash, "list the deleted ones");
    listing->add_flag("--json", options.json,
                      "print them as JSON, as the method `session.list` does");
    on_session("rename", "Rename a session")
        ->add_option("NAME", options.name, "its new name")
        ->required();
    auto* const saving = on_session("export", "Save a session to a file");
    saving->add_option("-o,--output", options.file,
                       "file to write (default: SESSION.session.json)");
    saving->add_flag("--overwrite", options.overwrite, "replace an existing file");
    auto* const reading = action("import", "Create a session from a saved file");
    reading->add_option("FILE", options.file, "a file that `export` wrote")->required();
    reading->add_option("--name", options.name, "name of the session (default: the file's)");
    on_session("delete", "Move a session to the trash for 30 days")
        ->add_flag("--forever", options.forever, "delete it from the trash permanently");
    on_session("restore", "Restore a session from the trash");
}

int run_sessions(const SessionsOptions& options) {
    // Standard output has the answer; sessions of a state folder would log like a server.
    log_to_standard_error("warning");
    auto server = find_server(options);
    if (!server)
        return report_refusal(server.error());
    const auto done = options.action == "list"     ? list(**server, options)
                      : options.action == "rename" ? rename(**server, options)
                      : options.action == "export" ? export_session(**server, options)
                      : options.action == "import" ? import(**server, options)
                      : options.action == "delete" ? remove(**server, options)
                                                   : restore(**server, options);
    return done ? 0 : report_failure(done.error());
}

} // namespace wakesurf::server
