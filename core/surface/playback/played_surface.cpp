#include "core/surface/playback/played_surface.hpp"

#include "core/surface/emptiness.hpp"
#include "core/surface/moving/joined_parts.hpp"
#include "core/surface/moving/moving_parts.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

constexpr std::uint32_t of_second_part = std::uint32_t{1} << 31; ///< in ids

void append_ids(std::vector<std::uint32_t>& to,
                const std::vector<std::uint32_t>& from,
                std::uint32_t bits) {
    for (const std::uint32_t id : from)
        to.push_back(id | bits);
}

/// Adds the part that goes back in time.
void append_backward(KeyedMesh& to, const KeyedMesh& part, std::uint32_t id_bits) {
    append(to.mesh, part.mesh, true);
    append_ids(to.vertex_id, part.vertex_id, id_bits);
    append_ids(to.cell_id, part.cell_id, id_bits);
}

} // namespace

Result<PlayedSurface> PlayedSurface::start(const Flow& flow,
                                           const Rake& rake,
                                           const SurfaceParameters& parameters,
                                           std::size_t budget_bytes,
                                           const Clock& clock,
                                           const std::stop_token& stop,
                                           const WorkPart& work) {
    const auto parts = moving_parts(flow, parameters);
    if (!parts)
        return tl::unexpected(parts.error());
    PlayedSurface played(flow, rake, parameters);
    for (const MovingPart& part : *parts) {
        auto moving = MovingSurface::start(flow, rake, part.parameters, stop, clock,
                                           work.above(played.bytes()));
        if (!moving)
            return tl::unexpected(moving.error());
        if (!work.above(played.bytes()).holds(2 * moving->state().bytes())) // its start is kept
            return fail(Error::Code::Cancelled, "there is not enough memory for the surface");
        played.parts_.push_back({SurfaceHistory(std::move(*moving), budget_bytes / parts->size()),
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

Result<KeyedMesh>
PlayedSurface::part_at(Part& part, double age, const std::stop_token& stop, const WorkPart& work) {
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

Result<PlayedSurface::Shown>
PlayedSurface::at(double age, const std::stop_token& stop, const WorkPart& work) {
    Shown shown;
    bool short_of = false;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        std::size_t others = memory_of(shown.mesh.mesh);
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
            shown.first_backward = static_cast<VertexId>(shown.mesh.mesh.vertices());
            append_backward(shown.mesh, *mesh, parts_.size() > 1 ? of_second_part : 0);
        }
        add(shown.statistics, part.history.surface().statistics());
    }
    SurfaceStatistics& s = shown.statistics;
    count(s, shown.mesh.mesh);
    s.seconds.total = s.seconds.load + s.seconds.advect + s.seconds.refine;
    if (short_of)
        s.stopped = stopped_;
    auto empty = why_empty(*flow_, rake_, parameters_, shown.mesh.mesh, s, stop);
    if (!empty)
        return tl::unexpected(empty.error());
    s.empty = std::move(*empty);
    return shown;
}

} // namespace wakesurf::core
