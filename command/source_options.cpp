#include "command/source_options.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace wakesurf::command {

namespace {

// Returns the shortest text that reads back as `value`.
std::string number_text(double value) {
    std::array<char, 40> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

CLI::Validator finite(bool positive) {
    return CLI::Validator(
        [positive](std::string& text) {
            double value = 0.0;
            const auto [end, error] =
                std::from_chars(text.data(), text.data() + text.size(), value);
            const bool number = error == std::errc() && end == text.data() + text.size() &&
                                std::isfinite(value) && (!positive || value > 0.0);
            return number ? std::string()
                          : "'" + text + "' is not a " + (positive ? "positive " : "") + "number";
        },
        positive ? "POSITIVE" : "NUMBER");
}

} // namespace

void add_source_options(CLI::App& command, SourceOptions& options) {
    command.add_option("--velocity", options.velocity,
                       "The velocity, where it is not to be found by its name: one vector, three "
                       "scalars U,V,W, or a momentum and its density M,RHO");
    command.add_flag("--alone", options.alone,
                     "Only the file that DATASET names, not the numbered files beside it");
    command
        .add_option("--dt", options.dt,
                    "Time from one numbered file to the next, where the files state no times")
        ->check(finite(true));
    command.add_option("--start", options.start, "Time of the first of such files (default: 0)")
        ->check(finite(false));
    command.add_flag("--confined", options.confined,
                     "Refuse files that DATASET names outside of its folder: for data of people "
                     "you do not trust");
}

std::vector<std::string> arguments_of(const SourceOptions& options) {
    std::vector<std::string> out;
    if (!options.velocity.empty())
        out.push_back("--velocity=" + options.velocity);
    if (options.alone)
        out.emplace_back("--alone");
    if (options.dt)
        out.push_back("--dt=" + number_text(*options.dt));
    if (options.start)
        out.push_back("--start=" + number_text(*options.start));
    if (options.confined)
        out.emplace_back("--confined");
    return out;
}

} // namespace wakesurf::command
