#include "core/field/analytic_flow.hpp"

#include "core/field/bounded_form.hpp"
#include "core/field/closed_forms.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace wakesurf::core {

namespace {

template <class Form>
std::unique_ptr<Flow> bounded(Form form, const Box& box) {
    return std::make_unique<AnalyticFlow<Form>>(form, box);
}

using Values = std::span<const FlowParameter>;

Box cube(double lo, double hi) {
    return {Vec3(lo), Vec3(hi)};
}

} // namespace

const std::vector<AnalyticEntry>& analytic_entries() {
    static const std::vector<AnalyticEntry> table = {
        {"uniform",
         {{"u", 1}, {"v", 0}, {"w", 0}},
         cube(-10, 10),
         true,
         [](Values p, const Box& box) {
             return bounded(UniformFlow{p[0].value, p[1].value, p[2].value}, box);
         }},
        {"oscillating",
         {{"u", 1}, {"a", 1}, {"omega", 2}},
         cube(-10, 10),
         false,
         [](Values p, const Box& box) {
             return bounded(OscillatingFlow{p[0].value, p[1].value, p[2].value}, box);
         }},
        {"rotation",
         {{"omega", 1}, {"w", 0.2}},
         cube(-10, 10),
         true,
         [](Values p, const Box& box) {
             return bounded(RotationFlow{p[0].value, p[1].value}, box);
         }},
        {"shear",
         {{"u", 1}, {"g", 1}},
         cube(-20, 20),
         true,
         [](Values p, const Box& box) {
             return bounded(ShearFlow{p[0].value, p[1].value}, box);
         }},
        {"strain",
         {{"a", 0.5}, {"b", -0.5}, {"c", 0}},
         cube(-10, 10),
         true,
         [](Values p, const Box& box) {
             return bounded(StrainFlow{p[0].value, p[1].value, p[2].value}, box);
         }},
        {"rotating-strain",
         {{"s", 0.5}, {"omega", 1}, {"w", 0}},
         cube(-20, 20),
         false,
         [](Values p, const Box& box) {
             return bounded(RotatingStrainFlow{p[0].value, p[1].value, p[2].value}, box);
         }},
        {"lamb-oseen",
         {{"gamma", 2 * std::numbers::pi}, {"rc", 0.3}, {"w", 0.5}},
         cube(-10, 10),
         true,
         [](Values p, const Box& box) {
             return bounded(LambOseenFlow{p[0].value, p[1].value, p[2].value}, box);
         }},
        {"sphere",
         {{"u", 1}, {"a", 0.5}},
         {Vec3(-5), Vec3(10, 5, 5)},
         true,
         [](Values p, const Box& box) {
             return bounded(SphereFlow{p[0].value, p[1].value}, box);
         }},
        {"cylinder",
         {{"u", 1}, {"a", 0.5}, {"w", 0.2}},
         {Vec3(-5), Vec3(10, 5, 5)},
         true,
         [](Values p, const Box& box) {
             return bounded(CylinderFlow{p[0].value, p[1].value, p[2].value}, box);
         }},
        {"hill",
         {{"u", 1}, {"a", 1}},
         cube(-3, 3),
         true,
         [](Values p, const Box& box) {
             return bounded(HillFlow{p[0].value, p[1].value}, box);
         }},
        {"abc",
         {{"A", 1}, {"B", 1}, {"C", 0}},
         cube(-20, 20),
         true,
         [](Values p, const Box& box) {
             return bounded(AbcFlow{p[0].value, p[1].value, p[2].value}, box);
         }},
        {"double-gyre",
         {{"A", 0.1}, {"eps", 0.25}, {"period", 10}, {"w", 0.1}},
         {Vec3(0, 0, -5), Vec3(2, 1, 5)},
         false,
         [](Values p, const Box& box) {
             return bounded(DoubleGyreFlow{p[0].value, p[1].value, p[2].value, p[3].value}, box);
         }},
        {"tornado",
         {},
         cube(0, 1),
         false,
         [](Values, const Box& box) { return bounded(TornadoFlow{}, box); }},
        {"stagnation",
         {{"a", 1}},
         cube(-5, 5),
         true,
         [](Values p, const Box& box) { return bounded(StagnationFlow{p[0].value}, box); }},
    };
    return table;
}

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
