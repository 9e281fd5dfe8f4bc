#include "server/data/family_making.hpp"

#include "core/base/rounding.hpp"
#include "server/base/field_names.hpp"
#include "server/remote/remote_dataset.hpp"
#include "store/stored_families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;

namespace {

constexpr std::size_t longest_name = 64;
constexpr std::size_t most_steps = 64;

/// Returns true if a field that is no family has that name, or what every dataset has.
bool taken(const LoadedDataset& dataset, const std::string& name) {
    auto others = dataset.info.fields;
    std::erase_if(others, [](const core::FieldInfo& each) { return each.family; });
    return is_taken(name, dataset.info.velocity, others);
}

Error name_taken(const std::string& name) {
    return {Error::Code::InvalidArgument, "the dataset has a field " + name + " already",
            "choose another name, or remove the family of that name"};
}

Result<void> check_name(const LoadedDataset& dataset, const std::string& name) {
    const bool plain = std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-' || c == '.';
    });
    if (name.empty() || name.size() > longest_name || !plain)
        return fail(Error::Code::InvalidArgument,
                    "the name of a family must be 1 to 64 letters, "
                    "digits, or _ - .",
                    "for example psi");
    if (taken(dataset, name))
        return tl::unexpected(name_taken(name));
    return {};
}

/// Checks that no family of the name was made meanwhile, and that there is room for another one.
Result<void> check_unmade(const std::vector<store::StoredFamily>& all, const FamilyWish& wish) {
    if (std::ranges::any_of(all, [&](const auto& each) { return each.record.name == wish.name; }))
        return tl::unexpected(name_taken(wish.name));
    if (all.size() >= wish.most)
        return core::over_limit(wish.most,
                                fmt::format("the dataset has {} families already", all.size()),
                                wish.most < store::most_families
                                    ? "ask someone with the server's token, who may make more"
                                    : "remove one");
    return {};
}

Result<std::vector<std::size_t>> steps_of(const LoadedDataset& dataset,
                                          const std::vector<double>& asked) {
    const std::vector<double>& times = dataset.store->times();
    if (asked.empty())
        return std::vector<std::size_t>{0};
    std::vector<std::size_t> steps;
    for (const double time : asked) {
        if (!core::within_rounding(time, times.front(), times.back()))
            return fail(Error::Code::OutOfTime,
                        fmt::format("time {} is outside the data's {} to {}", time, times.front(),
                                    times.back()),
                        "choose a time inside it");
        const auto nearest = std::ranges::min_element(
            times, {}, [time](double each) { return std::abs(each - time); });
        steps.push_back(static_cast<std::size_t>(nearest - times.begin()));
    }
    std::ranges::sort(steps);
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    if (steps.size() > most_steps)
        return core::over_limit(most_steps, "a family may have at most 64 time-steps",
                                "make several");
    return steps;
}

Result<core::SourceScalar> scalar_of(const LoadedDataset& dataset,
                                     const core::FamilyRequest& request) {
    if (std::holds_alternative<core::Rake>(request.source) ||
        core::coordinate_axis(request.scalar) >= 0)
        return core::SourceScalar{};
    const auto found = dataset.scalars->find(request.scalar);
    if (!found) {
        auto there = dataset.scalars->names();
        there.insert(there.end(), {"x", "y", "z"});
        return fail(Error::Code::InvalidArgument,
                    "there is no scalar field " + request.scalar + " to begin with",
                    field_hint(request.scalar, there));
    }
    return core::SourceScalar{dataset.scalars.get(), *found};
}

/// Returns nodes all over the grid, for an estimate of the speed.
std::vector<core::Vec3> some_nodes(const core::Grid& grid) {
    constexpr std::size_t most = 4096;
    const std::size_t all = core::node_count(grid);
    std::vector<core::Vec3> out;
    // An odd stride: nodes of an even row are not all in the same place of it.
    const std::size_t stride = std::max<std::size_t>(1, all / most) | 1u;
    for (std::size_t i = 0; i < all; i += stride)
        out.push_back(core::node_position(grid, i));
    return out;
}

} // namespace

Result<void> check_family(const LoadedDataset& dataset, const FamilyWish& wish) {
    if (!dataset.store)
        return fail(Error::Code::Unsupported,
                    "a built-in flow has no grid nodes, and a family has its values at nodes",
                    "wakesurf generate writes it to a store, which has nodes");
    if (is_others(dataset.store->layout().folder))
        return fail(
            Error::Code::Unsupported,
            "families are stored beside the data, and nothing is written to the web or into a Zarr",
            "make it of a store in a folder");
    const std::size_t nodes = core::node_count(dataset.store->grid());
    return check_name(dataset, wish.name)
        .and_then([&] { return scalar_of(dataset, wish.request); })
        .and_then([&](const auto&) { return steps_of(dataset, wish.times); })
        .and_then([&](const auto& steps) {
            return store::check_room_for(dataset.store->layout().folder,
                                         steps.size() * nodes * sizeof(float), "families");
        })
        .and_then(
            [&] { return store::read_families(dataset.store->layout().folder, core::PosixDisk()); })
        .and_then([&](const auto& all) {
            return check_unmade(store::current_families(all, dataset.store->marks()), wish);
        });
}

Result<core::FamilyRecord> make_family(const LoadedDataset& dataset,
                                       const FamilyWish& wish,
                                       const std::stop_token& stop,
                                       const core::WorkPart& work) {
    if (auto sound = check_family(dataset, wish); !sound)
        return tl::unexpected(sound.error());
    const store::StoreReader& store = *dataset.store;
    const auto steps = *steps_of(dataset, wish.times);
    const auto scalar = *scalar_of(dataset, wish.request);
    const auto marks = store.marks(); // of the velocities that are traced
    core::FamilyRecord record{wish.name, wish.request, WAKESURF_VERSION, {}};
    std::vector<std::vector<float>> values;
    std::size_t held = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i] >= marks.steps())
            return fail(Error::Code::NotFound,
                        fmt::format("time-step {} is not stored yet", steps[i]),
                        "wait for the import to reach it");
        const double time = store.times()[steps[i]];
        const auto plan =
            core::plan_family(*dataset.flow, wish.request, time, some_nodes(store.grid()), stop);
        if (!plan)
            return tl::unexpected(plan.error());
        auto field = core::trace_family(*dataset.flow, store.grid(), *plan, scalar, stop,
                                        work.part(i, steps.size()).above(held));
        if (!field)
            return tl::unexpected(field.error());
        record.request.length = plan->length;
        record.steps.push_back({steps[i], time, field->counts});
        held += field->values.size() * sizeof(float);
        values.push_back(std::move(field->values));
    }
    if (!store.refresh().value_or(false))
        return fail(Error::Code::Io, "the data were replaced while the family was made",
                    "make it again");
    return store::add_family(store.layout().folder, marks, record, values,
                             [&](const auto& all) { return check_unmade(all, wish); })
        .map([&] { return std::move(record); });
}

Result<void> remove_family(const LoadedDataset& dataset, const std::string& name) {
    if (!dataset.store)
        return fail(Error::Code::Unsupported, "a built-in flow has no families");
    if (is_others(dataset.store->layout().folder))
        return fail(Error::Code::Unsupported, "nothing can be removed on the web or in a Zarr");
    return store::remove_family(dataset.store->layout().folder, name);
}

} // namespace wakesurf::server
