#include "server/data/levels/node_values.hpp"

#include "core/dataset/missing_bricks.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "server/base/field_names.hpp"
#include "store/brick_slabs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wakesurf::server {

namespace {

constexpr std::size_t nodes_at_once = std::size_t{1}
                                      << 16; ///< nodes whose places and samples are in memory

/// Returns the time-step at or before a time, and the part of the way to the next.
std::pair<std::size_t, double> moment_in(const std::vector<double>& times, double time) {
    const auto after = std::ranges::upper_bound(times, time);
    if (after == times.begin())
        return {0, 0.0};
    const auto step = static_cast<std::size_t>(after - times.begin() - 1);
    if (step + 1 == times.size())
        return {step, 0.0};
    return {step, (time - times[step]) / (times[step + 1] - times[step])};
}

/// Returns exactly `from` if `part` is 0.
float between(float from, float to, double part) {
    return part == 0.0 ? from : static_cast<float>(from + part * (double(to) - from));
}

core::Result<void> stored_values(const core::ScalarSource& scalars,
                                 std::size_t scalar,
                                 double time,
                                 std::span<float> out,
                                 const std::stop_token& stop) {
    const auto [step, part] = moment_in(scalars.times(), time);
    const auto first = scalars.scalar_values(scalar, step, stop);
    if (!first)
        return tl::unexpected(first.error());
    const auto* from = reinterpret_cast<const float*>((*first)->bytes().data());
    std::copy_n(from, out.size(), out.begin());
    if (part == 0.0)
        return {};
    const auto second = scalars.scalar_values(scalar, step + 1, stop);
    if (!second)
        return tl::unexpected(second.error());
    const auto* to = reinterpret_cast<const float*>((*second)->bytes().data());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = between(from[i], to[i], part);
    return {};
}

/// Reads values that are stored brick by brick.
core::Result<void> stored_bricks(const std::shared_ptr<core::BrickCache>& cache,
                                 std::size_t brick_field,
                                 const std::vector<double>& times,
                                 double time,
                                 std::span<float> out,
                                 const std::stop_token& stop) {
    const auto [step, part] = moment_in(times, time);
    std::vector<std::size_t> steps{step};
    if (part > 0.0)
        steps.push_back(step + 1);
    const auto first = cache->table(step, brick_field);
    const auto second = cache->table(steps.back(), brick_field);
    core::MissingBricks missing(cache, steps, brick_field);
    std::vector<bool> done(cache->layout().count());
    const auto some = [&](std::size_t begin, std::size_t end) {
        const core::BrickMisses misses(&missing);
        for (std::size_t brick = begin; brick != end && !stop.stop_requested(); ++brick) {
            if (done[brick])
                continue;
            const float* const from = first->at(brick);
            const float* const to = second->at(brick);
            if (from == nullptr || to == nullptr) {
                misses.want(brick);
                continue;
            }
            store::for_rows_of(cache->layout(), brick,
                               [&](std::size_t node, std::size_t to_node, std::size_t nodes) {
                                   for (std::size_t i = 0; i < nodes; ++i)
                                       out[to_node + i] =
                                           between(from[node + i], to[node + i], part);
                               });
            done[brick] = true;
        }
        return !stop.stop_requested();
    };
    if (core::MissingBricks::in_rounds(&missing, done.size(), stop,
                                       core::MissingBricks::Again::Restart, some))
        return {};
    return missing.error() ? tl::unexpected(*missing.error())
                           : core::fail(core::Error::Code::Cancelled, "reading was cancelled");
}

core::Result<void> sampled_values(const NodeField& field,
                                  const core::Flow& flow,
                                  std::span<const core::Vec3> places,
                                  double time,
                                  std::span<float> out,
                                  const std::stop_token& stop) {
    const std::vector<double> times(places.size(), time);
    if (field.source == NodeField::Source::Gradient) {
        const std::array wanted{static_cast<core::GradientField>(field.index)};
        return core::sample_gradient_fields(wanted, flow, places, times, stop)
            .map([&](const auto& values) { std::ranges::copy(values.front(), out.begin()); });
    }
    std::vector<core::Vec3> velocities(places.size());
    std::vector<std::uint8_t> gap(places.size(), 0);
    if (auto done = flow.sample(places, times, velocities, stop).and_then([&] {
            return flow.mark_gaps(places, times, gap, stop);
        });
        !done)
        return done;
    for (std::size_t i = 0; i < places.size(); ++i)
        out[i] = gap[i] != 0 ? std::numeric_limits<float>::quiet_NaN()
                 : field.source == NodeField::Source::Speed
                     ? static_cast<float>(glm::length(velocities[i]))
                     : static_cast<float>(velocities[i][static_cast<int>(field.index)]);
    return {};
}

} // namespace

core::Result<NodeField> find_node_field(const store::StoreScalars& scalars,
                                        const std::string& velocity,
                                        const std::string& name,
                                        std::span<const core::FieldInfo> of_files) {
    using Source = NodeField::Source;
    if (const auto scalar = scalars.find(name))
        return NodeField{name, Source::Scalar, *scalar};
    if (name == velocity)
        return NodeField{name, Source::Speed, 0};
    const auto& components = core::velocity_component_names;
    if (const auto found = std::ranges::find(components, name); found != components.end())
        return NodeField{name, Source::VelocityComponent,
                         static_cast<std::size_t>(found - components.begin())};
    if (const auto derived = core::find_gradient_field(name))
        return NodeField{name, Source::Gradient, static_cast<std::size_t>(*derived)};
    return tl::unexpected(
        no_such_field("field", name, node_field_names(scalars.names(), velocity), of_files));
}

core::Result<void> node_values(const NodeField& field,
                               const core::Flow& flow,
                               const store::StoreReader& store,
                               const store::StoreScalars& scalars,
                               double time,
                               std::span<float> out,
                               const std::stop_token& stop) {
    if (field.source == NodeField::Source::Scalar) {
        const auto brick_field = scalars.brick_field(field.index);
        const auto bricks = brick_field ? flow.bricks() : nullptr;
        const auto read =
            bricks ? stored_bricks(bricks, *brick_field, scalars.times(), time, out, stop)
                   : stored_values(scalars, field.index, time, out, stop);
        if (!read)
            return read;
    } else {
        std::vector<core::Vec3> places;
        for (std::size_t begin = 0; begin < out.size(); begin += places.size()) {
            places.resize(std::min(nodes_at_once, out.size() - begin));
            for (std::size_t i = 0; i < places.size(); ++i)
                places[i] = core::node_position(store.grid(), begin + i);
            if (auto done = sampled_values(field, flow, places, time,
                                           out.subspan(begin, places.size()), stop);
                !done)
                return done;
        }
    }
    const core::SolidMask& mask = store.mask();
    for (std::size_t i = 0; !mask.empty() && i < out.size(); ++i)
        if (!mask.is_fluid(i))
            out[i] = std::numeric_limits<float>::quiet_NaN();
    return {};
}

} // namespace wakesurf::server
