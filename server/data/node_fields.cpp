#include "server/data/node_fields.hpp"

#include "core/base/blocking_wait.hpp"
#include "core/dataset/missing_bricks.hpp"
#include "core/field/velocity_gradient.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "server/base/field_names.hpp"
#include "store/brick_slabs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
    const auto read_bricks = [&](std::size_t begin, std::size_t end) {
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
                                       core::MissingBricks::Again::Restart, read_bricks))
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

tl::unexpected<core::Error> cancelled() {
    return core::fail(core::Error::Code::Cancelled, "the level set was cancelled");
}

constexpr std::chrono::milliseconds memory_patience{
    1000}; ///< the wait for others to release memory

} // namespace

struct NodeFields::Loaded {
    NodeField field;
    double time = 0.0;
    core::NodeValues values;
    core::MemoryAccount::Share share;
};

/// The turn of the one thread that loads. REQUIRES at its beginning: mutex_ is locked; at its end: it is not.
class NodeFields::Turn {
  public:
    explicit Turn(const NodeFields& of) : of_(of) { of_.loading_ = true; }

    ~Turn() {
        const std::scoped_lock lock(of_.mutex_);
        of_.loading_ = false;
        of_.idle_.notify_all();
    }

    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

  private:
    const NodeFields& of_;
};

NodeFields::NodeFields(std::shared_ptr<const core::Flow> flow,
                       std::shared_ptr<const store::StoreReader> store,
                       std::string velocity,
                       Options options,
                       std::shared_ptr<const store::StoreScalars> scalars)
    : flow_(std::move(flow)), store_(std::move(store)),
      scalars_(scalars ? std::move(scalars) : store::StoreScalars::open(store_, store_->disk())),
      velocity_(std::move(velocity)), options_(std::move(options)) {
    if (options_.account)
        ticket_ = options_.account->on_need(core::ReclaimOrder::Histories, [this](std::size_t) {
            std::shared_ptr<const Loaded> freed; // after the lock
            const std::scoped_lock lock(mutex_);
            freed = std::exchange(loaded_, nullptr);
        });
}

NodeFields::~NodeFields() {
    ticket_.reset(); // waits for a running call
}

namespace {

core::Result<NodeField> named_field(const std::string& name,
                                    const std::string& velocity,
                                    const store::StoreScalars* scalars,
                                    std::span<const core::FieldInfo> of_files,
                                    std::string_view parameter = "field") {
    using Source = NodeField::Source;
    if (scalars != nullptr)
        if (const auto scalar = scalars->find(name))
            return NodeField{name, Source::Scalar, *scalar};
    if (name == velocity)
        return NodeField{name, Source::Speed, 0};
    const auto& components = core::velocity_component_names;
    if (const auto found = std::ranges::find(components, name); found != components.end())
        return NodeField{name, Source::VelocityComponent,
                         static_cast<std::size_t>(found - components.begin())};
    if (const auto derived = core::find_gradient_field(name))
        return NodeField{name, Source::Gradient, static_cast<std::size_t>(*derived)};
    const auto stored = scalars == nullptr ? std::vector<std::string>{} : scalars->names();
    return tl::unexpected(
        no_such_field(parameter, name, node_field_names(stored, velocity), of_files));
}

} // namespace

core::Result<NodeField> find_node_field(const std::string& name,
                                        const core::DatasetInfo& info,
                                        const store::StoreScalars* scalars,
                                        std::string_view parameter) {
    return named_field(name, info.velocity, scalars, info.fields, parameter);
}

core::SampledField sampled(const NodeField& field, const store::StoreScalars* scalars) {
    switch (field.source) {
    case NodeField::Source::Scalar:
        return core::StoredScalar{scalars, field.index};
    case NodeField::Source::VelocityComponent: {
        core::Vec3 direction(0.0);
        direction[static_cast<int>(field.index)] = 1.0;
        return core::VelocityAlong{direction};
    }
    case NodeField::Source::Gradient:
        return static_cast<core::GradientField>(field.index);
    case NodeField::Source::Speed:
        break;
    }
    return core::SpeedField{};
}

core::Result<NodeField> NodeFields::find(const std::string& name) const {
    return named_field(name, velocity_, scalars_.get(), options_.of_files);
}

core::Result<void> NodeFields::check_field(const std::string& name) const {
    return find(name).map([](const NodeField&) {});
}

core::Result<std::shared_ptr<const core::NodeValues>>
NodeFields::values(const std::string& name, double time, const std::stop_token& stop) const {
    const auto field = find(name);
    if (!field)
        return tl::unexpected(field.error());
    const auto shared = [](const std::shared_ptr<const Loaded>& loaded) {
        return std::shared_ptr<const core::NodeValues>(loaded, &loaded->values);
    };
    std::shared_ptr<const Loaded> before; // freed after the lock
    std::unique_lock lock(mutex_);
    if (loading_) {
        const core::BlockingWait blocked;
        if (!idle_.wait(lock, stop, [&] { return !loading_; }))
            return cancelled();
    }
    if (loaded_ && loaded_->field == *field && loaded_->time == time)
        return shared(loaded_);
    const Turn turn(*this);
    before = std::exchange(loaded_, nullptr);
    lock.unlock();
    before.reset();
    auto loaded = load(*field, time, stop);
    lock.lock();
    if (loaded)
        loaded_ = *loaded;
    lock.unlock();
    return loaded.map(shared);
}

core::Result<std::shared_ptr<const NodeFields::Loaded>>
NodeFields::load(const NodeField& field, double time, const std::stop_token& stop) const {
    auto out = std::make_shared<Loaded>();
    out->field = field;
    out->time = time;
    const std::size_t nodes = core::node_count(grid());
    if (options_.account) {
        out->share = options_.account->open(core::MemoryUse::Histories);
        if (!out->share.grow_to(nodes * sizeof(float), stop, memory_patience))
            return tl::unexpected(
                options_.account->refusal("a level set of this dataset", nodes * sizeof(float)));
    }
    core::NodeValues& found = out->values;
    found.values.resize(nodes);
    if (auto done = read(field, time, found.values, stop); !done)
        return tl::unexpected(std::move(done.error()));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 2> range{infinity, -infinity};
    for (const float each : found.values)
        if (std::isfinite(each))
            range = {std::min(range[0], double{each}), std::max(range[1], double{each})};
    found.any = range[0] <= range[1];
    if (found.any)
        found.range = range;
    else if (field.source == NodeField::Source::Scalar)
        found.times = scalars_->times_of(field.index);
    return out;
}

core::Result<void> NodeFields::read(const NodeField& field,
                                    double time,
                                    std::span<float> out,
                                    const std::stop_token& stop) const {
    if (field.source == NodeField::Source::Scalar) {
        const auto brick_field = scalars_->brick_field(field.index);
        const auto bricks = brick_field ? flow_->bricks() : nullptr;
        if (auto done =
                bricks ? stored_bricks(bricks, *brick_field, scalars_->times(), time, out, stop)
                       : stored_values(*scalars_, field.index, time, out, stop);
            !done)
            return done;
    } else {
        std::vector<core::Vec3> places;
        for (std::size_t begin = 0; begin < out.size(); begin += places.size()) {
            places.resize(std::min(nodes_at_once, out.size() - begin));
            for (std::size_t i = 0; i < places.size(); ++i)
                places[i] = core::node_position(grid(), begin + i);
            if (auto done = sampled_values(field, *flow_, places, time,
                                           out.subspan(begin, places.size()), stop);
                !done)
                return done;
        }
    }
    const core::SolidMask& mask = store_->mask();
    for (std::size_t i = 0; !mask.empty() && i < out.size(); ++i)
        if (!mask.is_fluid(i))
            out[i] = std::numeric_limits<float>::quiet_NaN();
    return {};
}

} // namespace wakesurf::server
