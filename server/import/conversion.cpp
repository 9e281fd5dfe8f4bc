#include "server/import/conversion.hpp"

#include "core/base/crc32c.hpp"
#include "core/dataset/store_grid.hpp"
#include "core/dataset/store_reader.hpp"
#include "server/catalogue/store_writer.hpp"
#include "server/import/image_file.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

using core::Error;

namespace {

// Everything about a source that is known before its time-steps are converted.
struct Plan {
    Series series;
    std::vector<double> times;
    std::string note; ///< where the times come from, if not from the source
    ImageDescription first;
    FieldChoice choice;
};

core::Result<void> find_times(Plan& plan) {
    auto& files = plan.series.files;
    const bool timed = files.front().time.has_value();
    for (auto& file : files)
        if (!timed) {
            auto own = image_time(file);
            if (!own)
                return tl::unexpected(own.error());
            file.time = *own;
        }
    for (std::size_t i = 0; i < files.size(); ++i)
        plan.times.push_back(files[i].time.value_or(std::nan("")));
    const bool rising =
        std::none_of(plan.times.begin(), plan.times.end(),
                     [](double t) { return std::isnan(t); }) &&
        std::adjacent_find(plan.times.begin(), plan.times.end(),
                           [](double a, double b) { return !(a < b); }) == plan.times.end();
    if (rising)
        return {};
    for (std::size_t i = 0; i < files.size(); ++i)
        plan.times[i] = static_cast<double>(i);
    if (files.size() > 1)
        plan.note = "the files carry no times: 0, 1, 2, ... are used";
    return {};
}

core::Result<void> select_times(Plan& plan, const std::optional<TimeSelection>& selection) {
    if (!selection)
        return {};
    std::vector<SeriesFile> files;
    std::vector<double> times;
    const double slack = 1e-9 * std::max(std::abs(selection->from), std::abs(selection->to));
    std::size_t within = 0;
    for (std::size_t i = 0; i < plan.times.size(); ++i) {
        const double t = plan.times[i];
        if (t < selection->from - slack || t > selection->to + slack)
            continue;
        if (within++ % selection->every == 0) {
            files.push_back(plan.series.files[i]);
            times.push_back(t);
        }
    }
    if (files.empty())
        return core::fail(Error::Code::OutOfTime, "no time-step lies in --times; there is " +
                                                      std::to_string(plan.times.front()) + " to " +
                                                      std::to_string(plan.times.back()));
    plan.series.files = std::move(files);
    plan.times = std::move(times);
    return {};
}

core::Result<Plan> make_plan(const ImportRequest& request, Series series) {
    Plan plan{std::move(series), {}, {}, {}, {}};
    if (auto found = find_times(plan); !found)
        return tl::unexpected(found.error());
    if (auto selected = select_times(plan, request.times); !selected)
        return tl::unexpected(selected.error());
    auto first = describe_image(plan.series.files.front());
    if (!first)
        return tl::unexpected(first.error());
    plan.first = std::move(*first);
    auto choice = choose_fields(plan.first.fields, request.fields);
    if (!choice)
        return core::fail(choice.error().code,
                          plan.series.files.front().name + ": " + choice.error().message,
                          choice.error().hint);
    plan.choice = std::move(*choice);
    return plan;
}

core::DatasetInfo describe(const Plan& plan, const ImageStep& first) {
    const auto& grid = plan.first.grid;
    core::DatasetInfo info;
    info.dataset = info.name = plan.series.name;
    info.reader = "vtkXMLImageDataReader (" + plan.series.reader + ")";
    info.bounds = grid.bounds();
    info.dimensions = grid.dimensions;
    info.spacing = grid.spacing;
    info.finest_spacing = std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    info.points = grid.nodes();
    info.cells =
        std::uint64_t{grid.dimensions[0] - 1} * (grid.dimensions[1] - 1) * (grid.dimensions[2] - 1);
    info.times = plan.times;
    info.steady = plan.times.size() == 1;
    info.fields = plan.first.fields;
    info.velocity = plan.choice.velocity.name;
    info.why = plan.choice.why;
    info.obstacle = std::find(first.fluid.begin(), first.fluid.end(), 0) != first.fluid.end();
    info.bytes_per_step = first.velocity.size() * sizeof(float);
    return info;
}

void set_speed_range(protocol::StoreManifest& manifest, const std::array<double, 2>& range) {
    manifest.velocity_range = range;
    for (auto& field : manifest.info.fields)
        if (field.name == manifest.info.velocity && field.components == 3)
            field.range = range;
}

bool same_grid(const core::UniformGrid& a, const core::UniformGrid& b) {
    return a.dimensions == b.dimensions && a.origin == b.origin && a.spacing == b.spacing;
}

core::Result<ImageStep> read_step(const Plan& plan, std::size_t index, const ImageStep* first) {
    const auto& file = plan.series.files[index];
    auto step = read_image(file, plan.choice);
    if (step && !same_grid(step->grid, plan.first.grid))
        return core::fail(Error::Code::Unsupported,
                          file.name + " has another grid than " + plan.series.files.front().name,
                          "all time-steps of a series must share one grid");
    if (step && first != nullptr && step->fluid != first->fluid)
        return core::fail(Error::Code::Unsupported,
                          file.name + " has another mask than " + plan.series.files.front().name,
                          "moving obstacles cannot be read");
    return step;
}

std::string velocity_file(std::size_t index) {
    return core::step_file_name(core::velocity_stem, index, core::Precision::Single);
}

// A step an earlier, interrupted import of the same source has left.
std::optional<std::vector<float>>
kept_step(const StoreWriter& writer, std::size_t index, std::size_t bytes) {
    const core::PosixDisk disk;
    const auto file = writer.folder() / velocity_file(index);
    const auto size = disk.size(file);
    const auto checksums = writer.finished_step(index, 1);
    if (!size || *size != bytes || !checksums)
        return std::nullopt;
    std::vector<float> velocity(bytes / sizeof(float));
    const auto stored = std::as_writable_bytes(std::span(velocity));
    if (!disk.read(file, 0, stored) || core::crc32c(stored) != checksums->front())
        return std::nullopt;
    return velocity;
}

class Conversion {
  public:
    Conversion(const Plan& plan, StoreWriter& writer, const ShowProgress& show)
        : plan_(plan), writer_(writer), show_(show) {}

    core::Result<void> run(protocol::StoreSource source) {
        auto first = read_step(plan_, 0, nullptr);
        if (!first)
            return tl::unexpected(first.error());
        first_ = std::move(*first);
        manifest_.source = std::move(source);
        manifest_.info = describe(plan_, first_);
        manifest_.layout.grid = core::stored_grid(plan_.first.grid);
        manifest_.layout.times = plan_.times;
        manifest_.layout.mask = manifest_.info.obstacle;
        set_speed_range(manifest_, speed_range(first_.velocity, first_.fluid));
        if (manifest_.layout.mask) {
            const std::string name(core::mask_file_name);
            const auto mask = writer_.write(name, std::as_bytes(std::span(first_.fluid)));
            if (!mask)
                return tl::unexpected(mask.error());
            manifest_.layout.checksums[name] = *mask;
        }
        if (auto begun = write_manifest(); !begun)
            return begun;
        for (std::size_t i = 0; i < plan_.times.size(); ++i)
            if (auto converted = convert_step(i); !converted)
                return converted;
        manifest_.complete = true;
        return write_manifest();
    }

  private:
    core::Result<void> write_manifest() {
        const std::string text = protocol::store_manifest_text(manifest_);
        return writer_.write(std::string(protocol::manifest_file_name),
                             std::as_bytes(std::span(text)))
            .map([](std::uint32_t) {});
    }

    core::Result<void> convert_step(std::size_t index) {
        const auto& name = plan_.series.files[index].name;
        if (const auto kept = kept_step(writer_, index, manifest_.info.bytes_per_step)) {
            include(*kept);
        } else if (index == 0) {
            if (auto written = write_step(index, first_); !written)
                return written;
        } else {
            const auto step = read_step(plan_, index, &first_);
            if (!step)
                return tl::unexpected(step.error());
            if (auto written = write_step(index, *step); !written)
                return written;
        }
        show_({"import", index + 1, plan_.times.size(), name, index == 0 ? plan_.note : ""});
        return {};
    }

    core::Result<void> write_step(std::size_t index, const ImageStep& step) {
        include(step.velocity);
        return writer_.write(velocity_file(index),
                             std::as_bytes(std::span(step.velocity)))
            .and_then([&](std::uint32_t checksum) {
                return writer_.finish_step(index, {&checksum, 1});
            });
    }

    void include(const std::vector<float>& velocity) {
        const auto range = speed_range(velocity, first_.fluid);
        set_speed_range(manifest_, {std::min(manifest_.velocity_range[0], range[0]),
                                    std::max(manifest_.velocity_range[1], range[1])});
    }

    const Plan& plan_;
    StoreWriter& writer_;
    const ShowProgress& show_;
    ImageStep first_;
    protocol::StoreManifest manifest_;
};

bool whole(const protocol::StoreManifest& manifest, const std::filesystem::path& folder) {
    const auto reader = core::StoreReader::open(protocol::store_layout(manifest, folder),
                                                std::make_shared<core::PosixDisk>());
    if (!reader || !manifest.complete)
        return false;
    for (std::size_t i = 0; i < manifest.layout.times.size(); ++i)
        if (!(*reader)->whole(i))
            return false;
    return true;
}

} // namespace

core::Result<core::DatasetInfo> describe_source(const ImportRequest& request) {
    auto plan = open_series(request.source).and_then([&](Series series) {
        return fingerprint(series).and_then(
            [&](const auto&) { return make_plan(request, std::move(series)); });
    });
    if (!plan)
        return tl::unexpected(plan.error());
    return read_step(*plan, 0, nullptr).map([&](const ImageStep& first) {
        protocol::StoreManifest manifest;
        manifest.info = describe(*plan, first);
        set_speed_range(manifest, speed_range(first.velocity, first.fluid));
        return manifest.info;
    });
}

core::Result<void> convert(const ImportRequest& request,
                           const std::filesystem::path& store,
                           const ShowProgress& show) {
    auto series = open_series(request.source);
    if (!series)
        return tl::unexpected(series.error());
    auto files = fingerprint(*series);
    if (!files)
        return tl::unexpected(files.error());
    protocol::StoreSource source{std::move(*files), {}, request.selection};
    auto writer = StoreWriter::open(store, [&] {
        show({"waiting", 0, 0, {}, "another import is writing this store"});
        return core::Result<void>();
    });
    if (!writer)
        return tl::unexpected(writer.error());
    const auto before = protocol::read_store_manifest(store, core::PosixDisk());
    if (before && before->source == source && whole(*before, store)) {
        const std::size_t total = before->layout.times.size();
        show({"done", total, total, {}, "the store is up to date"});
        return {};
    }
    if (!before || before->source != source)
        if (auto cleared = writer->clear(); !cleared)
            return cleared;
    auto plan = make_plan(request, std::move(*series));
    if (!plan)
        return tl::unexpected(plan.error());
    if (auto converted = Conversion(*plan, *writer, show).run(std::move(source)); !converted)
        return converted;
    show({"done", plan->times.size(), plan->times.size(), {}, {}});
    return {};
}

} // namespace wakesurf::server
