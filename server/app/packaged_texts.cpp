#include "server/app/packaged_texts.hpp"

#include <CLI/CLI.hpp>

namespace wakesurf::server {

std::string_view manual_chapters() {
    return R"roff(.SH ENVIRONMENT
.TP
\fBWAKESURF_DATASET\fR, \fBWAKESURF_LISTEN\fR, \fBWAKESURF_STORE\fR, \fBWAKESURF_STATE\fR, \fBWAKESURF_TOKEN_FILE\fR
Defaults of what \fBwakesurf serve\fR takes by the option of that name.
.TP
\fBWAKESURF_URL\fR
Address of the server that \fBwakesurf sessions\fR, \fBwakesurf mcp\fR and scripts talk to.
.TP
\fBWAKESURF_HTTP_TOKEN\fR
Sent as a bearer\(aqs token to the web servers that stores are read from.
.TP
\fBWAKESURF_HTTP_S3_REGION\fR
Requests to them are signed for S3 in that region, with \fBAWS_ACCESS_KEY_ID\fR, \fBAWS_SECRET_ACCESS_KEY\fR and, where it is set,
\fBAWS_SESSION_TOKEN\fR.
.TP
\fBSSL_CERT_FILE\fR
Whom of them to trust, beside those whom the system trusts.
.TP
\fBBROWSER\fR
What opens the page, several with colons between them, \fI%s\fR for its address; else \fBxdg\-open\fR(1).
.TP
\fBWAKESURF_PYTHON\fR
The Python of \fBwakesurf mcp\fR, with numpy; else the system's.
.SH FILES
.TP
\fI~/.cache/wakesurf\fR
Imported data, unless \fB\-\-store\fR says otherwise. It can be deleted: it is made again from the simulation's files.
.TP
\fI../share/wakesurf/web\fR, \fI../share/wakesurf/data\fR
The page and the bundled simulation, as seen from the program.
.TP
\fI../share/wakesurf/python\fR
The client for scripts.
.SH EXIT STATUS
0 done, 1 failed, 2 wrong usage. What was wrong is on standard error, with what to do about it.
.SH EXAMPLES
.TP
The bundled simulation, in the browser
\fBwakesurf\fR
.TP
Own data, in the browser; by ssh it says what to type on your own machine
\fBwakesurf case.foam\fR
.TP
Own data, with sessions that outlive the server
\fBwakesurf serve case.foam \-\-state ~/.local/state/wakesurf\fR
.TP
From a laptop, where the server runs on another machine
\fBssh \-L 8080:localhost:8080 that.machine\fR
.TP
One surface to a file, without a server
\fBwakesurf surface case.foam \-\-kind streak \-o surface.vtp\fR
.SH SEE ALSO
\fBwakesurf\-import\fR(1), \fBparaview\fR(1)
)roff";
}

namespace {

/// Returns the words of a check by CLI::IsMember, which names them as {a,b,c}; empty for other checks.
std::string words_taken_by(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const auto open = type.find('{');
    const auto close = type.find('}', open);
    if (open == std::string::npos || close == std::string::npos)
        return {};
    std::string words = type.substr(open + 1, close - open - 1);
    for (char& letter : words)
        if (letter == ',')
            letter = ' ';
    return words;
}

/// Holds branches of the script's `case` statements; a path is the commands given so far, each after a space.
struct Branches {
    std::string known;   ///< paths, with | between them
    std::string offered; ///< by path: commands and options
    std::string taken;   ///< by path and option: the words it takes
};

/// Returns a command's options, each after a space; their values go to the branches.
std::string options_of(const CLI::App& command, const std::string& path, Branches& branches) {
    std::string options;
    for (const CLI::Option* each :
         command.get_options([](const CLI::Option* one) { return !one->get_group().empty(); })) {
        for (const std::string& name : each->get_lnames()) {
            options += "--" + name + " ";
            if (const std::string words = words_taken_by(*each); !words.empty())
                branches.taken += "    '" + path + " --" + name + "') words='" + words + "' ;;\n";
        }
        for (const std::string& name : each->get_snames())
            options += "-" + name + " ";
    }
    return options;
}

/// Adds the branches of a command and its subcommands. @param implied  the command whose options may be given
/// without it, or null
void add_branches(const CLI::App& command,
                  const std::string& path,
                  const CLI::App* implied,
                  Branches& branches) {
    std::string commands;
    for (const CLI::App* each :
         command.get_subcommands([](const CLI::App* one) { return !one->get_name().empty(); })) {
        const std::string below = path + " " + each->get_name();
        commands += each->get_name() + " ";
        branches.known += (branches.known.empty() ? "'" : " | '") + below + "'";
        add_branches(*each, below, nullptr, branches);
    }
    std::string options = options_of(command, path, branches);
    if (implied != nullptr)
        options += options_of(*implied, path, branches);
    branches.offered +=
        "    '" + path + "') commands='" + commands + "' options='" + options + "' ;;\n";
}

} // namespace

std::string bash_completion(const CLI::App& program, const CLI::App* implied) {
    Branches branches;
    add_branches(program, "", implied, branches);
    return R"bash(# bash completion of wakesurf, made by `wakesurf --bash-completion`.
_wakesurf() {
    local current=${COMP_WORDS[COMP_CWORD]} path='' previous='' commands='' options='' words='' i
    [ "$COMP_CWORD" -lt 1 ] || previous=${COMP_WORDS[COMP_CWORD - 1]}
    for ((i = 1; i < COMP_CWORD; i++)); do
        case "$path ${COMP_WORDS[i]}" in
)bash"
           "        " +
           branches.known +
           R"bash() path="$path ${COMP_WORDS[i]}" ;;
        esac
    done
    case $path in
)bash" + branches.offered +
           R"bash(    esac
    case "$path $previous" in
)bash" + branches.taken +
           R"bash(    esac
    COMPREPLY=()
    if [ -n "$words" ]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    elif [[ $current == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    elif [ -n "$commands" ]; then
        mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current")
    fi # else the default of `complete`: files
}
complete -o default -F _wakesurf wakesurf
)bash";
}

} // namespace wakesurf::server
