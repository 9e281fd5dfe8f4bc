#include "core/surface/moving/crossing.hpp"

#include <vector>

namespace wakesurf::core {

namespace {

constexpr double close_enough = 1e-7; ///< of an edge
constexpr int halvings = 24;
constexpr int search_rounds = 24;

/// Particles that are carried together from one time to another.
struct Batch {
    std::vector<Vec3> position, along_s, along_t;
    std::vector<double> time;
    std::vector<CurveEnd> end;

    void add(const Carried& carried, double at) {
        position.push_back(carried.position);
        along_s.push_back(carried.along_s);
        along_t.push_back(carried.along_t);
        time.push_back(at);
        end.push_back(CurveEnd::Running);
    }

    Carried operator[](std::size_t i) const { return {position[i], along_s[i], along_t[i]}; }

    Result<TraceCost> advance(const Flow& flow,
                              double to,
                              const AdvanceOptions& options,
                              const std::stop_token& stop) {
        return flow.advance({position, along_s, along_t, time, end}, to, options, stop);
    }
};

/// The search on one edge.
struct Search {
    EdgeCrossing* of;
    double alive = 0.0; ///< part of the way at which a particle still lives at the end of the step
    double dead = 1.0;  ///< and at which it does not
    double died;        ///< when that one did
    double dead_before = 1.0, died_before = 0.0; ///< of the sample before it
    int deaths = 1;
    double tried = 0.5;
    bool done = false;

    /// Just before the part of the way at which a particle would end with the step, by the last two; half-way
    /// where they do not tell, as where particles graze the boundary.
    double next(double now) const {
        const double middle = 0.5 * (alive + dead);
        if (deaths < 2 || died == died_before)
            return middle;
        const double guess =
            dead + (now - died) * (dead - dead_before) / (died - died_before) - 0.3 * close_enough;
        return guess > alive && guess < dead ? guess : middle;
    }

    void learn(const Carried& carried, bool lives, double time, double now) {
        if (lives) {
            alive = tried;
            of->part = tried;
            of->carried = carried;
            of->found = true;
        } else {
            dead_before = dead;
            died_before = died;
            dead = tried;
            died = time;
            ++deaths;
        }
        done = dead - alive < close_enough;
        tried = next(now);
    }
};

/// On the edge as it is now, its dead end carried on at its last velocity.
void search_now(const RefinementContext& context, EdgeCrossing& crossing) {
    const MaterialVertices& v = context.mesh.vertices;
    EdgeCubic& edge = crossing.edge;
    edge = edge_cubic(context.mesh, crossing.living, crossing.dead);
    edge.b.position +=
        Vec3(v.velocity[crossing.dead]) * (context.mesh.time - v.time[crossing.dead]);
    const auto inside = [&](double part) {
        return context.flow.status(edge.at(part).position) == PointStatus::Inside;
    };
    if (inside(1.0))
        return;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (inside(middle) ? low : high) = middle;
    }
    crossing.found = low > 0.0;
    crossing.part = low;
    crossing.carried = edge.at(low);
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
        // What was released in this step, of a streak surface, was not there at its beginning.
        return v.role[x] == VertexRole::Free &&
               (mesh.lattice.last_row > 0.0 || sign * (v.t[x] - before) <= 0.0);
    };
    std::vector<Search> searches;
    Batch living, dead;
    for (EdgeCrossing& each : crossings) {
        if (v.end[each.dead] != CurveEnd::Domain && v.end[each.dead] != CurveEnd::Obstacle)
            continue;
        // What is traced again may turn out to have ended long ago, somewhere else.
        if (sign * (v.time[each.dead] - before) < 0.0)
            continue;
        if (!moved_all_step(each.living) || !moved_all_step(each.dead) || now == before) {
            search_now(context, each);
            continue;
        }
        living.add(v.point(each.living).carried, now);
        dead.add(v.point(each.dead).carried, v.time[each.dead]);
        searches.push_back({&each, 0.0, 1.0, v.time[each.dead]});
    }
    for (Batch* batch : {&living, &dead})
        if (auto back = batch->advance(context.flow, before, options, stop); !back)
            return tl::unexpected(back.error());
    for (std::size_t i = 0; i < searches.size(); ++i) {
        Search& search = searches[i];
        search.of->edge = {living[i], dead[i],
                           mesh.parameter_step(search.of->living, search.of->dead)};
        if (living.end[i] != CurveEnd::Running || dead.end[i] != CurveEnd::Running) {
            search_now(context, *search.of);
            search.done = true;
        }
    }
    for (int round = 0; round < search_rounds; ++round) {
        Batch trial;
        std::vector<Search*> active;
        for (Search& search : searches)
            if (!search.done) {
                active.push_back(&search);
                trial.add(search.of->edge.at(search.tried), before);
            }
        if (active.empty())
            return {};
        if (auto carried = trial.advance(context.flow, now, options, stop); !carried)
            return tl::unexpected(carried.error());
        for (std::size_t i = 0; i < active.size(); ++i)
            active[i]->learn(trial[i], trial.end[i] == CurveEnd::Running, trial.time[i], now);
    }
    return {};
}

} // namespace wakesurf::core
