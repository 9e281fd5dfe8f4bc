#include "store/command/manual_page.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <vector>

namespace wakesurf::command {

namespace {

std::string upper_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    return text;
}

std::string bold(const std::string& text) {
    return "\\fB" + roff_of(text) + "\\fR";
}

std::string names_of(const CLI::Option& option) {
    if (option.get_positional())
        return bold(option.get_name(true));
    std::string all;
    for (const std::string& name : option.get_snames())
        all += (all.empty() ? "" : ", ") + bold("-" + name);
    for (const std::string& name : option.get_lnames())
        all += (all.empty() ? "" : ", ") + bold("--" + name);
    return all;
}

std::string value_of(const CLI::Option& option) {
    std::string value;
    if (const std::string type = option.get_type_name(); !type.empty() && !option.get_positional())
        value = " \\fI" + roff_of(type) + "\\fR";
    if (!option.get_default_str().empty())
        value += roff_of(" (default: " + option.get_default_str() + ")");
    if (option.get_required())
        value += " (required)";
    return value;
}

std::vector<const CLI::Option*> shown_options(const CLI::App& command, bool positional) {
    return command.get_options([positional](const CLI::Option* each) {
        return !each->get_group().empty() && each->get_positional() == positional;
    });
}

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App* each) {
        return !each->get_name().empty() && !each->get_group().empty();
    });
}

std::string usage_of(const CLI::App& command, const std::string& path) {
    std::string usage = bold(path);
    if (!shown_options(command, false).empty())
        usage += " [\\fIoptions\\fR]";
    for (const CLI::Option* each : shown_options(command, true)) {
        const std::string name =
            roff_of(each->get_name(true)) + (each->get_expected_max() > 1 ? " ..." : "");
        usage += each->get_required() ? " \\fI" + name + "\\fR" : " [\\fI" + name + "\\fR]";
    }
    if (!commands_of(command).empty())
        usage += " \\fIcommand\\fR ...";
    return usage;
}

std::string arguments_and_options(const CLI::App& command) {
    std::string text;
    for (const bool positional : {true, false})
        for (const CLI::Option* each : shown_options(command, positional))
            text += ".TP\n" + names_of(*each) + value_of(*each) + "\n" +
                    roff_of(each->get_description()) + "\n";
    return text;
}

std::string chapter_of(const CLI::App& command, const std::string& path) {
    std::string text = ".SS " + roff_of(path) + "\n" + roff_of(command.get_description()) +
                       ".\n.PP\n" + usage_of(command, path) + "\n" + arguments_and_options(command);
    for (const CLI::App* each : commands_of(command))
        text += chapter_of(*each, path + " " + each->get_name());
    return text;
}

} // namespace

std::string roff_of(std::string_view text) {
    std::string out;
    bool begins_line = true;
    for (const char letter : text) {
        if (begins_line && (letter == '.' || letter == '\''))
            out += "\\&";
        if (letter == '\\')
            out += "\\e";
        else if (letter == '-')
            out += "\\-";
        else
            out += letter;
        begins_line = letter == '\n';
    }
    return out;
}

std::string manual_page(const CLI::App& program, const ManualPage& page) {
    const std::string name = program.get_name();
    std::string about = program.get_description();
    if (about.ends_with('.'))
        about.pop_back();
    std::string text = ".TH " + upper_case(roff_of(name)) + " 1 \"\" \"wakesurf " +
                       std::string(page.version) + "\" \"User Commands\"\n.SH NAME\n" +
                       roff_of(name) + " \\- " + roff_of(about) + "\n.SH SYNOPSIS\n" +
                       usage_of(program, name) + "\n";
    if (const std::string more = program.get_footer(); !more.empty())
        text += ".PP\n" + roff_of(more) + "\n";
    text += ".SH OPTIONS\n" + arguments_and_options(program);
    if (const auto commands = commands_of(program); !commands.empty()) {
        text += ".SH COMMANDS\n";
        for (const CLI::App* each : commands)
            text += chapter_of(*each, name + " " + each->get_name());
    }
    return text + std::string(page.chapters);
}

} // namespace wakesurf::command
