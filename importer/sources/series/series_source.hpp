// The common part of readers whose sources are files of one time-step each, or of several: the file and time
// of each step.
#pragma once

#include "importer/base/source.hpp"
#include "importer/sources/series/file_series.hpp"
#include "importer/sources/series/series_times.hpp"

namespace wakesurf::importer {

/// Finds the file of each step; `Time` identifies a time-step within its file.
template <class Time>
class SeriesSource : public Source {
  public:
    /// @param velocity  names the one asked for; may be empty
    SeriesSource(FileSeries series, std::string velocity)
        : series_(std::move(series)), velocity_(std::move(velocity)) {
        description_.name = series_.name;
    }

    /// Returns a single file, which all time-steps share; of several, each time-step has its own.
    core::Result<std::vector<store::SourceFile>> shared_files() const override {
        return several() ? core::Result<std::vector<store::SourceFile>>()
                         : fingerprint(series_.entries.front().parts);
    }

    core::Result<std::vector<store::SourceFile>> files(std::size_t step) const override {
        return several() ? fingerprint(series_.entries[steps_[step].file].parts)
                         : core::Result<std::vector<store::SourceFile>>();
    }

  protected:
    struct Step {
        std::size_t file = 0;
        Time time{};
    };

    const ListedFile& listed(std::size_t entry) const {
        return series_.entries[entry].parts.front();
    }

    /// Describes the times, one for each of the steps, and keeps the remaining steps, in their order.
    core::Result<void> settle_steps(std::vector<TimedEntry> times) {
        return describe_times(std::move(times), description_).map([&](const auto& order) {
            keep_in_order(steps_, order);
        });
    }

    FileSeries series_;
    std::string velocity_;
    std::vector<Step> steps_;

  private:
    bool several() const { return series_.entries.size() > 1; }
};

/// Opens the series at `path` with a reader that takes it and the velocity asked for. Error: as
/// open_file_series and `opened` have.
template <class Reader>
core::Result<std::unique_ptr<Source>> open_series(const std::filesystem::path& path,
                                                  const command::SourceOptions& wish) {
    return open_file_series(path, wish.alone).and_then([&](FileSeries series) {
        return opened<Reader>(std::move(series), wish.velocity);
    });
}

} // namespace wakesurf::importer
