#include "core/field/analytic_catalogue.hpp"

#include "core/field/bounded_form.hpp"
#include "core/field/closed_forms.hpp"

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

} // namespace wakesurf::core
