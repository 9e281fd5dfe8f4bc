#include "core/field/analytic_flow.hpp"
#include "server/net/methods/dataset_answers.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::dataset_answers_test {

TEST(DatasetAnswers, DescribeADatasetAnewOnceAnythingOfItHasChanged) {
    OpenDataset open;
    open.flow = *core::make_analytic_flow("abc");
    open.info.name = "wake";
    open.info.times = {0.0, 1.0};
    DatasetAnswers answers;
    const std::string first = answers.description("a", open);
    EXPECT_EQ(answers.description("a", open), first);
    open.info.note = "one file was left out"; // as an import ends
    const std::string noted = answers.description("a", open);
    EXPECT_NE(noted, first);
    EXPECT_NE(noted.find("one file was left out"), std::string::npos);
    open.info.times.push_back(2.0);
    EXPECT_NE(answers.description("a", open), noted);
}

} // namespace wakesurf::server::dataset_answers_test
