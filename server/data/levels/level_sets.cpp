#include "server/data/levels/level_sets.hpp"

#include "core/base/blocking_wait.hpp"
#include "server/data/levels/placed_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wakesurf::server {

using core::Error;

namespace {

constexpr std::chrono::milliseconds memory_patience{
    1000}; ///< the wait for others to release memory

/// The memory of the process besides shared memory: the program with its libraries, and a level set of many
/// triangles.
constexpr std::size_t process_bytes = std::size_t{160} << 20;

const core::Clock& machine_clock() {
    static const core::SteadyClock clock;
    return clock;
}

} // namespace

class LevelSets::OneAtATime {
  public:
    OneAtATime(const LevelSets& of, const std::stop_token& stop) : of_(of) {
        std::unique_lock lock(of_.mutex_);
        of_.turns_.push_back(this);
        const auto mine = [&] { return of_.turns_.front() == this; };
        if (!mine()) {
            const core::BlockingWait blocked;
            of_.next_.wait(lock, stop, mine);
        }
        if (!mine())
            return;
        loaded_ = std::exchange(of_.loaded_, nullptr);
        if (!loaded_)
            loaded_ = std::make_shared<Loaded>();
    }

    ~OneAtATime() {
        const std::scoped_lock lock(of_.mutex_);
        of_.turns_.remove(this);
        of_.next_.notify_all();
        if (!loaded_)
            return;
        of_.asked_ = of_.options_.clock->now();
        if (loaded_->process && loaded_->process->usable())
            of_.loaded_ = std::move(loaded_);
    }

    OneAtATime(const OneAtATime&) = delete;
    OneAtATime& operator=(const OneAtATime&) = delete;

    Loaded* loaded() { return loaded_.get(); }

  private:
    const LevelSets& of_;
    std::shared_ptr<Loaded> loaded_; ///< null: cancelled before its turn
};

LevelSets::LevelSets(std::shared_ptr<const core::Flow> flow,
                     std::shared_ptr<const store::StoreReader> store,
                     std::string velocity,
                     Options options,
                     std::shared_ptr<const store::StoreScalars> scalars)
    : flow_(std::move(flow)), store_(std::move(store)),
      scalars_(scalars ? std::move(scalars) : store::StoreScalars::open(store_, store_->disk())),
      velocity_(std::move(velocity)), options_(std::move(options)) {
    if (options_.clock == nullptr)
        options_.clock = &machine_clock();
    if (options_.account)
        ticket_ = options_.account->on_need(core::ReclaimOrder::Histories,
                                            [this](std::size_t) { take(); });
}

LevelSets::~LevelSets() {
    ticket_.reset(); // waits for a running call
}

std::shared_ptr<LevelSets::Loaded> LevelSets::take() const {
    const std::scoped_lock lock(mutex_);
    return std::exchange(loaded_, nullptr);
}

std::shared_ptr<void> LevelSets::take_idle() const {
    {
        const std::scoped_lock lock(mutex_);
        if (!loaded_ || options_.clock->now() - asked_ < options_.idle)
            return nullptr;
    }
    return take();
}

std::optional<pid_t> LevelSets::process() const {
    const std::scoped_lock lock(mutex_);
    return loaded_ ? std::optional(loaded_->process->id()) : std::nullopt;
}

std::size_t LevelSets::asking() const {
    const std::scoped_lock lock(mutex_);
    return turns_.size();
}

core::Result<void> LevelSets::check_field(const std::string& name) const {
    return find_node_field(*scalars_, velocity_, name, options_.of_files).map([](const NodeField&) {
    });
}

core::Result<core::LevelTriangles> LevelSets::extract(const core::LevelWanted& wanted,
                                                      const std::stop_token& stop) const {
    OneAtATime turn(*this, stop);
    if (turn.loaded() == nullptr)
        return core::fail(Error::Code::Cancelled, "the level set was cancelled");
    return extract_in(*turn.loaded(), wanted, stop);
}

core::Result<void> LevelSets::begin(Loaded& loaded, const std::stop_token& stop) const {
    if (loaded.process && loaded.process->usable()) {
        auto rests = loaded.process->rest(stop);
        if (rests || rests.error().code == Error::Code::Cancelled)
            return rests;
    }
    loaded.process.reset();
    const auto bytes = level_memory_bytes(store_->grid());
    if (!bytes)
        return tl::unexpected(bytes.error());
    LevelProcess::Options options = options_.process;
    if (options.memory == 0)
        options.memory = 3 * *bytes + 2 * process_bytes;
    if (options_.account && !loaded.memory) {
        loaded.share = options_.account->open(core::MemoryUse::Importers);
        if (!loaded.share.grow_to(*bytes + process_bytes, stop, memory_patience))
            return tl::unexpected(
                options_.account->refusal("a level set of this dataset", *bytes + process_bytes));
    }
    if (!loaded.memory) {
        auto memory = LevelMemory::of(store_->grid());
        if (!memory)
            return tl::unexpected(memory.error());
        loaded.memory = std::move(*memory);
        loaded.field.reset();
    }
    return LevelProcess::start(*loaded.memory, options).map([&](auto&& process) {
        loaded.process = std::move(process);
    });
}

core::Result<void> LevelSets::load(Loaded& loaded,
                                   const NodeField& field,
                                   double time,
                                   const std::stop_token& stop) const {
    if (loaded.field == field && loaded.time == time)
        return {};
    loaded.field.reset();
    const auto values = loaded.memory->values();
    if (auto read = node_values(field, *flow_, *store_, *scalars_, time, values, stop); !read)
        return read;
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    loaded.gaps = false;
    for (const float each : values)
        if (std::isfinite(each)) {
            lo = std::min(lo, double(each));
            hi = std::max(hi, double(each));
        } else {
            loaded.gaps = true;
        }
    loaded.range = lo <= hi ? std::optional(std::array{lo, hi}) : std::nullopt;
    ++loaded.version;
    loaded.field = field;
    loaded.time = time;
    return {};
}

core::Result<core::LevelTriangles> LevelSets::extract_in(Loaded& loaded,
                                                         const core::LevelWanted& wanted,
                                                         const std::stop_token& stop) const {
    const auto field = find_node_field(*scalars_, velocity_, wanted.field);
    if (!field)
        return tl::unexpected(field.error());
    const auto ready =
        begin(loaded, stop).and_then([&] { return load(loaded, *field, wanted.time, stop); });
    if (!ready)
        return tl::unexpected(ready.error());
    core::LevelTriangles out;
    out.values = loaded.range.has_value();
    out.range = loaded.range.value_or(std::array{0.0, 0.0});
    if (!out.values && field->source == NodeField::Source::Scalar)
        out.times = scalars_->times_of(field->index);
    if (!out.values || wanted.level < out.range[0] || wanted.level > out.range[1])
        return out;
    importer::LevelRequest request;
    request.version = loaded.version;
    request.most_triangles = wanted.most_triangles;
    request.level = wanted.level;
    request.gaps = loaded.gaps ? 1 : 0;
    auto mesh = loaded.process->extract(request, stop);
    if (!mesh && loaded.process->gone())
        mesh = begin(loaded, stop).and_then([&] { return loaded.process->extract(request, stop); });
    if (!mesh && mesh.error().code == Error::Code::OverLimit && mesh.error().limit)
        return core::over_limit(wanted.most_triangles / 2,
                                "the level set of " + wanted.field + " has " +
                                    mesh.error().message + ", more than `maxQuads` " +
                                    std::to_string(wanted.most_triangles / 2) +
                                    " quads are made of",
                                "raise `maxQuads`, or choose another level");
    if (!mesh)
        return tl::unexpected(mesh.error());
    auto placed =
        placed_triangles(store_->grid(), loaded.memory->values(), loaded.gaps, *std::move(mesh));
    if (!placed)
        return tl::unexpected(placed.error());
    out.points = std::move(placed->points);
    out.triangles = std::move(placed->triangles);
    return out;
}

} // namespace wakesurf::server
