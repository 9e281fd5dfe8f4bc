// wakesurf-import as a process, with a folder of its own for sources and the store it makes.
#pragma once

#include "server/data/child_process.hpp"
#include "server/data/import_process.hpp"
#include "store/store_manifest.hpp"
#include "store/store_reader.hpp"
#include "tests/support/places.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/vti_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace wakesurf::importer {

using namespace tests;
using server::describe_with_import_process;
using server::run_child;
using server::run_import_process;
namespace fs = std::filesystem;

struct Outcome {
    int status = 0;
    std::string errors;
    std::vector<std::string> lines;
};

inline Outcome import(const std::vector<std::string>& arguments) {
    Outcome out;
    const auto run = run_child(importer_program(), arguments, 0,
                               [&](std::string_view line) { out.lines.emplace_back(line); }, {});
    out.status = run->signal != 0 ? -run->signal : run->exit_status;
    out.errors = run->errors;
    return out;
}

class Import : public testing::Test {
  protected:
    fs::path store() const { return folder_ / "store"; }

    fs::path put(const std::string& name, const std::string& text) const {
        write_file(folder_ / name, text);
        return folder_ / name;
    }

    Outcome run(const std::string& name, std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {folder_ / name, store()});
        return import(options);
    }

    // Expects status 1 and one line on standard error that holds `words`; no store is left complete.
    void expect_refusal(const std::string& name,
                        const std::string& words,
                        std::vector<std::string> options = {}) {
        const auto outcome = run(name, std::move(options));
        EXPECT_EQ(outcome.status, 1) << name;
        EXPECT_NE(outcome.errors.find(words), std::string::npos) << name << ": " << outcome.errors;
        EXPECT_TRUE(outcome.errors.starts_with("wakesurf-import: ")) << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
            << outcome.errors;
        EXPECT_EQ(outcome.errors.find(folder_.path().string()), std::string::npos)
            << outcome.errors;
        const auto manifest = store::read_store_manifest(store(), core::PosixDisk());
        EXPECT_FALSE(manifest && manifest->complete) << name;
        fs::remove_all(store());
    }

    store::StoreManifest manifest() const {
        return store::read_store_manifest(store(), core::PosixDisk()).value();
    }

    std::shared_ptr<const store::StoreReader> reader() const {
        return store::StoreReader::open(store::store_layout(manifest(), store()),
                                        std::make_shared<core::PosixDisk>())
            .value();
    }

    std::vector<float> velocity(std::size_t index) const {
        const auto step = reader()->load(index, {}).value();
        return {step->velocity().begin(), step->velocity().end()};
    }

    TemporaryFolder folder_;
};

inline const fs::path bundled = source_folder() / "data" / "sqcyl" / "sqcyl.pvd";

} // namespace wakesurf::importer
