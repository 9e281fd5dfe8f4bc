// One server for all tests of a suite, started before the first and stopped after the last.
#pragma once

#include "tests/support/server/server_process.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests {

/// Starts a server for a suite. A fixture whose server has other arguments calls start() in a SetUpTestSuite
/// of its own. Suites run one after the other, so that all of them share these members.
class ServerSuite : public testing::Test {
  protected:
    static void SetUpTestSuite() { start({"flow:lamb-oseen"}); }

    static void TearDownTestSuite() {
        server_.reset();
        folder_.reset();
    }

    static void start(std::vector<std::string> arguments) { server_.emplace(std::move(arguments)); }

    inline static std::optional<ServerProcess> server_;
    /// Holds what a SetUpTestSuite puts there.
    inline static std::optional<TemporaryFolder> folder_;
};

} // namespace wakesurf::tests
