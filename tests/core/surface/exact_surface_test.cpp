// Exact surfaces of stored data against a reference of the test's own: trilinear in a cell, linear between
// two time-steps, integrated by RK4 steps that end on the faces, where the field has a kink. It shares no
// code with the engine's sampling.
#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace wakesurf::core::exact_surface_test {

using namespace tests;

namespace {

const std::vector<double>& times() {
    static const std::vector<double> all{0.0, 0.7, 1.1, 2.0, 3.5};
    return all;
}

struct Case {
    const char* name;
    Box box;
    Vec3 from, to;
};

/// Nodes and the float velocities there.
class Reference {
  public:
    Reference(const Case& c, bool stretched) : form_(*make_analytic_flow(c.name)) {
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i <= 24; ++i) {
                const double u = i / 24.0;
                const double place = stretched ? u + 0.08 * std::sin(6.0 * u) * u * (1.0 - u) : u;
                nodes_[static_cast<std::size_t>(axis)].push_back(c.box.lo[axis] +
                                                                 c.box.extent()[axis] * place);
            }
        UniformGrid even{
            .origin = c.box.lo, .spacing = c.box.extent() / 24.0, .dimensions = {25, 25, 25}};
        Grid grid = even;
        if (stretched)
            grid = RectilinearGrid{nodes_};
        auto source =
            std::make_shared<SampledSource>(grid, times(), [form = form_](const Vec3& p, double t) {
                return at_node(*form, p, t);
            });
        for (const double t : times())
            for (std::size_t node = 0; node < 25 * 25 * 25; ++node)
                velocity_.emplace_back(at_node(*form_, source->position(node), t));
        flow_ = make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    }

    const Flow& flow() const { return *flow_; }

    /// Where a particle is at `to` that was at `p` at `from`. @param frozen  the field stays as it is at
    /// `from`
    /// @param part  of a cell, the length of a step: one that crosses a face and comes back within a step is
    ///              off by its square
    Vec3 carried(Vec3 p, double from, double to, bool frozen, double part = 2e-3) const {
        const double sign = to < from ? -1.0 : 1.0;
        double now = from;
        std::array<std::ptrdiff_t, 3> cell = cell_of(p);
        while (now != to) {
            const std::size_t k = interval(frozen ? from : now, sign);
            const double border = times()[sign > 0 ? k + 1 : k];
            const double end = frozen || sign * (border - to) > 0.0 ? to : border;
            const double speed = glm::length(velocity(cell, k, p, frozen ? from : now));
            double dt = std::min(std::abs(end - now), part * flow_->finest_spacing() / speed);
            const bool last = dt == std::abs(end - now);
            Vec3 next = stepped(cell, k, p, now, sign * dt, frozen ? &from : nullptr);
            if (inside(cell, next)) {
                p = next;
                now = last ? end : now + sign * dt;
                continue;
            }
            double in = 0.0;
            double out = dt;
            for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (in + out);
                (inside(cell, stepped(cell, k, p, now, sign * middle, frozen ? &from : nullptr))
                     ? in
                     : out) = middle;
            }
            p = stepped(cell, k, p, now, sign * out, frozen ? &from : nullptr);
            now += sign * out;
            cell = cell_of(p);
        }
        return p;
    }

  private:
    static Vec3 at_node(const Flow& form, const Vec3& p, double t) {
        Vec3 v;
        EXPECT_TRUE(form.sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
        return v;
    }

    static std::size_t interval(double t, double sign) {
        std::size_t k = 0;
        while (k + 2 < times().size() && (sign > 0 ? t >= times()[k + 1] : t > times()[k + 1]))
            ++k;
        return k;
    }

    std::array<std::ptrdiff_t, 3> cell_of(const Vec3& p) const {
        std::array<std::ptrdiff_t, 3> cell{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& x = nodes_[axis];
            const auto after = std::upper_bound(x.begin(), x.end(), p[static_cast<int>(axis)]);
            cell[axis] = std::clamp<std::ptrdiff_t>(after - x.begin() - 1, 0,
                                                    static_cast<std::ptrdiff_t>(x.size()) - 2);
        }
        return cell;
    }

    bool inside(const std::array<std::ptrdiff_t, 3>& cell, const Vec3& p) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(cell[axis]);
            const double here = p[static_cast<int>(axis)];
            if (here < nodes_[axis][i] || here > nodes_[axis][i + 1])
                return false;
        }
        return true;
    }

    /// The polynomial of a cell, also beyond it.
    Vec3 velocity(const std::array<std::ptrdiff_t, 3>& cell,
                  std::size_t k,
                  const Vec3& p,
                  double t) const {
        const double late = (t - times()[k]) / (times()[k + 1] - times()[k]);
        Vec3 sum(0.0);
        for (std::size_t corner = 0; corner < 8; ++corner) {
            double share = 1.0;
            std::size_t node = 0;
            std::size_t stride = 1;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto i = static_cast<std::size_t>(cell[axis]);
                const auto& x = nodes_[axis];
                const double u = (p[static_cast<int>(axis)] - x[i]) / (x[i + 1] - x[i]);
                const bool upper = (corner >> axis & 1u) != 0;
                share *= upper ? u : 1.0 - u;
                node += stride * (i + (upper ? 1 : 0));
                stride *= x.size();
            }
            const Vec3 before(velocity_[k * stride + node]);
            const Vec3 after(velocity_[(k + 1) * stride + node]);
            sum += share * ((1.0 - late) * before + late * after);
        }
        return sum;
    }

    Vec3 stepped(const std::array<std::ptrdiff_t, 3>& cell,
                 std::size_t k,
                 const Vec3& p,
                 double now,
                 double dt,
                 const double* frozen) const {
        const auto v = [&](const Vec3& at, double t) {
            return velocity(cell, k, at, frozen != nullptr ? *frozen : t);
        };
        const Vec3 k1 = v(p, now);
        const Vec3 k2 = v(p + 0.5 * dt * k1, now + 0.5 * dt);
        const Vec3 k3 = v(p + 0.5 * dt * k2, now + 0.5 * dt);
        const Vec3 k4 = v(p + dt * k3, now + dt);
        return p + dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }

    std::shared_ptr<const Flow> form_;
    std::array<std::vector<double>, 3> nodes_;
    std::vector<Vec3f> velocity_; ///< node by node, time-step by time-step
    std::unique_ptr<Flow> flow_;
};

/// How much the flow map magnifies what a particle is off by: at least 1.
double magnification(const Reference& reference, const Vec3& seed, double from, double to, bool f) {
    const double nudge = 1e-6;
    const Vec3 truth = reference.carried(seed, from, to, f, 0.02);
    double sum = 1.0;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
        sum +=
            glm::length(reference.carried(seed + nudge * axis, from, to, f, 0.02) - truth) / nudge;
    return sum;
}

void expect_exact(const Case& c, bool stretched) {
    const Reference reference(c, stretched);
    const Rake rake{Rake::Kind::Line, {c.from, c.to}, 12};
    const SeedingCurve seeding(rake);
    for (const SurfaceKind kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        SurfaceParameters p{.kind = kind,
                            .from = 0.4,
                            .to = 2.4,
                            .separation = 0.25,
                            .accuracy = Accuracy::Exact,
                            .deformation = true};
        if (kind == SurfaceKind::Time)
            p.sweep = Vec3(0.1, 0.15, 0.2);
        const auto surface = build_surface(reference.flow(), rake, p);
        ASSERT_TRUE(surface) << surface.error().message;
        const QuadComplex& mesh = surface->mesh;
        ASSERT_GT(mesh.vertices(), 15u);
        int compared = 0;
        for (VertexId v = 0; v < mesh.vertices();
             v += 1 + static_cast<VertexId>(mesh.vertices() / 10)) {
            const bool moving = kind == SurfaceKind::Streak || kind == SurfaceKind::Time;
            const double from = kind == SurfaceKind::Streak ? mesh.t[v] : p.from;
            const double to = moving ? p.to : p.from + mesh.t[v];
            const Vec3 seed = seeding.at(mesh.s[v]) +
                              (kind == SurfaceKind::Time ? mesh.t[v] * *p.sweep : Vec3(0.0));
            const bool frozen = kind == SurfaceKind::Stream;
            const Vec3 truth = reference.carried(seed, from, to, frozen);
            // One tolerance a length, and the reference's own rounding.
            EXPECT_LT(glm::length(truth - mesh.position[v]),
                      1e-9 * (1.0 + 2.0 * std::abs(to - from) * mesh.speed(v)) *
                          magnification(reference, seed, from, to, frozen))
                << c.name << " kind " << static_cast<int>(kind) << " vertex " << v;
            ++compared;
        }
        EXPECT_GE(compared, 8);
    }
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"abc", {Vec3(-4), Vec3(4)}, {-1, 0, 0}, {1, 0.3, 0.2}},
        {"rotating-strain", {Vec3(-6), Vec3(6)}, {0.1, 0, 0}, {1, 0.2, 1}},
    };
    return all;
}

} // namespace

TEST(ExactSurface, EveryVertexIsWhereTheTrilinearFieldLinearInTimeCarriesIt) {
    for (const Case& c : cases())
        expect_exact(c, false);
}

TEST(ExactSurface, EveryVertexIsWhereTheFieldOfARectilinearGridCarriesIt) {
    for (const Case& c : cases())
        expect_exact(c, true);
}

TEST(ExactSurface, TheSmoothFieldIsAnotherAndRefusedWhereThereIsNone) {
    const Case& c = cases().front();
    const Rake rake{Rake::Kind::Line, {c.from, c.to}, 12};
    SurfaceParameters p{.to = 2.0, .separation = 0.25, .sweep = Vec3(0.1, 0.15, 0.2)};
    const Reference uniform(c, false);
    const Reference stretched(c, true);
    const auto formula = *make_analytic_flow(c.name);
    for (const SurfaceKind kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        for (const Accuracy accuracy : {Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}) {
            p.kind = kind;
            p.accuracy = accuracy;
            p.sweep =
                kind == SurfaceKind::Time ? std::optional(Vec3(0.1, 0.15, 0.2)) : std::nullopt;
            p.interpolation = Interpolation::Linear;
            const auto linear = build_surface(uniform.flow(), rake, p);
            p.interpolation = Interpolation::Smooth;
            const auto smooth = build_surface(uniform.flow(), rake, p);
            ASSERT_TRUE(linear && smooth);
            EXPECT_NE(linear->mesh.position, smooth->mesh.position);
            for (const Flow* none : {&stretched.flow(), static_cast<const Flow*>(formula.get())}) {
                const auto refused = build_surface(*none, rake, p);
                ASSERT_FALSE(refused);
                EXPECT_EQ(refused.error().code, Error::Code::InvalidArgument);
                EXPECT_NE(refused.error().message.find("interpolation"), std::string::npos);
                EXPECT_NE(refused.error().hint.find("linear"), std::string::npos);
            }
        }
}

} // namespace wakesurf::core::exact_surface_test
