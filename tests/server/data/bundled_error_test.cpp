// The errors that surfaces of the bundled simulation state, against the exact surfaces.
#include "server/data/dataset_argument.hpp"
#include "server/data/open_dataset.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/true_errors.hpp"

namespace wakesurf::server::bundled_error_test {

using namespace tests;

TEST(StatedError, HoldsFromBothSidesOnTheBundledSimulation) {
    const TemporaryFolder folder;
    const auto argument = resolve_dataset((source_folder() / "data/sqcyl/sqcyl.pvd").string());
    ASSERT_TRUE(argument) << argument.error().message;
    const auto dataset =
        open_dataset(*argument, {folder.path(), {}}, [](const store::ImportProgress&) {});
    ASSERT_TRUE(dataset) << dataset.error().message;
    for (std::uint32_t seed = 1; seed < 3; ++seed) {
        SCOPED_TRACE(seed);
        // All vertices. Of some 330 of a surface three are 1e-4 off; a sample of 60 either had them or not.
        expect_true_errors(*dataset->flow, 7.5, seed, 1000);
    }
}

} // namespace wakesurf::server::bundled_error_test
