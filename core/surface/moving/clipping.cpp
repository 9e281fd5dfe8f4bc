#include "core/surface/moving/clipping.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr double close_enough = 2e-7; ///< of an edge
constexpr int halvings = 24;
constexpr int halvings_of_guess = 8;
constexpr int search_rounds = 24;
constexpr std::size_t few_edges = 16; ///< for one task

/// Particles that are carried together from one time to another.
struct Batch {
    std::vector<Vec3> position, along_s, along_t;
    std::vector<float> expansion;
    std::vector<double> time;
    std::vector<CurveEnd> end;

    explicit Batch(std::size_t size)
        : position(size), along_s(size), along_t(size), expansion(size), time(size),
          end(size, CurveEnd::Running) {}

    void set(std::size_t i, const Carried& carried, double at) {
        position[i] = carried.position;
        along_s[i] = carried.along_s;
        along_t[i] = carried.along_t;
        expansion[i] = static_cast<float>(carried.expansion);
        time[i] = at;
    }

    Carried operator[](std::size_t i) const {
        return {position[i], along_s[i], along_t[i], double(expansion[i])};
    }

    Result<TraceCost> advance(const Flow& flow,
                              double to,
                              const AdvanceOptions& options,
                              const std::stop_token& stop) {
        return flow.advance({position, along_s, along_t, time, end, {}, {}, {}, expansion}, to,
                            options, stop);
    }

    Result<TraceCost> advance_places(const Flow& flow,
                                     double to,
                                     const AdvanceOptions& options,
                                     const std::stop_token& stop) {
        return flow.advance({position, {}, {}, time, end}, to, options, stop);
    }
};

/// The search on one edge, for the particle that ends with the step.
struct Search {
    EdgeCrossing* of;
    double died;        ///< when the one at `dead` did
    double tried;       ///< part of the way
    double alive = 0.0; ///< part of the way at which a particle still lives at the end of the step
    double dead = 1.0;  ///< and at which it does not
    bool possible = true; ///< both ends lived at the beginning of the step
    bool done = false;

    void learn(bool lives, double time, double now) {
        double next = 0.5 * (alive + dead); // where particles graze the boundary
        if (lives) {
            alive = tried;
        } else {
            // The secant goes through the last two that died. It is tried a little beyond, as a living one
            // says less; before it at the end.
            const double step = (now - time) * (tried - dead) / (time - died);
            next = tried + step + (std::abs(step) < close_enough ? -1.0 : 0.3) * close_enough;
            dead = tried;
            died = time;
        }
        tried = next > alive && next < dead ? next : 0.5 * (alive + dead);
        done = dead - alive < 2.0 * close_enough;
    }
};

/// The edge as it is now, its dead end carried on at its last velocity.
EdgeCubic edge_now(const RefinementContext& context, const EdgeCrossing& crossing) {
    const MaterialVertices& v = context.mesh.vertices;
    EdgeCubic edge = edge_cubic(context.mesh, crossing.living, crossing.dead);
    edge.b.position +=
        Vec3(v.velocity[crossing.dead]) * (context.mesh.time - v.time[crossing.dead]);
    return edge;
}

/// The part of the way up to which an edge is inside; 1: all of it.
double part_inside(const RefinementContext& context, const EdgeCubic& edge, int halvings_of_it) {
    const auto inside = [&](double part) {
        return context.flow.status(edge.at(part).position) == PointStatus::Inside;
    };
    if (inside(1.0))
        return 1.0;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < halvings_of_it; ++i) {
        const double middle = 0.5 * (low + high);
        (inside(middle) ? low : high) = middle;
    }
    return low;
}

void search_now(const RefinementContext& context, EdgeCrossing& crossing) {
    crossing.edge = edge_now(context, crossing);
    crossing.part = part_inside(context, crossing.edge, halvings);
    crossing.found = crossing.part > 0.0 && crossing.part < 1.0;
    crossing.carried = crossing.edge.at(crossing.part);
}

/// Finds the point that is just as old as a particle may become, on an edge to an older one.
void search_age(const RefinementContext& context, EdgeCrossing& crossing) {
    const MaterialVertices& v = context.mesh.vertices;
    const double t = v.t[crossing.living], older = v.t[crossing.dead];
    const double release = context.mesh.time - (v.time[crossing.dead] - older);
    crossing.edge = edge_cubic(context.mesh, crossing.living, crossing.dead);
    crossing.part = (release - t) / (older - t);
    crossing.found = crossing.part > 0.0 && crossing.part < 1.0;
    crossing.carried = crossing.edge.at(crossing.part);
}

} // namespace

Result<void> find_crossings(const RefinementContext& context,
                            std::span<EdgeCrossing> crossings,
                            double before,
                            const AdvanceOptions& options,
                            const std::stop_token& stop) {
    const MovingMesh& mesh = context.mesh;
    const MaterialVertices& v = mesh.vertices;
    const double now = mesh.time;
    const double sign = now < before ? -1.0 : 1.0;
    const auto moved_all_step = [&](VertexId x) {
        // A vertex of a streak surface that was released in this step was not there at its beginning.
        return v.role[x] == VertexRole::Free &&
               (mesh.rectangle.patch || sign * (v.t[x] - before) <= 0.0);
    };
    std::vector<std::uint8_t> searched(crossings.size(), 0);
    std::vector<double> guess(crossings.size());
    for_each_index(
        crossings.size(),
        [&](std::size_t i) {
            EdgeCrossing& each = crossings[i];
            if (v.end[each.dead] == CurveEnd::Time)
                return search_age(context, each);
            if (v.end[each.dead] != CurveEnd::Domain && v.end[each.dead] != CurveEnd::Obstacle)
                return;
            // A vertex that is traced again may turn out to have ended long ago, somewhere else.
            if (sign * (v.time[each.dead] - before) < 0.0)
                return;
            if (!moved_all_step(each.living) || !moved_all_step(each.dead) || now == before)
                return search_now(context, each);
            searched[i] = 1;
            guess[i] = part_inside(context, edge_now(context, each), halvings_of_guess);
        },
        few_edges);
    std::vector<Search> searches;
    for (std::size_t i = 0; i < crossings.size(); ++i)
        if (searched[i] != 0)
            searches.push_back({&crossings[i], v.time[crossings[i].dead],
                                guess[i] < 1.0 ? guess[i] + 0.01 * (1.0 - guess[i]) : 0.5});
    Batch living(searches.size()), dead(searches.size());
    for_each_index(searches.size(), [&](std::size_t i) {
        const EdgeCrossing& each = *searches[i].of;
        living.set(i, v.point(each.living).carried, now);
        dead.set(i, v.point(each.dead).carried, v.time[each.dead]);
    });
    for (Batch* batch : {&living, &dead})
        if (auto back = batch->advance(context.flow, before, options, stop); !back)
            return tl::unexpected(back.error());
    for_each_index(
        searches.size(),
        [&](std::size_t i) {
            Search& search = searches[i];
            search.of->edge = {living[i], dead[i],
                               mesh.parameter_step(search.of->living, search.of->dead)};
            search.possible =
                living.end[i] == CurveEnd::Running && dead.end[i] == CurveEnd::Running;
            if (!search.possible)
                search_now(context, *search.of);
        },
        few_edges);
    std::vector<Search*> active;
    for (Search& search : searches)
        if (search.possible)
            active.push_back(&search);
    const std::vector<Search*> all = active;
    for (int round = 0; round < search_rounds && !active.empty(); ++round) {
        Batch trial(active.size());
        for_each_index(
            active.size(),
            [&](std::size_t i) { trial.set(i, active[i]->of->edge.at(active[i]->tried), before); },
            few_edges);
        if (auto carried = trial.advance_places(context.flow, now, options, stop); !carried)
            return tl::unexpected(carried.error());
        for (std::size_t i = 0; i < active.size(); ++i)
            active[i]->learn(trial.end[i] == CurveEnd::Running, trial.time[i], now);
        std::erase_if(active, [](const Search* search) { return search->done; });
    }
    Batch found(all.size());
    for_each_index(
        all.size(),
        [&](std::size_t i) {
            all[i]->of->part = all[i]->alive;
            found.set(i, all[i]->of->edge.at(all[i]->alive), before);
        },
        few_edges);
    if (auto carried = found.advance(context.flow, now, options, stop); !carried)
        return tl::unexpected(carried.error());
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i]->of->found = all[i]->of->part > 0.0;
        all[i]->of->carried = found[i];
    }
    return {};
}

namespace {

constexpr double thin = 0.2; ///< quality
/// The limits are in separations.
constexpr double tear_rim = 0.15;
constexpr double filament = 0.04;

/// A triangle that spans so much of the rake belongs to a sheet that was released as narrow as it is.
constexpr double whole_sheet = 0.2;

constexpr double sharp = 0.87; ///< cosine: 30 degrees

constexpr std::size_t speck = 24;      ///< triangles
constexpr std::size_t much_larger = 4; ///< times

/// Returns whether a triangle has two sides on the boundary that meet at a sharp angle: what tears leave is
/// not to be ragged.
bool is_tooth(const MovingMesh& mesh, TriangleId t) {
    const Triangle& here = mesh.triangles[t];
    for (unsigned k = 0; k < 3; ++k) {
        const unsigned before = (k + 2) % 3;
        if (here.across[k] == no_triangle && here.across[before] == no_triangle &&
            cosine_between(mesh.edge(here.begin(k), here.end(k)),
                           mesh.edge(here.begin(k), here.begin(before)), -1.0) > sharp)
            return true;
    }
    return false;
}

bool may_erode(const RefinementContext& context, TriangleId t, std::vector<TriangleId>& ring) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    unsigned open = 0;
    bool rim = false;
    for (unsigned k = 0; k < 3; ++k)
        if (here.across[k] == no_triangle) {
            ++open;
            rim = rim || on_rectangle_border(mesh, here.begin(k), here.end(k));
        }
    if (open == 0 || has_attached_vertex(mesh, t))
        return false;
    // The surface's boundary goes round by the vertex opposite.
    const auto& [a, b, c] = here.vertex;
    if (is_bridging(mesh, a, b, c))
        return true;
    const double span =
        std::max({std::abs(mesh.parameter_step(a, b).s), std::abs(mesh.parameter_step(b, c).s),
                  std::abs(mesh.parameter_step(c, a).s)});
    if (span > whole_sheet)
        return false;
    if (open > 1 && !rim && is_tooth(mesh, t))
        return true;
    if (!(quality(mesh, t) < thin))
        return false;
    const unsigned k = longest_edge_of(mesh, t);
    const double length = mesh.edge_length(here.begin(k), here.end(k));
    const double width = rim ? filament : tear_rim;
    if (!(glm::length(area_vector(mesh, t)) <= length * width * context.rules.separation))
        return false;
    if (open > 1)
        return true;
    // With its foot on the boundary it is a needle that a join takes away; with its tip there two parts would
    // hang together at that.
    return here.across[k] == no_triangle && !mesh.triangles.fan(here.opposite(k), ring);
}

} // namespace

std::vector<EdgeCrossing> edges_to_the_dead(const RefinementContext& context,
                                            std::span<const TriangleId> candidates) {
    const MovingMesh& mesh = context.mesh;
    const auto& ids = mesh.vertices.id;
    const auto add = [&](std::size_t i, std::vector<EdgeCrossing>& found) {
        const Triangle& t = mesh.triangles[candidates[i]];
        for (unsigned k = 0; t.live && k < 3; ++k) {
            const VertexId a = t.begin(k), b = t.end(k);
            if (mesh.vertices.dead(a) != mesh.vertices.dead(b))
                found.push_back(mesh.vertices.dead(a) ? EdgeCrossing{b, a} : EdgeCrossing{a, b});
        }
    };
    std::vector<EdgeCrossing> edges = gather<EdgeCrossing>(candidates.size(), add);
    const auto key = [&](const EdgeCrossing& e) { return std::pair(ids[e.living], ids[e.dead]); };
    sort_all(edges, [&](const EdgeCrossing& p, const EdgeCrossing& q) { return key(p) < key(q); });
    edges.erase(
        std::unique(edges.begin(), edges.end(),
                    [&](const EdgeCrossing& p, const EdgeCrossing& q) { return key(p) == key(q); }),
        edges.end());
    return edges;
}

void clip(const RefinementContext& context,
          std::span<const TriangleId> candidates,
          std::span<const EdgeCrossing> crossings,
          std::span<const VertexId> made) {
    MovingMesh& mesh = context.mesh;
    MaterialTriangles& triangles = mesh.triangles;
    const auto add = [&](std::size_t i, std::vector<VertexId>& found) {
        if (const Triangle& t = triangles[candidates[i]]; t.live)
            for (const VertexId v : t.vertex)
                if (mesh.vertices.dead(v))
                    found.push_back(v);
    };
    std::vector<VertexId> dead = gather<VertexId>(candidates.size(), add);
    for (std::size_t i = 0; i < crossings.size(); ++i)
        if (const auto [t, k] = triangles.find_either_way(crossings[i].living, crossings[i].dead);
            t != no_triangle)
            triangles.split(t, k, made[i]);
    const auto& ids = mesh.vertices.id;
    std::sort(dead.begin(), dead.end(), [&](VertexId a, VertexId b) { return ids[a] < ids[b]; });
    dead.erase(std::unique(dead.begin(), dead.end()), dead.end());
    std::vector<TriangleId> round;
    for (const VertexId v : dead)
        if (!triangles.unused(v)) {
            triangles.fan(v, round);
            for (const TriangleId t : round)
                if (triangles[t].live)
                    triangles.tear(t);
        }
}

void erode(const RefinementContext& context, std::span<const TriangleId> candidates) {
    MaterialTriangles& triangles = context.mesh.triangles;
    if (triangles.live() <= speck) // the whole surface is as small as that
        return;
    std::vector<TriangleId> ring;
    std::vector<TriangleId> queue = gather<TriangleId>(
        candidates.size(),
        [&](std::size_t i, std::vector<TriangleId>& found) {
            thread_local std::vector<TriangleId> its_ring;
            if (triangles[candidates[i]].live && may_erode(context, candidates[i], its_ring))
                found.push_back(candidates[i]);
        },
        few_triangles);
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const TriangleId t = queue[i];
        if (!triangles[t].live || !may_erode(context, t, ring))
            continue;
        for (const TriangleId next : triangles[t].across)
            if (next != no_triangle)
                queue.push_back(next);
        triangles.tear(t);
    }
}

void drop_specks(const RefinementContext& context, std::span<const TriangleId> candidates) {
    MaterialTriangles& triangles = context.mesh.triangles;
    std::vector<TriangleId> part;
    for (const TriangleId first : candidates) {
        const auto& across = triangles[first].across; // what has come off has a border
        if (!triangles[first].live ||
            std::find(across.begin(), across.end(), no_triangle) == across.end())
            continue;
        part.assign(1, first);
        bool held = false;
        for (std::size_t i = 0; i < part.size() && part.size() < speck && !held; ++i) {
            held = has_attached_vertex(context.mesh, part[i]);
            for (const TriangleId next : triangles[part[i]].across)
                if (next != no_triangle && std::find(part.begin(), part.end(), next) == part.end())
                    part.push_back(next);
        }
        if (held || part.size() >= speck || part.size() * much_larger > triangles.live())
            continue;
        for (const TriangleId t : part)
            if (triangles[t].live)
                triangles.tear(t);
    }
}

} // namespace wakesurf::core
