// An animation is one file in which no name acts as markup, and from which everything can be read again.
#include "protocol/files/animation_page.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::protocol::animation_page_test {

namespace {

const std::string viewer =
    R"(<title>x</title><script type="application/json" id="description"></script>
<script type="text/plain" id="frames"></script><script>run()</script>)";

std::string between(const std::string& page, const std::string& begin) {
    const auto from = page.find(begin) + begin.size();
    return page.substr(from, page.find("</script>", from) - from);
}

std::size_t count(const std::string& page, const std::string& words) {
    std::size_t found = 0;
    for (auto at = page.find(words); at != std::string::npos; at = page.find(words, at + 1))
        ++found;
    return found;
}

} // namespace

TEST(AnimationPage, HoldsTheDescriptionAndTheFramesInBase64) {
    const auto page = animation_page(viewer, R"({"title":"wake"})", "any carnal pleasure");
    ASSERT_TRUE(page) << page.error().message;
    EXPECT_EQ(between(*page, R"(id="description">)"), R"({"title":"wake"})");
    EXPECT_EQ(between(*page, R"(id="frames">)"), "YW55IGNhcm5hbCBwbGVhc3VyZQ==");
    EXPECT_TRUE(page->ends_with("<script>run()</script>"));
}

TEST(AnimationPage, KeepsNamesFromEndingTheirElementAndReturnsThemUnchanged) {
    const nlohmann::json named{
        {"title", "</script><script>alert(1)</script><!-- <img src=x onerror=alert(1)>"}};
    const auto page = animation_page(viewer, named.dump(), "");
    ASSERT_TRUE(page) << page.error().message;
    EXPECT_EQ(count(*page, "<script"), count(viewer, "<script"));
    EXPECT_EQ(count(*page, "</script"), count(viewer, "</script"));
    EXPECT_EQ(count(*page, "<!--") + count(*page, "<img"), 0u);
    EXPECT_EQ(nlohmann::json::parse(between(*page, R"(id="description">)")), named);
}

TEST(AnimationPage, IsRefusedForAViewerWithoutTheTwoPlacesForData) {
    for (const std::string& other :
         {std::string(), std::string("<html></html>"), viewer + viewer, viewer.substr(0, 70)}) {
        const auto page = animation_page(other, "{}", "");
        ASSERT_FALSE(page) << other;
        EXPECT_EQ(page.error().code, core::Error::Code::Corrupt);
    }
}

} // namespace wakesurf::protocol::animation_page_test
