#include "core/surface/moving/step_errors.hpp"

#include "core/base/for_each_index.hpp"
#include "core/integrate/advance_particle.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr int boxes = 16;          ///< along each axis of the domain
constexpr double share_kept = 0.7; ///< of what was learnt before

constexpr double share = 1.0 / 32.0; ///< of the vertices
constexpr double fewest = 16.0;

/// Halving the steps of RK4 leaves a sixteenth of the error where the field is smooth, a quarter where it has
/// a kink. And between the vertices of the sample others have larger errors.
constexpr double of_the_difference = 2.0;

/// The error in any direction is so many times the error across the surface, which is one of three.
constexpr double of_across = 2.0;

/// Returns a pseudo-random number, the same for the same vertex and turn.
std::uint32_t mixed(std::uint32_t id, std::uint64_t turn) {
    std::uint64_t x = (std::uint64_t(id) + 1) * 0x9e3779b97f4a7c15u + turn * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 31)) * 0x94d049bb133111ebu;
    return static_cast<std::uint32_t>(x >> 32);
}

bool moving(const MaterialVertices& v, VertexId i) {
    return v.role[i] == VertexRole::Free && v.end[i] == CurveEnd::Running;
}

template <class Visit>
void for_each_moving(const MovingMesh& mesh, Visit visit) {
    for_each_index(mesh.vertices.slots(), [&](std::size_t i) {
        if (const auto v = static_cast<VertexId>(i); moving(mesh.vertices, v))
            visit(v);
    });
}

} // namespace

StepErrors::StepErrors(const Box& domain)
    : low_(domain.lo), widest_(glm::length(domain.extent())),
      scale_(double(boxes) / glm::max(domain.extent(), Vec3(1e-300))),
      rate_(static_cast<std::size_t>(boxes * boxes * boxes), 0.0f) {}

std::size_t StepErrors::place(const Vec3& position) const {
    const glm::ivec3 box(glm::clamp((position - low_) * scale_, 0.0, boxes - 1.0));
    return static_cast<std::size_t>((box.z * boxes + box.y) * boxes + box.x);
}

void StepErrors::begin(double h) {
    // Fields with kinks are of second order, smooth ones of fourth.
    const double longer = step_ > 0.0 ? h / step_ : 1.0;
    const auto left = static_cast<float>(share_kept * std::pow(longer, longer > 1.0 ? 3.0 : 2.0));
    for (float& rate : rate_)
        rate *= left;
    largest_ *= left;
    step_ = h;
}

void StepErrors::learn(const Vec3& position, double rate) {
    const auto learnt = static_cast<float>(rate);
    if (!std::isfinite(learnt))
        return;
    // The error counts in all boxes within half a box.
    const Vec3 half = 0.5 / scale_;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) {
                float& known = rate_[place(position + half * Vec3(x, y, z))];
                known = std::max(known, learnt);
            }
    largest_ = std::max(largest_, learnt);
}

double StepErrors::at(const Vec3& position) const {
    const float known = rate_[place(position)];
    return double(known > 0.0f ? known : largest_);
}

StepSample::StepSample(const MovingMesh& mesh, std::uint64_t turn) : from_(mesh.time) {
    const MaterialVertices& v = mesh.vertices;
    const double wanted = std::max(share, fewest / static_cast<double>(v.slots() + 1));
    const double below = wanted * 4294967296.0;
    for (VertexId i = 0; i < v.slots(); ++i)
        if (moving(v, i) && double(mixed(v.id[i], turn)) < below) {
            vertex_.push_back(i);
            start_.push_back(v.position[i]);
            time_.push_back(v.time[i]);
            end_.push_back(CurveEnd::Running);
        }
    position_ = start_;
}

Result<void> StepSample::learn(StepErrors& errors,
                               const Flow& flow,
                               const MovingMesh& mesh,
                               AdvanceOptions options,
                               std::stop_token stop) {
    const MaterialVertices& v = mesh.vertices;
    const double dt = std::abs(mesh.time - from_);
    if (!(dt > 0.0))
        return {};
    const double h = dt / rk4_steps(dt, options);
    errors.begin(h);
    if (vertex_.empty())
        return {};
    options.step = 0.5 * h;
    const double tolerance = options.tolerance;
    options.tolerance /= 32.0; // halves steps of fifth order
    if (auto advanced = flow.advance({position_, {}, {}, time_, end_}, mesh.time, options, stop);
        !advanced)
        return tl::unexpected(advanced.error());
    for (std::size_t i = 0; i < vertex_.size(); ++i) {
        if (end_[i] != CurveEnd::Running || v.end[vertex_[i]] != CurveEnd::Running)
            continue;
        const double apart =
            mesh.vertices.tangents(vertex_[i]).across(position_[i] - v.position[vertex_[i]]);
        // Error control allows the tolerance, and rare places use it up.
        const double allowed = options.method == AdvanceOptions::Method::Dopri5
                                   ? tolerance * glm::length(position_[i] - start_[i])
                                   : 0.0;
        const double rate = std::max(of_the_difference * apart, allowed) / dt;
        errors.learn(start_[i], rate);
        errors.learn(position_[i], rate);
    }
    return {};
}

void add_step_errors(MovingMesh& mesh, const StepErrors& errors, double since) {
    const double time = std::abs(mesh.time - since);
    for_each_moving(mesh, [&](VertexId i) {
        const SurfaceTangents at = mesh.vertices.tangents(i);
        const double across = errors.at(mesh.vertices.position[i]) * time;
        mesh.vertices.error[i].traced.add(at, across);
        mesh.vertices.error[i].apart.add(at, of_across * across);
    });
}

std::vector<VertexId> vertices_beyond(const MovingMesh& mesh, double trusted) {
    std::vector<std::uint8_t> beyond(mesh.vertices.slots(), 0);
    for_each_moving(mesh, [&](VertexId i) {
        beyond[i] = mesh.vertices.error[i].apart.length(mesh.vertices.tangents(i)) > trusted;
    });
    std::vector<VertexId> found;
    for (VertexId i = 0; i < beyond.size(); ++i)
        if (beyond[i] != 0)
            found.push_back(i);
    return found;
}

float stated_error(const MovingMesh& mesh, VertexId v, const StepErrors& errors, double since) {
    if (!moving(mesh.vertices, v))
        return 0.0f;
    const double error = mesh.vertices.error[v].across(mesh.vertices.tangents(v)) +
                         errors.at(mesh.vertices.position[v]) * std::abs(mesh.time - since);
    // Nothing is farther than the domain is wide, nor what is no number.
    const double widest = errors.largest_distance();
    return static_cast<float>(error < widest ? error : widest);
}

} // namespace wakesurf::core
