// A catalogue and a way to wait for reports of its import threads.
#pragma once

#include "server/data/dataset_catalogue.hpp"
#include "server/data/import_process.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/slow_series.hpp"
#include "tests/support/temporary_folder.hpp"

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::server {

using namespace tests;

class CatalogueBench {
  public:
    explicit CatalogueBench(const std::vector<std::string>& arguments)
        : CatalogueBench(arguments, std::filesystem::path()) {}

    /// Opens a catalogue with the stores of an earlier one.
    CatalogueBench(const std::vector<std::string>& arguments,
                   const std::filesystem::path& stores,
                   const std::filesystem::path& importer = importer_program(),
                   std::size_t lanes = 4,
                   const command::SourceOptions& taken = {}) {
        OpenOptions options{stores, {}, importer};
        options.lanes = lanes;
        options.taken = taken;
        begin(arguments, std::move(options));
    }

    CatalogueBench(const std::vector<std::string>& arguments, OpenOptions options) {
        begin(arguments, std::move(options));
    }

    ~CatalogueBench() { catalogue.reset(); }

    /// Waits for reports of the import thread until `wanted(status)`.
    template <class Wanted>
    DatasetStatus wait_until(const std::string& dataset, const Wanted& wanted) {
        std::unique_lock lock(mutex_);
        DatasetStatus status;
        changed_.wait(lock, [&] {
            status = catalogue->status(dataset).value();
            return wanted(status);
        });
        return status;
    }

    DatasetStatus wait_until_settled(const std::string& dataset) {
        return wait_until(dataset, [](const DatasetStatus& status) {
            return status.state != DatasetState::Importing;
        });
    }

    /// Waits until the importer that was stopped has ended and removed its unfinished files.
    bool tidies_up() {
        for (int i = 0; i < 3000 && unfinished_files(folder_.path()) > 0; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return unfinished_files(folder_.path()) == 0;
    }

    std::unique_ptr<DatasetCatalogue> catalogue;
    std::optional<core::Error> error;

  private:
    void begin(const std::vector<std::string>& arguments, OpenOptions options) {
        if (options.store_root.empty())
            options.store_root = folder_ / "cache";
        options.watch_period = std::chrono::milliseconds(20);
        auto opened = DatasetCatalogue::open(arguments, options, [this](const std::string&) {
            const std::scoped_lock lock(mutex_);
            ++changes_;
            changed_.notify_all();
        });
        if (opened)
            catalogue = std::move(*opened);
        else
            error = opened.error();
    }

    TemporaryFolder folder_;
    std::mutex mutex_;
    std::condition_variable changed_;
    int changes_ = 0;
};

} // namespace wakesurf::server
