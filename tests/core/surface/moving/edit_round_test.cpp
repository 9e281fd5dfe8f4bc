#include "core/field/analytic_flow.hpp"
#include "core/surface/moving/edge_changes.hpp"
#include "core/surface/moving/edit_round.hpp"
#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/triangle_shape.hpp"
#include "tests/support/flat_patch.hpp"
#include "tests/support/mesh_hash.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <array>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

namespace wakesurf::core::edit_round_test {

using namespace tests;

namespace {

/// Edits that take elements, which nobody else can take then.
using Taken = std::vector<std::uint32_t>;

std::vector<Taken> random_takings(unsigned seed, std::size_t count, std::uint32_t elements) {
    std::mt19937 random(seed);
    std::vector<Taken> all(count);
    for (Taken& each : all)
        for (auto i = random() % 5; i < 5; ++i)
            each.push_back(static_cast<std::uint32_t>(random() % elements));
    return all;
}

/// Those that one after the other can still be made.
std::vector<std::uint32_t> greedy(const std::vector<Taken>& takings, std::uint32_t elements) {
    std::vector<bool> taken(elements, false);
    std::vector<std::uint32_t> made;
    for (std::uint32_t i = 0; i < takings.size(); ++i) {
        if (std::any_of(takings[i].begin(), takings[i].end(), [&](auto e) { return taken[e]; }))
            continue;
        for (const std::uint32_t e : takings[i])
            taken[e] = true;
        made.push_back(i);
    }
    return made;
}

/// The same in rounds.
std::vector<std::uint32_t> in_rounds(const std::vector<Taken>& takings, std::uint32_t elements) {
    MaterialTriangles triangles;
    triangles.claims().make_room(elements);
    std::vector<std::uint8_t> taken(elements, 0), made(takings.size(), 0);
    std::vector<std::uint32_t> pending(takings.size());
    std::iota(pending.begin(), pending.end(), 0u);
    for (int again = 0; !pending.empty(); ++again) {
        const auto ask = [&](std::uint32_t rank, Taken& claimed) -> std::optional<std::uint32_t> {
            const Taken& wanted = takings[pending[rank]];
            if (std::any_of(wanted.begin(), wanted.end(), [&](auto e) { return taken[e] != 0; }))
                return std::nullopt;
            claimed.insert(claimed.end(), wanted.begin(), wanted.end());
            return pending[rank];
        };
        const auto round = edit_round<std::uint32_t>(
            again, pending.size(), triangles, ask, numbers_nothing, prepares_nothing,
            [&](std::uint32_t i, std::size_t, TriangleChanges&) {
                made[i] = 1;
                for (const std::uint32_t e : takings[i])
                    taken[e] = 1;
            });
        pending = round.again(pending);
    }
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < made.size(); ++i)
        if (made[i] != 0)
            found.push_back(i);
    return found;
}

/// With as many threads as are asked for, whatever the machine has.
template <class Work>
auto with_threads(std::size_t threads, const Work& work) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(static_cast<int>(threads));
    return arena.execute(work);
}

constexpr std::array<std::size_t, 5> thread_counts{1, 2, 3, 4, 7};

struct Cut {
    TriangleId t;
    unsigned k;
};

/// Cuts the wanted edges in rounds until none is left, as Refinement does.
void cut_all(MovingMesh& mesh, std::vector<std::pair<VertexId, VertexId>> wanted) {
    MaterialTriangles& triangles = mesh.triangles;
    for (int again = 0; !wanted.empty(); ++again) {
        triangles.claims().make_room(mesh.vertices.slots());
        std::vector<VertexId> made;
        std::vector<std::array<TriangleId, 2>> slots;
        const auto ask = [&](std::size_t i, std::vector<VertexId>& claimed) -> std::optional<Cut> {
            const auto [t, k] = triangles.find_either_way(wanted[i].first, wanted[i].second);
            if (t == no_triangle)
                return std::nullopt;
            const auto& corners = triangles[t].vertex;
            claimed.insert(claimed.end(), corners.begin(), corners.end());
            if (triangles[t].across[k] != no_triangle)
                claimed.push_back(triangles.opposite_beyond(t, k));
            return Cut{t, k};
        };
        const auto round = edit_round<Cut>(
            again, wanted.size(), triangles, ask, [](const Cut&) { return std::size_t{1}; },
            [&](std::size_t count) {
                const auto vertices = mesh.vertices.take_slots(count);
                made.insert(made.end(), vertices.begin(), vertices.end());
                const auto more = triangles.slots_to_split(count, mesh.vertices.slots());
                slots.insert(slots.end(), more.begin(), more.end());
            },
            [&](const Cut& cut, std::size_t i, TriangleChanges& changes) {
                mesh.vertices.begin(made[i], point_on_edge(mesh, cut.t, cut.k, 0.5),
                                    VertexRole::Free, mesh.time);
                triangles.split(cut.t, cut.k, made[i], slots[i], changes);
            });
        EXPECT_EQ(round.made.size(), made.size());
        wanted = round.again(wanted);
    }
}

/// Half of all edges.
std::vector<std::pair<VertexId, VertexId>> random_edges(const MovingMesh& mesh, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::pair<VertexId, VertexId>> some;
    for (const Triangle& t : mesh.triangles.slots())
        for (unsigned k = 0; t.live && k < 3; ++k)
            if (t.begin(k) < t.end(k) && random() % 2 == 0)
                some.emplace_back(t.begin(k), t.end(k));
    return some;
}

} // namespace

TEST(EditRound, MakesTheEditsThatOneAfterTheOtherWouldMake) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::uint32_t elements = seed % 2 == 0 ? 3000 : 40; // few meet, and nearly all do
        const auto takings = random_takings(seed, 1000, elements);
        const auto expected = greedy(takings, elements);
        EXPECT_GT(expected.size(), 5u);
        for (const std::size_t threads : thread_counts)
            EXPECT_EQ(with_threads(threads, [&] { return in_rounds(takings, elements); }), expected)
                << seed << ", " << threads << " threads";
    }
}

TEST(EditRound, GivesNumbersInTheOrderOfTheEditsAndKeepsNoClaims) {
    MaterialTriangles triangles;
    triangles.claims().make_room(500);
    for (const std::size_t threads : thread_counts)
        with_threads(threads, [&] {
            std::vector<std::size_t> first(1000, 0);
            std::size_t prepared = 0;
            const auto round = edit_round<std::uint32_t>(
                0, 1000, triangles,
                [](std::uint32_t rank, std::vector<std::uint32_t>& claimed) {
                    claimed.push_back(rank / 2); // the odd ones lose
                    return std::optional(rank);
                },
                [](std::uint32_t i) { return std::size_t{i % 3}; },
                [&](std::size_t numbers) { prepared = numbers; },
                [&](std::uint32_t i, std::size_t number, TriangleChanges& changes) {
                    first[i] = number;
                    changes.left.push_back(i);
                });
            std::size_t number = 0;
            ASSERT_EQ(round.made.size(), 500u);
            for (std::uint32_t i = 0; i < 500; ++i) {
                EXPECT_EQ(round.made[i], 2 * i);
                EXPECT_EQ(round.lost[i], 2 * i + 1);
                EXPECT_EQ(first[2 * i], number);
                number += 2 * i % 3;
            }
            EXPECT_EQ(prepared, number);
            EXPECT_EQ(triangles.left(), round.made) << "changes come together in order";
            triangles.left().clear();
        });
}

TEST(EditRound, ManyFlipsSideBySideAreAllMadeInOneCall) {
    MovingMesh mesh = flat_patch(60, 60);
    // Sheared so that every diagonal is the longer one of its square.
    for (Vec3& p : mesh.vertices.position)
        p.x += 0.6 * p.y;
    const auto diagonals = [&] {
        std::size_t count = 0;
        for (const Triangle& t : mesh.triangles.slots())
            for (unsigned k = 0; k < 3; ++k)
                count += t.live && mesh.vertices.t[t.begin(k)] < mesh.vertices.t[t.end(k)] &&
                         mesh.vertices.s[t.begin(k)] < mesh.vertices.s[t.end(k)];
        return count;
    };
    RefinementRules rules;
    rules.separation = 10.0;
    const auto flow = *make_analytic_flow("uniform");
    const RefinementContext context{mesh, *flow, rules};
    std::vector<TriangleId> all(mesh.triangles.slots().size());
    std::iota(all.begin(), all.end(), 0u);
    ASSERT_EQ(diagonals(), 3600u);
    flip_all(context, all);
    EXPECT_EQ(diagonals(), 0u);
    EXPECT_EQ(mesh.triangles.violation(), "");
}

TEST(EditRound, CutsThatMeetLeaveASoundMeshOfTheSameBytesForAnyNumberOfThreads) {
    std::optional<std::uint64_t> first;
    for (const std::size_t threads : thread_counts) {
        const std::uint64_t bytes = with_threads(threads, [&] {
            MovingMesh mesh = flat_patch(24, 20);
            const double whole = area(mesh);
            for (unsigned round = 0; round < 2; ++round) {
                cut_all(mesh, random_edges(mesh, round));
                EXPECT_EQ(mesh.triangles.violation(), "") << threads << " threads";
                EXPECT_NEAR(area(mesh), whole, 1e-9);
            }
            EXPECT_GT(mesh.triangles.live(), 2500u);
            pair_and_clean(mesh);
            EXPECT_EQ(violation(mesh), "");
            return hash(snapshot(mesh, {}));
        });
        EXPECT_EQ(bytes, first.value_or(bytes)) << threads << " threads";
        first = bytes;
    }
}

} // namespace wakesurf::core::edit_round_test
