// What every streak and time surface keeps after every step, on requests that no one chose: all flows, lines,
// polylines and circles, separations over two decades, all accuracies. WAKESURF_SURFACES=N looks at the first
// N of them, WAKESURF_SURFACE=N at that one alone.
#include "core/field/analytic_flow.hpp"
#include "tests/support/mesh_hash.hpp"
#include "tests/support/moving_runs.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstdlib>
#include <numbers>
#include <optional>
#include <random>
#include <span>

namespace wakesurf::core::random_moving_surfaces_test {

namespace {

using namespace tests;

constexpr std::uint32_t usual_surfaces = 112; ///< four of each flow and kind
constexpr std::uint64_t most_quads = 1'500;

std::optional<std::uint32_t> number(const char* variable) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? std::nullopt
                           : std::optional(static_cast<std::uint32_t>(std::stoul(text)));
}

/// The same of a number on every machine.
class Draw {
  public:
    explicit Draw(std::uint32_t seed) : random_(seed) {}

    double within(double least, double most) {
        return least + (most - least) * static_cast<double>(random_()) / std::mt19937::max();
    }

    std::size_t below(std::size_t count) { return random_() % count; }

    Vec3 vector(const Vec3& reach) {
        const double x = within(-1.0, 1.0), y = within(-1.0, 1.0);
        return reach * Vec3(x, y, within(-1.0, 1.0));
    }

  private:
    std::mt19937 random_;
};

Rake random_rake(const Box& box, Draw& draw) {
    const Vec3 middle = box.lo + 0.5 * box.extent();
    const Vec3 first = middle + draw.vector(0.25 * box.extent());
    Rake rake{Rake::Kind::Line, {first}, static_cast<std::uint32_t>(2 + draw.below(20))};
    const std::size_t kind = draw.below(3);
    rake.kind = std::array{Rake::Kind::Line, Rake::Kind::Polyline, Rake::Kind::Circle}[kind];
    if (rake.kind == Rake::Kind::Circle) {
        const double radius = draw.within(0.02, 0.15) * box.extent().x;
        const Vec3 one = glm::normalize(draw.vector(Vec3(1.0)));
        const Vec3 two = glm::normalize(glm::cross(one, draw.vector(Vec3(1.0))));
        rake.points.push_back(first + radius * one);
        rake.points.push_back(first + radius * two);
        return rake;
    }
    const std::size_t more = rake.kind == Rake::Kind::Line ? 1 : 2 + draw.below(3);
    for (std::size_t i = 0; i < more; ++i)
        rake.points.push_back(rake.points.back() + draw.vector(0.12 * box.extent()));
    return rake;
}

/// Flows and kinds in turn.
MovingRun random_surface(std::uint32_t index) {
    Draw draw(index);
    const auto& entries = analytic_entries();
    const AnalyticEntry& entry = entries[index % entries.size()];
    MovingRun asked;
    asked.flow = entry.make(entry.parameters, entry.box);
    asked.rake = random_rake(entry.box, draw);
    asked.parameters = streak(draw.within(0.3, 4.0), 0.0);
    SurfaceParameters& p = asked.parameters;
    p.separation =
        SeedingCurve(asked.rake).length() * 0.02 * std::pow(100.0, draw.within(0.0, 1.0));
    p.accuracy = std::array{Accuracy::Fast, Accuracy::Balanced, Accuracy::Exact}[draw.below(3)];
    p.max_quads = most_quads;
    if (index / entries.size() % 2 == 1) {
        p.kind = SurfaceKind::Time;
        p.sweep = draw.vector(0.12 * entry.box.extent());
    } else if (draw.below(4) == 0)
        p.release_until = draw.within(0.3, 1.0) * p.to;
    if (draw.below(4) == 0) // backward
        p.to = -p.to,
        p.release_until = p.release_until ? std::optional(-*p.release_until) : std::nullopt;
    asked.name = "surface " + std::to_string(index) + ", " + std::string(entry.name);
    return asked;
}

/// Nothing where not even a coarse surface fits the budget.
std::optional<MovingSurface> started(const MovingRun& asked) {
    static const SteadyClock clock;
    auto surface = MovingSurface::start(
        plan_surface(*asked.flow, asked.rake, asked.parameters).value(), {}, clock);
    if (surface)
        return std::move(*surface);
    EXPECT_EQ(surface.error().code, Error::Code::OverLimit)
        << asked.name << ": " << surface.error().message;
    return std::nullopt;
}

/// An id is of one particle: it keeps where and when it was released, unless it waits on the rake.
std::string changed_particle(const KeyedMesh& before, const KeyedMesh& now) {
    std::size_t at = 0;
    for (std::size_t v = 0; v < before.vertex_id.size(); ++v) {
        while (at < now.vertex_id.size() && now.vertex_id[at] < before.vertex_id[v])
            ++at;
        if (at == now.vertex_id.size() || now.vertex_id[at] != before.vertex_id[v])
            continue;
        const bool waiting = before.mesh.t[v] == before.time;
        if (now.mesh.s[at] != before.mesh.s[v] || (!waiting && now.mesh.t[at] != before.mesh.t[v]))
            return "vertex " + std::to_string(before.vertex_id[v]) + " is another particle";
    }
    return {};
}

/// Empty where all is well.
std::string
first_fault(const MovingSurface& surface, const KeyedMesh& before, const KeyedMesh& now) {
    if (std::string wrong = surface.validate(); !wrong.empty())
        return wrong;
    if (std::string wrong = now.mesh.validate(); !wrong.empty())
        return "shown: " + wrong;
    if (const double most = longest_edge(now.mesh) / surface.state().separation; most > 1.0 + 1e-6)
        return "an edge of " + std::to_string(most) + " separations";
    for (const Vec3& p : now.mesh.position)
        if (!(glm::length(p) < 1e6))
            return "a vertex is not at a finite place";
    const auto rising = [](const std::vector<std::uint32_t>& ids) {
        return std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end();
    };
    if (!rising(now.vertex_id) || !rising(now.cell_id))
        return "ids do not ascend";
    if (surface.state().separation == surface.state().plan->rules.separation)
        return changed_particle(before, now);
    return {};
}

/// Steps to the end; @return how many steps were looked at.
std::size_t expect_invariants(const MovingRun& asked) {
    std::optional<MovingSurface> surface = started(asked);
    if (!surface)
        return 0;
    KeyedMesh before = surface->mesh();
    double separation = surface->state().separation;
    std::size_t steps = 0;
    while (surface->time() != surface->end_time()) {
        const auto stepped = surface->step(surface->end_time(), {});
        if (!stepped) {
            EXPECT_EQ(stepped.error().code, Error::Code::OverLimit) << asked.name;
            return steps;
        }
        KeyedMesh now = surface->mesh();
        // A surface that exceeds its budget is begun again, coarser, with other particles.
        const bool again = surface->state().separation != separation;
        separation = surface->state().separation;
        const std::string fault = first_fault(*surface, again ? now : before, now);
        EXPECT_EQ(fault, "") << asked.name << " at " << surface->time();
        if (!fault.empty())
            return steps;
        before = std::move(now);
        ++steps;
    }
    return steps;
}

std::uint64_t hash_with(const MovingRun& asked, int threads) {
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 5);
    tbb::task_arena arena(threads);
    std::uint64_t made = 0;
    arena.execute([&] {
        std::optional<MovingSurface> surface = started(asked);
        if (surface && surface->advance_to(surface->end_time(), {}))
            made = hash(surface->mesh());
    });
    return made;
}

} // namespace

TEST(RandomMovingSurfaces, KeepEveryInvariantAfterEveryStep) {
    const auto only = number("WAKESURF_SURFACE");
    const std::uint32_t first = only.value_or(0);
    const std::uint32_t count = only ? 1 : number("WAKESURF_SURFACES").value_or(usual_surfaces);
    std::size_t steps = 0, surfaces = 0;
    for (std::uint32_t i = first; i < first + count; ++i) {
        const std::size_t looked = expect_invariants(random_surface(i));
        steps += looked;
        surfaces += looked > 0;
    }
    EXPECT_GE(surfaces, (3 * count + 3) / 4);
    EXPECT_GE(steps, 4 * count);
}

/// Of the first 2,100 those in which a particle that had ended stayed a corner of a cell.
TEST(RandomMovingSurfaces, KeepEveryInvariantWhereOneWasOnceBroken) {
    for (const std::uint32_t index : {979u, 1217u, 2006u})
        EXPECT_GT(expect_invariants(random_surface(index)), 0u);
}

TEST(RandomMovingSurfaces, AreTheSameBytesWithOneTwoAndFiveThreads) {
    for (std::uint32_t i = 0; i < 28; i += 3) {
        const MovingRun asked = random_surface(i);
        const std::uint64_t one = hash_with(asked, 1);
        EXPECT_EQ(hash_with(asked, 2), one) << asked.name;
        EXPECT_EQ(hash_with(asked, 5), one) << asked.name;
    }
}

} // namespace wakesurf::core::random_moving_surfaces_test
