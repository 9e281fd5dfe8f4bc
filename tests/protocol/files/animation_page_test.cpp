// An animation is one file in which no name acts as markup, from which everything can be read again, and of which every byte counts.
#include "protocol/files/animation_page.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::protocol::animation_page_test {

namespace {

const std::string viewer =
    R"(<title>x</title><script type="text/plain" id="recipe"></script>
<script type="application/json" id="description"></script><script type="text/plain" id="body"></script>
<script type="text/plain" id="frames"></script><script>run()</script>)";

/// Two frames of two bytes.
const std::string frames("\2\0\0\0ab\2\0\0\0cd", 12);
const std::string body("\1\0\0\0b", 5);

AnimationDescription named(const std::string& title) {
    return {.title = title, .kind = "streak", .times = {0, 0.5}, .facts = {"It moves."}};
}

std::string page_of(const AnimationDescription& description,
                    const std::string& shown = frames,
                    const std::string& solid = body,
                    const std::string& of = viewer) {
    return animation_page(of, {description, shown, solid, "wakesurf-recipe:0."}).value();
}

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

TEST(AnimationPage, HoldsTheDescriptionTheRecipeAndTheFramesInBase64) {
    const std::string page = page_of(named("wake"), "any carnal pleasure");
    EXPECT_EQ(nlohmann::json::parse(between(page, R"(id="description">)"))["title"], "wake");
    EXPECT_EQ(between(page, R"(id="recipe">)"), "wakesurf-recipe:0.");
    EXPECT_EQ(between(page, R"(id="body">)"), "AQAAAGI=");
    EXPECT_EQ(between(page, R"(id="frames">)"), "YW55IGNhcm5hbCBwbGVhc3VyZQ==");
    EXPECT_TRUE(page.ends_with("<script>run()</script>"));
}

TEST(AnimationPage, KeepsNamesFromEndingTheirElementAndReturnsThemUnchanged) {
    const std::string title = "</script><script>alert(1)</script><!-- <img src=x onerror=alert(1)>";
    AnimationDescription description = named(title);
    description.look = read_look(R"({"scalar":"</script><script>"})").value();
    const std::string page = page_of(description);
    EXPECT_EQ(count(page, "<script"), count(viewer, "<script"));
    EXPECT_EQ(count(page, "</script"), count(viewer, "</script"));
    EXPECT_EQ(count(page, "<!--") + count(page, "<img"), 0u);
    const auto said = nlohmann::json::parse(between(page, R"(id="description">)"));
    EXPECT_EQ(said["title"], title);
    EXPECT_EQ(said["look"]["scalar"], "</script><script>");
}

TEST(AnimationPage, IsRefusedForAViewerWithoutThePlacesForData) {
    for (const std::string& other :
         {std::string(), std::string("<html></html>"), viewer + viewer, viewer.substr(0, 70)}) {
        const auto page = animation_page(other, {named("wake"), frames, body, ""});
        ASSERT_FALSE(page) << other;
        EXPECT_EQ(page.error().code, core::Error::Code::Corrupt);
    }
}

TEST(AnimationPage, TakesALookThatIsAnObjectAndNotLong) {
    EXPECT_EQ(read_look(R"( {"range": [0, 2],"map":"grey"} )").value(),
              R"({"map":"grey","range":[0,2]})");
    EXPECT_EQ(read_look("").value(), "");
    const std::string longer = R"({"map":")" + std::string(3000, 'a') + R"("})";
    for (const std::string& wrong : {std::string("viridis"), std::string("[1]"), longer,
                                     std::string(R"({"a":{"b":{"c":{}}}})")})
        EXPECT_FALSE(read_look(wrong)) << wrong;
}

TEST(AnimationPage, TellsWhereAnotherOneDiffers) {
    const std::string right = page_of(named("wake"));
    EXPECT_EQ(animation_difference(right, right), "");
    EXPECT_EQ(animation_difference(page_of(named("sheet")), right),
              "its description differs in `title`");
    std::string other = frames;
    other[10] = 'C';
    EXPECT_EQ(animation_difference(page_of(named("wake"), other), right),
              "the surface differs, in frame 2 of 2");
    EXPECT_EQ(animation_difference(page_of(named("wake"), frames, "x"), right), "the body differs");
    EXPECT_EQ(animation_difference(page_of(named("wake"), frames, ""), right),
              "it lacks the body of the data");
    EXPECT_EQ(
        animation_difference(page_of(named("wake"), frames, body, viewer + "<!-- 2 -->"), right),
        "its viewer differs, at byte " + std::to_string(viewer.size()) +
            " of it; what it shows is the same");
}

TEST(AnimationPage, IsAnotherOneWhicheverByteIsChanged) {
    const std::string right = page_of(named("wake"));
    for (std::size_t k = 0; k < right.size(); ++k) {
        std::string other = right;
        other[k] ^= 4;
        EXPECT_NE(animation_difference(other, right), "") << k;
        EXPECT_NE(animation_difference(right.substr(0, k), right), "") << k;
    }
}

} // namespace wakesurf::protocol::animation_page_test
