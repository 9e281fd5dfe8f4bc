#include "store/command/source_options.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace wakesurf::command {

void add_layout_option(CLI::App& command, std::string& layout) {
    command
        .add_option(
            "--layout", layout,
            "How time-steps are stored: whole, in bricks of 32 cells, which are read one by "
            "one, or auto: in bricks where a time-step's velocity is larger than 1 GiB")
        ->check(CLI::IsMember({"auto", "whole", "bricks"}))
        ->capture_default_str();
}

namespace {

constexpr unsigned most_periods = 1000;

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

// Reads PERIODS or PERIODS:LENGTH.
std::optional<Loop> loop_of(std::string_view text) {
    Loop loop;
    const char* const end = text.data() + text.size();
    auto read = std::from_chars(text.data(), end, loop.periods);
    if (read.ec != std::errc() || loop.periods < 2 || loop.periods > most_periods)
        return std::nullopt;
    if (read.ptr == end)
        return loop;
    if (*read.ptr != ':')
        return std::nullopt;
    read = std::from_chars(read.ptr + 1, end, loop.period.emplace());
    const bool sound = read.ec == std::errc() && read.ptr == end && std::isfinite(*loop.period) &&
                       *loop.period > 0.0;
    return sound ? std::optional(loop) : std::nullopt;
}

// Reads "x,z". Returns nothing for any other text.
std::optional<core::PeriodicAxes> read_axes(const std::string& text) {
    core::PeriodicAxes axes{};
    for (std::size_t i = 0; i < text.size(); i += 2) {
        const auto axis = std::string_view("xyz").find(text[i]);
        const bool last = i + 1 == text.size();
        if (axis == std::string_view::npos || axes[axis] ||
            (!last && (text[i + 1] != ',' || i + 2 == text.size())))
            return std::nullopt;
        axes[axis] = true;
    }
    return core::any(axes) ? std::optional(axes) : std::nullopt;
}

CLI::Validator axes_of_text() {
    return CLI::Validator(
        [](std::string& text) {
            return read_axes(text)
                       ? std::string()
                       : "'" + text + "' is not x, y or z, or several of them with commas";
        },
        "AXES");
}

} // namespace

std::string axes_list(const core::PeriodicAxes& axes) {
    std::string text;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (axes[axis])
            text += (text.empty() ? "" : ",") + std::string(1, "xyz"[axis]);
    return text;
}

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
    command
        .add_option_function<std::string>(
            "--loop",
            [&options](const std::string& text) {
                options.loop = loop_of(text);
                if (!options.loop)
                    throw CLI::ValidationError(
                        "--loop", "'" + text + "' is not PERIODS or PERIODS:LENGTH, with 2 to " +
                                      std::to_string(most_periods) + " periods");
            },
            "The stored times are one period, which is repeated: PERIODS, or PERIODS:LENGTH "
            "(default length: by whether the last time-step is the first again)")
        ->option_text("PERIODS[:LENGTH]");
    command
        .add_option_function<std::string>(
            "--mask",
            [&options](const std::string& use) { options.mask = use == "body" ? "" : use; },
            "What a scalar called mask, solid or the like marks: body: a solid that stays; gap: at "
            "each time, where there is no fluid, for bodies that move; scalar: nothing (default: "
            "body)")
        ->check(CLI::IsMember({"body", "gap", "scalar"}))
        ->option_text("body|gap|scalar");
    command
        .add_option_function<std::string>(
            "--periodic",
            [&options](const std::string& text) {
                options.periodic = read_axes(text).value_or(core::PeriodicAxes{});
            },
            "The flow repeats along these axes, x or x,y: what leaves the box of the data on one "
            "side goes on from the other. Of OpenFOAM cyclic patches say it")
        ->check(axes_of_text());
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
    if (options.loop)
        out.push_back("--loop=" + std::to_string(options.loop->periods) +
                      (options.loop->period ? ":" + number_text(*options.loop->period) : ""));
    if (!options.mask.empty())
        out.push_back("--mask=" + options.mask);
    if (core::any(options.periodic))
        out.push_back("--periodic=" + axes_list(options.periodic));
    if (options.confined)
        out.emplace_back("--confined");
    return out;
}

} // namespace wakesurf::command
