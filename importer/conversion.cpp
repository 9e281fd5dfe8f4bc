#include "importer/conversion.hpp"

#include "importer/base/one_thread.hpp"
#include "importer/base/text.hpp"
#include "importer/first_step.hpp"
#include "importer/import_plan.hpp"
#include "importer/import_store.hpp"
#include "importer/sources/open_source.hpp"
#include "importer/sources/series/series_times.hpp"
#include "importer/step_workers.hpp"
#include "store/brick_mask.hpp"
#include "store/store_grid.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

namespace wakesurf::importer {

using core::Error;

namespace {

// Decides how many processes convert time-steps at once, and whether they may share open files.

// Returns MemAvailable of /proc/meminfo in bytes; 0 if unknown.
std::size_t free_memory() {
    std::ifstream in("/proc/meminfo");
    std::string name;
    std::string unit;
    for (std::size_t kilobytes = 0; in >> name >> kilobytes; std::getline(in, unit))
        if (name == "MemAvailable:")
            return kilobytes * 1024;
    return 0;
}

// Returns the number asked for, else that of cores; fewer if half of the free memory does not hold as many
// time-steps.
std::size_t worker_count(const ImportPlan& plan, std::size_t nodes) {
    const std::size_t wanted =
        plan.jobs > 0 ? plan.jobs : std::max(1u, std::thread::hardware_concurrency());
    // A reader holds a file about twice while it decodes; averaging holds sums in double.
    constexpr std::size_t a_node = 64;
    constexpr std::size_t copies = 3;
    std::size_t a_step = a_node * nodes;
    for (const auto& file : plan.made_from.steps.front())
        a_step += copies * static_cast<std::size_t>(file.size);
    std::size_t memory = free_memory() / 2;
    // What is allowed is shared with the first time-step, which the process that starts the others holds.
    const std::size_t allowed = plan.memory - std::min<std::size_t>(plan.memory, a_step);
    if (plan.memory > 0)
        memory = memory == 0 ? allowed : std::min(memory, allowed);
    return memory == 0 && plan.memory == 0
               ? wanted
               : std::clamp<std::size_t>(memory / std::max<std::size_t>(a_step, 1), 1, wanted);
}

// Says whether files are open for reading, standard input aside: forked processes share the offset in them.
bool reads_open_files() {
    DIR* list = ::opendir("/proc/self/fd");
    if (list == nullptr)
        return true;
    bool found = false;
    while (const dirent* entry = ::readdir(list)) {
        char* end = nullptr;
        const long file = std::strtol(entry->d_name, &end, 10);

        struct stat state {};

        if (end == entry->d_name || file <= STDERR_FILENO ||
            ::fstat(static_cast<int>(file), &state) != 0 || !S_ISREG(state.st_mode))
            continue;
        found = found || (::fcntl(static_cast<int>(file), F_GETFL) & O_ACCMODE) == O_RDONLY;
    }
    ::closedir(list);
    return found;
}

bool same_size(const store::StoredGrid& a, const store::StoredGrid& b) {
    return a.kind == b.kind && a.nodes() == b.nodes() && a.cells == b.cells &&
           a.dimensions == b.dimensions;
}

// Its files stay known: once they change, the series may go on.
void end_before(std::size_t step, store::StoreManifest& manifest) {
    manifest.layout.times.resize(step);
    manifest.info.times.resize(step);
    manifest.info.steady = step == 1;
    manifest.source.steps.resize(step + 1);
}

class Conversion {
  public:
    Conversion(const ImportRequest& request,
               ImportPlan& plan,
               store::StoreWriter& writer,
               const ShowProgress& show)
        : request_(request), plan_(plan), writer_(writer), show_(show) {}

    core::Result<void> run(std::optional<EarlierImport> earlier) {
        auto reading = read_first_step(plan_, !earlier, torn_);
        if (!reading)
            return tl::unexpected(reading.error());
        reading_ = std::move(*reading);
        auto described = describe_store(plan_, reading_);
        if (!described)
            return tl::unexpected(described.error());
        manifest_ = std::move(*described);
        described_ = manifest_.info.note;
        if (plan_.precision == core::Precision::Half)
            if (auto noted = note_rounding(); !noted)
                return noted;
        if (earlier && !same_size(manifest_.layout.grid, earlier->manifest.layout.grid)) {
            earlier.reset(); // written by another version of this program
            return run(std::nullopt);
        }
        if (earlier) {
            if (auto begun = go_on(*earlier); !begun)
                return begun;
        } else {
            // The store is cleared only now: a refused import leaves the earlier one.
            if (auto cleared = writer_.clear(); !cleared)
                return cleared;
            for (std::size_t i = 0; i < plan_.times.size(); ++i)
                todo_.push_back(i);
        }
        fixed_files_missing_ = !earlier;
        done_before_ = plan_.times.size() - todo_.size();
        begun_ = std::chrono::steady_clock::now();
        if (request_.growing && done_before_ > 0) // these can be used, whatever comes
            show_({"import", done_before_, plan_.times.size(), {}, {}});
        auto converted = convert_all();
        if (!converted && torn_ && !std::exchange(begun_again_, true)) {
            todo_.clear();
            written_ = 0;
            ranged_ = false;
            return run(std::nullopt);
        }
        if (!converted && ends_there(converted.error())) {
            remove_unfinished();
            end_there(converted.error());
            converted = {};
        }
        if (!converted) {
            remove_unfinished();
            if (written_ > 0 || earlier)
                write_manifest().value_or(0);
            if (done() > 0 && converted.error().hint.empty())
                converted.error().hint =
                    "the time-steps before it are in the store and can be used";
            return converted;
        }
        if (auto settled = writer_.settle(); !settled)
            return settled;
        manifest_.complete = true;
        return write_manifest().map([](int) {});
    }

  private:
    // Says whether the series ends before the time-step that could not be converted: what was before is whole then.
    bool ends_there(const Error& why) const {
        return !request_.growing && plan_.period_steps == 0 && done() > 0 &&
               written_ < todo_.size() && done() == todo_[written_] && ends_series(why);
    }

    void end_there(const Error& why) {
        const std::size_t steps = done();
        plan_.end_note = note_on_end(plan_.times[steps], why);
        add_note(described_, plan_.end_note);
        plan_.times.resize(steps);
        end_before(steps, manifest_);
        show_({"import", steps, steps, file_of(steps - 1), plan_.end_note});
    }

    core::Result<void> note_rounding() {
        const auto velocity = velocity_of(plan_, reading_.first, 0, reading_.step);
        if (!velocity)
            return tl::unexpected(velocity.error());
        add_note(manifest_.info.note, rounding_note(*velocity));
        described_ = manifest_.info.note;
        return {};
    }

    core::Result<void> write_fixed(const std::string& name, std::span<const std::byte> bytes) {
        return writer_.write(name, bytes).map([&](std::uint32_t checksum) {
            manifest_.layout.checksums[name] = checksum;
        });
    }

    core::Result<void> write_fixed_files() {
        for (const auto& file : store::grid_files(reading_.first.assembly.grid))
            if (auto written = write_fixed(file.name, file.bytes); !written)
                return written;
        if (manifest_.layout.mask)
            if (auto written = write_mask(); !written)
                return written;
        const auto& walls = reading_.walls;
        const auto write = [&](bool there, const char* name, std::span<const std::byte> bytes) {
            return there ? write_fixed(name, bytes) : core::Result<void>();
        };
        return write(manifest_.layout.walls, "walls.f32", std::as_bytes(std::span(walls.points)))
            .and_then([&] {
                return write(manifest_.layout.walls, "walls.u32",
                             std::as_bytes(std::span(walls.triangles)));
            });
    }

    core::Result<void> write_mask() {
        return store::write_mask(
                   writer_, manifest_.layout,
                   [rest = std::span<const std::uint8_t>(reading_.first.mask.fluid)]() mutable {
                       return core::Result<std::span<const std::uint8_t>>(std::exchange(rest, {}));
                   })
            .map([&](std::uint32_t checksum) {
                manifest_.layout.checksums[std::string(store::mask_file_name)] = checksum;
            });
    }

    // The grid's files stay: a server may have them open, and walls found at another last time-step differ.
    core::Result<void> go_on(EarlierImport& earlier) {
        const auto& before = earlier.manifest;
        manifest_.layout.checksums = before.layout.checksums;
        manifest_.layout.brick_cells = before.layout.brick_cells;
        manifest_.layout.mask = before.layout.mask;
        manifest_.layout.walls = before.layout.walls;
        manifest_.layout.patches = manifest_.info.patches = before.info.patches;
        manifest_.info.obstacle = before.info.obstacle;
        if (before.complete) {
            manifest_.velocity_range = before.velocity_range;
            manifest_.without_velocity = before.without_velocity;
            for (std::size_t i = 0;
                 i < manifest_.info.fields.size() && i < before.info.fields.size(); ++i)
                manifest_.info.fields[i].range = before.info.fields[i].range;
            ranged_ = true;
        }
        for (std::size_t i = 0; i < plan_.times.size(); ++i) {
            if (earlier.reusable[i] && !before.complete) {
                const auto record = recorded(*earlier.reader, i, reading_.first.mask.fluid);
                earlier.reusable[i] = record.has_value();
                if (record)
                    include_record(i, *record);
            }
            if (!earlier.reusable[i])
                todo_.push_back(i);
        }
        return write_manifest().map([](int) {});
    }

    void include_record(std::size_t index, const StepRecord& record) {
        if (record.speed.empty())
            manifest_.without_velocity.push_back(index);
        include(plan_, record, !ranged_, manifest_);
        ranged_ = true;
    }

    core::Result<int> write_manifest() {
        manifest_.info.note = described_;
        add_note(manifest_.info.note,
                 note_on_missing_velocity(manifest_.without_velocity, plan_.times));
        const std::string text = store::store_manifest_text(manifest_);
        return writer_.write(std::string(store::manifest_file_name), std::as_bytes(std::span(text)))
            .map([](std::uint32_t) { return 1; });
    }

    // Converts all time-steps: this process has read the first already; the others go to workers.
    core::Result<void> convert_all() {
        const bool first_here = !todo_.empty() && todo_.front() == 0;
        const auto first_repeated = plan_.period_steps == 0
                                        ? todo_.end()
                                        : std::ranges::lower_bound(todo_, plan_.period_steps);
        const auto others = std::span(todo_.begin(), first_repeated).subspan(first_here ? 1 : 0);
        StepWork work;
        work.name = [&](std::size_t index) { return plan_.step_name(index); };
        work.convert = [&](std::size_t index) {
            const bool read = index + 1 == plan_.times.size() && reading_.last;
            return convert_step(plan_, reading_.first, index, read ? &*reading_.last : nullptr,
                                manifest_.layout, writer_);
        };
        work.commit = [&](std::size_t index, const StepRecord& record) {
            return commit(index, record);
        };
        if (reads_open_files())
            work.begin = [&]() { return open_again(); };
        if (first_here)
            work.meanwhile = [&]() -> core::Result<void> {
                if (fixed_files_missing_)
                    if (auto written = write_fixed_files(); !written)
                        return written;
                auto record =
                    write_step(plan_, reading_.first, 0, reading_.step, manifest_.layout, writer_);
                reading_.step = {};
                return record ? commit(0, *record) : tl::unexpected(record.error());
            };
        else
            reading_.step = {};
        auto converted = convert_steps(others, worker_count(plan_, manifest_.info.points), work);
        for (auto index = first_repeated; converted && index != todo_.end(); ++index)
            converted = repeat_step(*index);
        return converted;
    }

    // Makes a time-step of the files of the first period: as links, so that they take no room, where the file
    // system has them.
    core::Result<void> repeat_step(std::size_t index) {
        const std::size_t first = index % plan_.period_steps;
        const auto& layout = manifest_.layout;
        for (std::size_t column = 0; column < layout.columns(); ++column) {
            const auto from = store::step_files(layout, column, first);
            const auto to = store::step_files(layout, column, index);
            for (std::size_t i = 0; i < from.size(); ++i)
                if (auto linked = writer_.repeat(from[i].name, to[i].name); !linked)
                    return linked;
        }
        const auto& without = manifest_.without_velocity;
        if (std::ranges::find(without, first) != without.end())
            manifest_.without_velocity.push_back(index);
        const auto checksums = writer_.finished_step(first, layout.columns());
        if (!checksums)
            return core::fail(Error::Code::Io, "the first period is not in the store any more");
        if (auto finished = writer_.finish_step(index, *checksums); !finished)
            return finished;
        ++written_;
        show_({"import", done(), plan_.times.size(), file_of(index), {}, 0.0, remaining()});
        return {};
    }

    core::Result<void> open_again() {
        auto source = open_source(request_.source, request_.taken);
        if (!source)
            return tl::unexpected(source.error());
        plan_.source = std::move(*source);
        return plan_.source->describe_by(plan_.described);
    }

    core::Result<void> commit(std::size_t index, const StepRecord& record) {
        if (record.tears && !torn_) {
            torn_ = true; // the mesh must be another one, by all time-steps
            return core::fail(Error::Code::Unsupported, "pieces of the mesh come apart");
        }
        include_record(index, record);
        // With its range the store can be opened from the first time-step on.
        if (index == 0)
            if (auto written = write_manifest(); !written)
                return tl::unexpected(written.error());
        if (auto finished = writer_.finish_step(index, record.checksums); !finished)
            return finished;
        ++written_;
        show_({"import", done(), plan_.times.size(), file_of(index),
               written_ == 1 ? manifest_.info.note : "", 0.0, remaining()});
        return {};
    }

    std::string file_of(std::size_t index) const {
        const auto& files = plan_.made_from.steps[index];
        return files.empty() ? plan_.step_name(index) : files.front().name;
    }

    std::size_t done() const { return done_before_ + written_; }

    double remaining() const {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begun_;
        return elapsed.count() / static_cast<double>(written_) *
               static_cast<double>(todo_.size() - written_);
    }

    void remove_unfinished() {
        std::error_code ignored;
        for (std::size_t i = written_; i < todo_.size(); ++i)
            for (std::size_t column = 0; column < manifest_.layout.columns(); ++column)
                for (const auto& file : store::step_files(manifest_.layout, column, todo_[i]))
                    std::filesystem::remove(writer_.folder() / file.name, ignored);
    }

    const ImportRequest& request_;
    ImportPlan& plan_;
    store::StoreWriter& writer_;
    const ShowProgress& show_;
    FirstStepReading reading_;
    store::StoreManifest manifest_;
    bool fixed_files_missing_ = false;
    bool torn_ = false;        ///< points that were one node must not be
    bool begun_again_ = false; ///< for that reason
    bool ranged_ = false;      ///< the manifest's ranges are of stored values
    std::string described_;    ///< the note, without what converting the time-steps shows
    std::vector<std::size_t> todo_;
    std::size_t done_before_ = 0;
    std::size_t written_ = 0; ///< of todo_, in order
    std::chrono::steady_clock::time_point begun_;
};

// Describes where an import would end, by a few time-steps: checking all would cost as much as the import.
void note_what_ends_an_import(const ImportPlan& plan,
                              const FirstStep& first,
                              store::StoreManifest& manifest) {
    const std::size_t last = plan.times.size() - 1;
    for (const std::size_t index : {std::size_t{1}, last}) {
        if (index > last || index == 0)
            continue;
        auto step = plan.read(index);
        const auto sound =
            step ? take_mesh_of(plan, first, index, *step) : tl::unexpected(step.error());
        if (!sound && ends_series(sound.error())) {
            end_before(index, manifest);
            return add_note(manifest.info.note, note_on_end(plan.times[index], sound.error()));
        }
        if (!sound)
            return add_note(
                manifest.info.note,
                "an import will end before time " + time_text(plan.times[index]) + ": " +
                    sound.error().message +
                    (sound.error().hint.empty() ? "" : " (" + sound.error().hint + ")"));
        if (index == last)
            break;
    }
}

bool up_to_date(const EarlierImport& earlier) {
    return earlier.same_source && earlier.manifest.complete &&
           std::find(earlier.reusable.begin(), earlier.reusable.end(), false) ==
               earlier.reusable.end();
}

} // namespace

core::Result<core::DatasetInfo> describe_source(const ImportRequest& request) {
    const auto plan = make_plan(request);
    if (!plan)
        return tl::unexpected(plan.error());
    auto reading = read_first_step(*plan, false);
    if (!reading)
        return tl::unexpected(reading.error());
    const auto velocity = velocity_of(*plan, reading->first, 0, reading->step);
    if (!velocity)
        return tl::unexpected(velocity.error());
    auto manifest = describe_store(*plan, *reading);
    if (!manifest)
        return tl::unexpected(manifest.error());
    const Range speed = speed_range(*velocity, reading->first.mask.fluid);
    include(*plan, {{}, speed, {}}, true, *manifest);
    auto& note = manifest->info.note;
    if (plan->precision == core::Precision::Half)
        add_note(note, rounding_note(*velocity));
    if (speed.empty())
        add_note(note, "no velocity of the first time-step is a number (in single precision)");
    reading->step = {}; // before others are read
    note_what_ends_an_import(*plan, reading->first, *manifest);
    return manifest->info;
}

core::Result<void> convert(const ImportRequest& request,
                           const std::filesystem::path& store,
                           const ShowProgress& show) {
    keep_vtk_to_one_thread();
    auto plan = make_plan(request, [&](std::vector<std::string> velocities) {
        show({"velocity", 0, 0, {}, {}, 0.0, {}, std::move(velocities)});
    });
    if (!plan)
        return tl::unexpected(plan.error());
    auto writer = store::StoreWriter::open(store, [&] {
        show({"waiting", 0, 0, {}, "another import is writing this store"});
        return core::Result<void>();
    });
    if (!writer)
        return tl::unexpected(writer.error());
    auto earlier = earlier_import(*writer, *plan);
    const auto done = [&](const std::string& note) {
        show({"done", plan->times.size(), plan->times.size(), {}, note});
    };
    if (earlier && up_to_date(*earlier)) {
        std::string note = "the store is up to date";
        add_note(note, plan->end_note);
        done(note);
        return {};
    }
    if (auto converted = Conversion(request, *plan, *writer, show).run(std::move(earlier));
        !converted)
        return converted;
    done({});
    return {};
}

} // namespace wakesurf::importer
