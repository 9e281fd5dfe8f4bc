#include "core/field/analytic_flow.hpp"

#include "core/field/analytic_catalogue.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

/// Returns the smallest and the largest speed on 17^3 points of the domain at time 0.
std::array<double, 2> speed_range(const Flow& flow) {
    std::array<double, 2> range{std::numeric_limits<double>::infinity(), 0.0};
    const Box box = flow.domain();
    for (int i = 0; i < 17 * 17 * 17; ++i) {
        const Vec3 p = box.lo + box.extent() * Vec3(i % 17, i / 17 % 17, i / 289) / 16.0;
        if (flow.status(p) != PointStatus::Inside)
            continue;
        Vec3 v;
        const double time = 0.0;
        (void)flow.sample({&p, 1}, {&time, 1}, {&v, 1}, {});
        range = {std::min(range[0], glm::length(v)), std::max(range[1], glm::length(v))};
    }
    return range;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

/// Returns the entry with its parameters replaced by those given.
Result<AnalyticEntry> parse(std::string_view specification) {
    const std::size_t question = specification.find('?');
    const std::string_view name = specification.substr(0, question);
    const auto found = std::find_if(analytic_entries().begin(), analytic_entries().end(),
                                    [&](const AnalyticEntry& e) { return e.name == name; });
    if (found == analytic_entries().end())
        return fail(Error::Code::NotFound, "there is no built-in flow '" + std::string(name) + "'",
                    "choose one of " + joined(analytic_flow_names()));
    AnalyticEntry entry = *found;
    std::string_view rest = question == std::string_view::npos ? std::string_view{}
                                                               : specification.substr(question + 1);
    while (!rest.empty()) {
        const std::size_t comma = rest.find_first_of(",&");
        const std::string_view pair = rest.substr(0, comma);
        rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
        const std::size_t equals = pair.find('=');
        const auto parameter =
            std::find_if(entry.parameters.begin(), entry.parameters.end(),
                         [&](const FlowParameter& p) { return p.name == pair.substr(0, equals); });
        const std::string_view text =
            equals == std::string_view::npos ? std::string_view{} : pair.substr(equals + 1);
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        std::vector<std::string> known;
        for (const FlowParameter& p : entry.parameters)
            known.emplace_back(p.name);
        if (parameter == entry.parameters.end() || text.empty() || error != std::errc{} ||
            end != text.data() + text.size() || !std::isfinite(value))
            return fail(Error::Code::InvalidArgument,
                        "flow '" + std::string(name) + "' cannot take '" + std::string(pair) + "'",
                        known.empty()
                            ? "it has no parameters"
                            : "write key=value with a finite number; keys: " + joined(known));
        parameter->value = value;
    }
    return entry;
}

} // namespace

std::vector<std::string> analytic_flow_names() {
    std::vector<std::string> names;
    for (const AnalyticEntry& entry : analytic_entries())
        names.emplace_back(entry.name);
    return names;
}

Result<std::unique_ptr<Flow>> make_analytic_flow(std::string_view specification) {
    return parse(specification).map([](const AnalyticEntry& entry) {
        return entry.make(entry.parameters, entry.box);
    });
}

Result<DatasetInfo> describe_analytic_flow(std::string_view specification) {
    const auto entry = parse(specification);
    if (!entry)
        return tl::unexpected(entry.error());
    DatasetInfo info;
    info.dataset = "flow:" + std::string(specification);
    info.name = std::string(entry->name);
    info.reader = "analytic";
    info.grid = GridKind::Analytic;
    info.bounds = entry->box;
    info.steady = entry->steady;
    const int count = entry->steady ? 1 : 21;
    for (int i = 0; i < count; ++i)
        info.times.push_back(0.5 * i);
    const std::unique_ptr<Flow> flow = entry->make(entry->parameters, entry->box);
    info.finest_spacing = flow->finest_spacing();
    info.obstacle = flow->obstacle();
    FieldInfo velocity{"velocity", 3, FieldInfo::Source::Point, speed_range(*flow), ""};
    info.fields = {velocity};
    info.velocity = "velocity";
    info.why = "built-in closed form";
    return info;
}

} // namespace wakesurf::core
