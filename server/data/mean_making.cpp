#include "server/data/mean_making.hpp"

#include "core/base/blocking_wait.hpp"
#include "core/dataset/brick_source.hpp"
#include "core/dataset/time_means.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <numeric>
#include <span>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;
using core::TimeMeans;

namespace {

/// Returns the mean that the plan would make, if it is there. Error: InvalidArgument where another one has a
/// name of it.
Result<std::optional<core::MeanRecord>> made_before(const std::vector<core::MeanRecord>& there,
                                                    const MeanPlan& plan) {
    for (const core::MeanRecord& each : there) {
        if (each.same_values(plan.record))
            return each;
        for (const core::MeanField& field : each.fields)
            if (std::ranges::find(plan.record.fields, field.name, &core::MeanField::name) !=
                plan.record.fields.end())
                return fail(Error::Code::InvalidArgument,
                            fmt::format("there is a {} already, over {:g} to {:g}", field.name,
                                        each.from, each.to),
                            "choose another `label`, or remove it first");
    }
    return std::optional<core::MeanRecord>();
}

/// Places come in the order of the store's files: nodes, or those of one brick after the other.
struct Places {
    explicit Places(const store::StoreReader& store)
        : store_(store),
          unit(store.bricks() == nullptr ? 1 : store.bricks()->layout().nodes_per_brick()),
          units(store.bricks() == nullptr ? core::node_count(store.grid())
                                          : store.bricks()->layout().count()) {}

    const store::StoreReader& store_;
    std::size_t unit;  ///< places that are read and written together
    std::size_t units; ///< of them
};

/// Reads bricks that are neighbours on the disk, and waits for them.
Result<void> read_bricks(const core::BrickSource& source,
                         std::size_t step,
                         std::size_t field,
                         std::size_t first,
                         std::span<float> out,
                         std::size_t values,
                         const std::stop_token& stop) {
    std::vector<core::BrickRead> reads;
    for (std::size_t at = 0; at < out.size(); at += values)
        reads.push_back(
            {step, source.layout().brick_on_disk(first++), out.subspan(at, values), field});
    std::mutex mutex;
    std::condition_variable all;
    std::size_t left = reads.size();
    Result<void> outcome;
    source.read(std::move(reads), stop, [&](std::size_t, Result<void> one) {
        const std::scoped_lock lock(mutex);
        if (!one && outcome)
            outcome = std::move(one);
        if (--left == 0)
            all.notify_all(); // under the lock: nothing of this is touched afterwards
    });
    const core::BlockingWait blocked;
    std::unique_lock lock(mutex);
    all.wait(lock, [&] { return left == 0; });
    return outcome;
}

/// Gives the values of a source at a time-step, piece by piece.
class Source {
  public:
    Source(const LoadedDataset& dataset, const MeanPlan& plan) : dataset_(dataset), plan_(plan) {}

    /// Returns the bytes that a time-step takes beside the piece.
    std::size_t bytes() const {
        const store::StoreReader& store = *dataset_.store;
        return store.bricks() != nullptr ? 0 : store.bytes_per_step() / 3 * plan_.components();
    }

    /// @param values  for the piece, where it is not in memory as a whole
    Result<std::span<const float>> read(std::size_t step,
                                        const Places& places,
                                        std::size_t first,
                                        std::span<float> values,
                                        const std::stop_token& stop) {
        const store::StoreReader& store = *dataset_.store;
        if (store.bricks() != nullptr)
            return read_bricks(*store.bricks(), step, plan_.column, first, values,
                               places.unit * plan_.components(), stop)
                .map([&] { return std::span<const float>(values); });
        return whole(step, stop).map([&](std::span<const float> all) {
            return all.subspan(first * plan_.components(), values.size());
        });
    }

  private:
    Result<std::span<const float>> whole(std::size_t step, const std::stop_token& stop) {
        const store::StoreReader& store = *dataset_.store;
        if (plan_.components() == 3)
            return store.load(step, stop).map([&](auto loaded) {
                velocity_ = std::move(loaded);
                return velocity_->velocity();
            });
        if (plan_.source.source != NodeField::Source::Scalar)
            return dataset_.levels->values(plan_.source.name, store.times()[step], stop)
                .map([&](auto found) {
                    derived_ = std::move(found);
                    return std::span<const float>(derived_->values);
                });
        return store.load_scalar(plan_.source.index, step, stop).map([&](core::Slab loaded) {
            scalar_ = std::move(loaded);
            return std::span(reinterpret_cast<const float*>(scalar_.bytes().data()),
                             scalar_.bytes().size() / sizeof(float));
        });
    }

    const LoadedDataset& dataset_;
    const MeanPlan& plan_;
    std::shared_ptr<const core::TimeStep> velocity_;
    std::shared_ptr<const core::NodeValues> derived_;
    core::Slab scalar_;
};

/// How many units are averaged at a time, so that what that takes fits into the memory that is free.
Result<std::size_t>
units_at_once(const MeanPlan& plan, const Places& places, const core::WorkPart& work) {
    const std::size_t unit = TimeMeans::bytes(places.unit, plan.components()) +
                             places.unit * sizeof(float) * (plan.components() + 1);
    // Whole time-steps are read again for every piece, bricks are not: few large pieces.
    constexpr std::size_t least = std::size_t{1} << 20;
    const std::size_t most = std::size_t{places.unit > 1 ? 512U : 4096U} << 20U;
    std::size_t units = std::clamp<std::size_t>(most / unit, 1, places.units);
    if (work.memory() == nullptr)
        return units;
    while (units > 1 && units * unit > least && !work.memory()->grow_within_free(units * unit))
        units = (units + 1) / 2;
    if (units > 1 && units * unit > least)
        return units;
    return work.takes(units * unit).map([&] { return units; });
}

void widen(std::array<double, 2>& range, std::span<const float> values) {
    for (const float value : values)
        if (std::isfinite(value))
            range = {std::min(range[0], double{value}), std::max(range[1], double{value})};
}

/// Averages the time-steps of one file, and appends the values to those of the plan's fields.
Result<void> average(MeanPlan& plan,
                     std::span<const std::size_t> chosen, ///< of the plan's steps
                     Source& source,
                     const Places& places,
                     std::size_t at_once,
                     store::MeanWriter& writer,
                     const std::stop_token& stop,
                     const core::WorkPart& work) {
    std::vector<float> values, out;
    for (std::size_t first = 0; first < places.units; first += at_once) {
        const std::size_t count = std::min(at_once, places.units - first) * places.unit;
        TimeMeans means(count, plan.components());
        values.resize(count * plan.components());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (stop.stop_requested())
                return fail(Error::Code::Cancelled, "making the mean was cancelled");
            const auto read = source.read(plan.steps[chosen[i]], places, first, values, stop);
            if (!read)
                return tl::unexpected(read.error());
            means.add(*read, plan.weights[chosen[i]]);
            const double pieces = static_cast<double>(first) / static_cast<double>(at_once) +
                                  static_cast<double>(i + 1) / static_cast<double>(chosen.size());
            work.reached(pieces * static_cast<double>(at_once) / static_cast<double>(places.units));
        }
        out.resize(count);
        for (std::size_t field = 0; field < plan.outputs.size(); ++field) {
            for (std::size_t place = 0; place < count; ++place)
                out[place] = static_cast<float>(plan.outputs[field].value(means, place));
            widen(plan.record.fields[field].range, out);
            if (auto written = writer.append(field, out); !written)
                return written;
        }
    }
    return {};
}

Result<void> write_all(MeanPlan& plan,
                       const LoadedDataset& dataset,
                       store::MeanWriter& writer,
                       const std::stop_token& stop,
                       const core::WorkPart& work) {
    const Places places(*dataset.store);
    Source source(dataset, plan);
    const std::size_t before = work.memory() == nullptr ? 0 : work.memory()->bytes();
    if (auto held = work.takes(source.bytes()); !held)
        return held;
    const auto at_once = units_at_once(plan, places, work);
    if (!at_once)
        return tl::unexpected(at_once.error());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (core::MeanField& each : plan.record.fields)
        each.range = {infinity, -infinity};
    Result<void> outcome;
    for (std::size_t file = 0; file < plan.files() && outcome; ++file)
        outcome =
            writer.begin_files(plan.outputs.size())
                .and_then([&] {
                    return average(plan, plan.steps_in(file, dataset.store->times()), source,
                                   places, *at_once, writer, stop, work.part(file, plan.files()));
                })
                .and_then([&] { return writer.end_files(); });
    for (core::MeanField& each : plan.record.fields)
        if (each.range[0] > each.range[1])
            each.range = {0.0, 0.0}; // no place has a value
    if (work.memory() != nullptr)
        work.gives_back(work.memory()->bytes() - before);
    return outcome;
}

Result<core::MeanRecord> make_one(const LoadedDataset& dataset,
                                  const MeanWish& wish,
                                  MeanPlan plan,
                                  const std::stop_token& stop,
                                  const core::WorkPart& work) {
    const store::StoreReader& store = *dataset.store;
    const auto marks = store.marks();
    const auto source = store::source_mark(marks, plan.steps, plan.column);
    auto writer = store::MeanWriter::begin(store.layout(), marks);
    if (!writer)
        return tl::unexpected(writer.error());
    std::vector<core::MeanRecord> there;
    for (const store::StoredMean& each : writer->there())
        there.push_back(each.record);
    auto before = made_before(there, plan);
    if (!before)
        return tl::unexpected(before.error());
    if (*before)
        return std::move(**before);
    if (there.size() >= wish.most)
        return core::over_limit(
            wish.most, fmt::format("the dataset has {} means already", there.size()),
            wish.most < store::most_means ? "ask someone with the server's token, who may make more"
                                          : "remove one");
    if (auto written = write_all(plan, dataset, *writer, stop, work); !written)
        return tl::unexpected(written.error());
    if (!store.refresh().value_or(false))
        return fail(Error::Code::Io, "the data were replaced while the mean was made",
                    "make it again");
    return writer->keep(plan.record, source.value_or(0)).map([&] { return plan.record; });
}

/// Leaves out those that are there.
Result<void> check_room(const LoadedDataset& dataset, std::span<const MeanPlan> plans) {
    const Places places(*dataset.store);
    std::uint64_t bytes = 0;
    for (const MeanPlan& plan : plans) {
        const auto before = made_before(dataset.scalars->means(), plan);
        if (!before)
            return tl::unexpected(before.error());
        if (!*before)
            bytes += std::uint64_t{places.units} * places.unit * sizeof(float) *
                     plan.outputs.size() * plan.files();
    }
    return bytes == 0 ? Result<void>()
                      : store::check_room_for(dataset.store->layout().folder, bytes, "means");
}

} // namespace

Result<void> check_means(const LoadedDataset& dataset, const MeanWish& wish) {
    return plan_means(dataset, wish).and_then([&](const std::vector<MeanPlan>& plans) {
        return check_room(dataset, plans);
    });
}

Result<std::vector<core::MeanRecord>> make_means(const LoadedDataset& dataset,
                                                 const MeanWish& wish,
                                                 const std::stop_token& stop,
                                                 const core::WorkPart& work) {
    auto plans = plan_means(dataset, wish);
    if (!plans)
        return tl::unexpected(plans.error());
    if (auto room = check_room(dataset, *plans); !room)
        return tl::unexpected(room.error());
    std::vector<core::MeanRecord> out;
    for (std::size_t i = 0; i < plans->size(); ++i) {
        MeanPlan& plan = (*plans)[i];
        // One that is there is answered also where nothing can be written any more.
        auto known = made_before(dataset.scalars->means(), plan);
        if (known && *known) {
            out.push_back(std::move(**known));
            continue;
        }
        auto made = make_one(dataset, wish, std::move(plan), stop, work.part(i, plans->size()));
        if (!made)
            return tl::unexpected(made.error());
        out.push_back(std::move(*made));
    }
    return out;
}

Result<void> remove_mean(const LoadedDataset& dataset, const std::string& name) {
    return check_kept_here(dataset).and_then(
        [&] { return store::remove_mean(dataset.store->layout().folder, name); });
}

} // namespace wakesurf::server
