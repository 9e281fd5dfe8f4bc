#include "server/session/played_surface.hpp"

#include "core/surface/moving/moving_parts.hpp"

#include <algorithm>

namespace wakesurf::server {

using core::KeyedMesh;
using core::SurfaceStatistics;

namespace {

constexpr std::uint32_t of_second_part = std::uint32_t{1} << 31; ///< in ids

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// Adds the part that goes back in time, mirrored so that both face the same way.
void append_backward(KeyedMesh& to, const KeyedMesh& part, std::uint32_t id_bits) {
    const auto first = static_cast<core::VertexId>(to.mesh.vertices());
    append(to.mesh.position, part.mesh.position);
    append(to.mesh.s, part.mesh.s);
    append(to.mesh.t, part.mesh.t);
    append(to.mesh.velocity, part.mesh.velocity);
    append(to.mesh.deformation, part.mesh.deformation);
    append(to.mesh.component, part.mesh.component);
    append(to.mesh.approximated, part.mesh.approximated);
    for (core::Cell cell : part.mesh.cells) {
        for (auto* ids : {&cell.corner, &cell.mid})
            for (core::VertexId& v : *ids)
                if (v != core::no_vertex)
                    v += first;
        std::swap(cell.corner[0], cell.corner[1]);
        std::swap(cell.corner[2], cell.corner[3]);
        std::swap(cell.mid[1], cell.mid[3]);
        to.mesh.cells.push_back(cell);
    }
    for (const std::uint32_t id : part.vertex_id)
        to.vertex_id.push_back(id | id_bits);
    for (const std::uint32_t id : part.cell_id)
        to.cell_id.push_back(id | id_bits);
}

void add(SurfaceStatistics& sum, const SurfaceStatistics& part) {
    sum.kind = part.kind;
    sum.steps = std::max(sum.steps, part.steps);
    sum.vertex_steps += part.vertex_steps;
    sum.terminated.domain += part.terminated.domain;
    sum.terminated.obstacle += part.terminated.obstacle;
    sum.terminated.stagnation += part.terminated.stagnation;
    sum.terminated.budget += part.terminated.budget;
    sum.separation = std::max(sum.separation, part.separation);
    sum.seconds.load += part.seconds.load;
    sum.seconds.advect += part.seconds.advect;
    sum.seconds.refine += part.seconds.refine;
    sum.peak_bytes += part.peak_bytes;
}

} // namespace

core::Result<PlayedSurface> PlayedSurface::start(const SurfaceJob& job,
                                                 std::size_t budget_bytes,
                                                 const core::Clock& clock,
                                                 const std::stop_token& stop,
                                                 const core::WorkPart& work) {
    const auto parts = core::moving_parts(*job.flow, job.parameters);
    if (!parts)
        return tl::unexpected(parts.error());
    PlayedSurface played;
    for (const core::MovingPart& part : *parts) {
        auto moving = core::MovingSurface::start(*job.flow, job.rake, part.parameters, stop, clock,
                                                 work.above(played.bytes()));
        if (!moving)
            return tl::unexpected(moving.error());
        if (!work.above(played.bytes()).holds(2 * moving->state().bytes())) // its start is kept
            return core::fail(core::Error::Code::Cancelled,
                              "there is not enough memory for the surface");
        played.parts_.push_back(
            {core::SurfaceHistory(std::move(*moving), budget_bytes / parts->size()),
             part.parameters.from, part.sign});
    }
    return played;
}

void PlayedSurface::limit(std::size_t budget_bytes) {
    for (Part& part : parts_)
        part.history.limit(budget_bytes / parts_.size());
}

std::size_t PlayedSurface::bytes() const {
    std::size_t sum = 0;
    for (const Part& part : parts_)
        sum += part.history.bytes() + part.history.surface().state().bytes();
    return sum;
}

core::Result<KeyedMesh> PlayedSurface::part_at(Part& part,
                                               double age,
                                               const std::stop_token& stop,
                                               const core::WorkPart& work) {
    for (;;) {
        const double reach = std::min(age, part.most);
        const double end = part.history.surface().end_time();
        const double time = part.from + part.sign * reach;
        auto mesh = part.history.at(part.sign * (time - end) > 0.0 ? end : time, stop, work);
        if (mesh || !mesh.error().readable_until)
            return mesh;
        const double readable = part.sign * (*mesh.error().readable_until - part.from);
        if (!(readable > 0.0 && readable < reach))
            return mesh;
        part.most = readable;
        stopped_ = mesh.error().message;
    }
}

std::vector<double> PlayedSurface::Shown::times() const {
    std::vector<double> out(mesh.mesh.vertices(), time);
    for (std::size_t i = first_backward; i < out.size(); ++i)
        out[i] = time_backward;
    return out;
}

core::Result<PlayedSurface::Shown>
PlayedSurface::at(double age, const std::stop_token& stop, const core::WorkPart& work) {
    Shown shown;
    bool short_of = false;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        std::size_t others = core::memory_of(shown.mesh.mesh);
        for (const Part& each : parts_)
            others += &each == &part ? 0 : each.history.surface().state().bytes();
        auto mesh = part_at(part, age, stop, work.part(i, parts_.size()).above(others));
        if (!mesh)
            return tl::unexpected(mesh.error());
        short_of = short_of || age > part.most;
        if (part.sign > 0.0) {
            shown.time = mesh->time;
            shown.mesh = std::move(*mesh);
        } else {
            shown.time_backward = mesh->time;
            shown.first_backward = static_cast<core::VertexId>(shown.mesh.mesh.vertices());
            append_backward(shown.mesh, *mesh, parts_.size() > 1 ? of_second_part : 0);
        }
        add(shown.statistics, part.history.surface().statistics());
    }
    SurfaceStatistics& s = shown.statistics;
    s.quads = shown.mesh.mesh.cells.size();
    s.vertices = shown.mesh.mesh.vertices();
    s.approximated = static_cast<std::uint64_t>(
        std::count(shown.mesh.mesh.approximated.begin(), shown.mesh.mesh.approximated.end(), 1));
    s.max_edge = core::longest_edge(shown.mesh.mesh);
    s.terminated.time = s.vertices;
    s.seconds.total = s.seconds.load + s.seconds.advect + s.seconds.refine;
    if (short_of)
        s.stopped = stopped_;
    return shown;
}

} // namespace wakesurf::server
