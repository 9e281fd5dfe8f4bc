#include "server/sessions/surface_builds.hpp"

#include "core/base/rounding.hpp"
#include "core/surface/builder/twin.hpp"
#include "core/surface/level/level_surface.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "server/base/loop.hpp"
#include "server/data/datasets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace wakesurf::server {

namespace {

using Range = std::array<double, 2>;

Range widened(const std::optional<Range>& range, double one, double other) {
    const auto [first, last] = std::minmax(one, other);
    return range ? Range{std::min((*range)[0], first), std::max((*range)[1], last)}
                 : Range{first, last};
}

} // namespace

SurfaceBuilds::SurfaceBuilds(std::string session,
                             const SessionServices& services,
                             const SessionRecords& records,
                             std::uint32_t& next_number,
                             Events events)
    : session_(std::move(session)), services_(services), records_(records),
      next_number_(next_number), events_(std::move(events)) {}

SurfaceBuilds::~SurfaceBuilds() {
    *alive_ = false;
    for (const auto& [id, entry] : entries_)
        entry.live->retire();
}

core::Result<SurfaceJob> SurfaceBuilds::job_for(const protocol::SurfaceRecord& record) const {
    auto open = services_.datasets.open(record.dataset);
    if (!open)
        return tl::unexpected(open.error());
    const auto& rakes = records_.all<protocol::RakeRecord>();
    core::SurfaceParameters p = record.parameters;
    if (record.rake2)
        p.rake2 = rakes.at(*record.rake2).shape;
    auto fields = fields_there(*open, record.fields);
    p.deformation = asks_for(fields, SurfaceField::Source::Deformation);
    p.tangents = asks_for(fields, SurfaceField::Source::NormalComponent);
    auto plan = core::plan_surface(
        open->flow, record.rake ? rakes.at(*record.rake).shape : core::Rake{}, std::move(p));
    if (!plan)
        return tl::unexpected(plan.error());
    if (auto there = core::take_levels(*plan, open->levels); !there)
        return tl::unexpected(there.error());
    SurfaceJob job{
        0, 0, std::move(*plan), open->store, open->scalars, std::move(fields), open->lattice};
    if (record.twin)
        add_twin(job, *record.twin, *open);
    return job;
}

/// A surface whose twin cannot be had is a surface all the same.
void SurfaceBuilds::add_twin(SurfaceJob& job,
                             const protocol::Twin& twin,
                             const OpenDataset& surface_data) const {
    const auto open = twin.dataset ? services_.datasets.open(*twin.dataset)
                                   : core::Result<OpenDataset>(surface_data);
    auto plan = open.and_then([&](const OpenDataset& data) {
        job.twin_store = data.store;
        return core::plan_twin(job.plan, data.flow, twin.settings);
    });
    if (plan)
        job.twin = std::make_shared<core::SurfacePlan>(*std::move(plan));
    else
        job.twin_left_out = plan.error().message;
}

std::uint32_t SurfaceBuilds::build(const protocol::SurfaceRecord& record, SurfaceJob job) {
    LiveSurface& live = live_for(record);
    entries_[record.surface].withheld = false;
    return live.rebuild(std::move(job));
}

std::uint32_t SurfaceBuilds::build(const protocol::SurfaceRecord& record, bool rest) {
    LiveSurface& live = live_for(record);
    bool& withheld = entries_[record.surface].withheld;
    withheld = rest && services_.withheld != nullptr;
    auto job = job_for(record);
    if (!job)
        return live.refuse(record.parameters.kind,
                           withheld ? *services_.withheld : std::move(job.error()), rest);
    const std::uint32_t epoch = live.rebuild(std::move(*job), rest);
    if (withheld)
        live.stop(*services_.withheld);
    return epoch;
}

std::optional<std::uint32_t> SurfaceBuilds::rebuild(const protocol::SurfaceRecord& record) {
    auto job = job_for(record);
    return job ? std::optional(build(record, std::move(*job))) : std::nullopt;
}

LiveSurface& SurfaceBuilds::live_for(const protocol::SurfaceRecord& record) {
    const std::string& id = record.surface;
    Entry& entry = entries_[id];
    if (entry.live)
        return *entry.live;
    LiveSurface::Events events;
    events.progress = [this](const SurfaceProgress& progress) { events_.progress(progress); };
    events.ranges = [this](const SurfaceRanges& ranges) { events_.ranges(ranges); };
    events.done = [this](const SurfaceOutcome& outcome) {
        events_.done(outcome);
        built(outcome);
    };
    entry.live = std::make_shared<LiveSurface>(
        id, next_number_++, session_,
        LiveSurface::Services{services_.loop,
                              services_.pool,
                              services_.wall(),
                              services_.metrics,
                              {services_.memory, services_.histories}},
        std::move(events));
    entry.live->show(time_, playing_, true);
    entry.live->continue_after(record.epoch);
    return *entry.live;
}

void SurfaceBuilds::retire(const std::string& surface) {
    const auto found = entries_.find(surface);
    if (found == entries_.end())
        return;
    found->second.live->retire();
    entries_.erase(found);
}

std::shared_ptr<LiveSurface> SurfaceBuilds::find(const std::string& surface) const {
    const auto found = entries_.find(surface);
    return found == entries_.end() ? nullptr : found->second.live;
}

void SurfaceBuilds::built(const SurfaceOutcome& outcome) {
    const auto found = entries_.find(outcome.surface);
    if (found == entries_.end() || !std::exchange(found->second.data_came, false))
        return;
    // Deferred: within the event the surface is still notifying others of it.
    services_.loop.post(
        [weak = std::weak_ptr(found->second.live), this, alive = alive_, id = outcome.surface] {
            const auto live = weak.lock();
            if (*alive && live && find(id) == live)
                try_again(id, *live);
        });
}

void SurfaceBuilds::show(std::optional<double> time, bool playing, bool jumped) {
    time_ = time;
    playing_ = playing;
    for (const auto& [id, entry] : entries_)
        entry.live->show(time, playing, jumped);
}

std::optional<std::array<double, 2>> SurfaceBuilds::moving_range() const {
    std::optional<Range> range;
    for (const auto& [id, record] : records_.all<protocol::SurfaceRecord>()) {
        const core::SurfaceParameters& p = record.parameters;
        if (core::moves(p))
            range = widened(range, p.from, p.to);
    }
    return range;
}

core::Result<void> SurfaceBuilds::check_time(const char* name, double time) const {
    std::optional<Range> range;
    for (const auto& [id, record] : records_.all<protocol::SurfaceRecord>()) {
        const auto open = services_.datasets.open(record.dataset);
        const auto data = open && !open->info.steady ? open->flow->time_range() : std::nullopt;
        if (!data)
            return {};
        range = widened(widened(range, (*data)[0], (*data)[1]), record.parameters.from,
                        record.parameters.to);
    }
    if (!range || core::within_rounding(time, (*range)[0], (*range)[1]))
        return {};
    return core::fail(
        core::Error::Code::OutOfTime,
        fmt::format("`{}` {} is outside the data's {} to {}", name, time, (*range)[0], (*range)[1]),
        fmt::format("choose a time from {} to {}", (*range)[0], (*range)[1]));
}

bool SurfaceBuilds::dataset_changed(const std::string& dataset) {
    bool replaced = false;
    for (auto& [id, entry] : entries_) {
        const auto* record = records_.find<protocol::SurfaceRecord>(id);
        if (record != nullptr && record->twin && record->twin->dataset == dataset &&
            twin_changed(*record, *entry.live))
            build_anew(*record, entry);
        if (record == nullptr || record->dataset != dataset)
            continue;
        const Data data = compare_data(dataset, *entry.live);
        const bool failed = entry.live->outcome().error.has_value();
        if (data == Data::Other || (data == Data::ComingAgain && failed && !entry.withheld)) {
            replaced = replaced || data == Data::Other;
            build_anew(*record, entry);
        } else if (entry.withheld || data == Data::ComingAgain) {
            continue;
        } else if (entry.live->busy()) {
            entry.data_came = true;
        } else {
            try_again(id, *entry.live);
        }
    }
    return replaced;
}

/// The data of its twin have come, or others in their place.
bool SurfaceBuilds::twin_changed(const protocol::SurfaceRecord& record,
                                 const LiveSurface& live) const {
    if (live.wanted().twin)
        return replaced_since(services_.datasets, *record.twin->dataset, live.wanted().twin_store);
    const auto job = job_for(record);
    return job && job->twin;
}

/// Compares the data a surface was built from with the present ones. `Coming again`: the same as far as they
/// go, as when the same data are imported once more; the present surface stays until that is known.
SurfaceBuilds::Data SurfaceBuilds::compare_data(const std::string& dataset,
                                                const LiveSurface& live) const {
    const auto& before = live.wanted().store;
    if (before == nullptr)
        return Data::Same;
    const auto open = services_.datasets.open(dataset);
    if (!open || !open->store)
        return Data::Other;
    if (open->store == before)
        return Data::Same;
    const store::ValueMarks now = open->store->marks();
    const store::ValueMarks then = before->marks();
    return now.continues(then) ? Data::Same : then.continues(now) ? Data::ComingAgain : Data::Other;
}

void SurfaceBuilds::build_anew(const protocol::SurfaceRecord& record, Entry& entry) {
    LiveSurface& live = *entry.live;
    entry.data_came = false;
    auto job = job_for(record);
    const bool withheld = job && entry.withheld;
    const std::uint32_t epoch =
        job ? live.rebuild(std::move(*job), live.resting())
            : live.refuse(record.parameters.kind, std::move(job.error()), live.resting());
    if (withheld)
        live.stop(*services_.withheld);
    events_.rebuilt(record.surface, epoch);
}

// A surface that missed nothing stays as it is.
void SurfaceBuilds::try_again(const std::string& surface, LiveSurface& live) {
    const auto* record = records_.find<protocol::SurfaceRecord>(surface);
    const SurfaceOutcome outcome = live.outcome();
    const auto open = services_.datasets.open(record->dataset);
    if (!open)
        return;
    if (outcome.statistics.stopped.empty() && !outcome.error)
        return live.renew_data(*open);
    auto job = job_for(*record);
    if (job)
        events_.rebuilt(surface, live.rebuild(std::move(*job), live.resting()));
}

} // namespace wakesurf::server
