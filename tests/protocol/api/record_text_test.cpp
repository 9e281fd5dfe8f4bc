// Records to text and back: what a journal keeps is what there was, and what is no record is refused.
#include "protocol/api/record_text.hpp"

#include <gtest/gtest.h>

#include <random>

namespace wakesurf::protocol::record_text_test {

namespace {

RakeRecord some_rake(std::mt19937_64& random) {
    std::uniform_real_distribution<double> coordinate(-1e6, 1e6);
    RakeRecord record;
    record.rake = "r7";
    record.rev = random() >> 11;
    record.shape.kind = core::Rake::Kind::Polyline;
    for (int i = 0; i < 9; ++i)
        record.shape.points.emplace_back(coordinate(random), coordinate(random),
                                         coordinate(random));
    record.shape.seeds = 77;
    record.name = "<script>alert('\\u00e9')</script> \"é\" ' -- ; DROP";
    record.colour = "#0Fa973";
    record.author = "Ada Lovelace, \"countess\"";
    record.clipped = random() % 2 == 0;
    return record;
}

SurfaceRecord some_surface(std::mt19937_64& random) {
    std::uniform_real_distribution<double> number(-1e9, 1e9);
    SurfaceRecord record;
    record.surface = "s3";
    record.rev = 12;
    record.epoch = static_cast<std::uint32_t>(random());
    record.rake = "r7";
    record.dataset = "abc";
    core::SurfaceParameters& p = record.parameters;
    p.kind = static_cast<core::SurfaceKind>(random() % 4);
    p.direction = static_cast<core::Direction>(random() % 3);
    p.accuracy = static_cast<core::Accuracy>(random() % 3);
    p.interpolation = static_cast<core::Interpolation>(random() % 2);
    p.between = static_cast<core::Between>(random() % 3);
    p.from = number(random);
    p.to = number(random);
    p.separation = std::abs(number(random));
    p.merge = 0.1 + 1e-17 * number(random);
    p.angle = 33.3;
    p.max_quads = 1 + random() % 4'000'000;
    if (random() % 2 == 0)
        p.release_until = number(random);
    if (random() % 2 == 0)
        p.sweep = core::Vec3(number(random), 0.1, 1.0 / 3.0);
    if (random() % 2 == 0)
        record.rake2 = "r9";
    record.fields = {"p", "vorticity"};
    return record;
}

} // namespace

TEST(RecordText, EveryRecordComesBackWithTheSameBits) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 500; ++i) {
        const RakeRecord rake = some_rake(random);
        const auto rake_again = parse_rake(record_text(rake));
        ASSERT_TRUE(rake_again) << rake_again.error().message;
        EXPECT_EQ(*rake_again, rake);
        const SurfaceRecord surface = some_surface(random);
        const auto surface_again = parse_surface(record_text(surface));
        ASSERT_TRUE(surface_again) << surface_again.error().message;
        EXPECT_EQ(*surface_again, surface);
    }
    const BookmarkRecord bookmark{"b1", 3, "my view", R"({"camera":{"eye":[1.5,2,3]}})", 0.1};
    EXPECT_EQ(*parse_bookmark(record_text(bookmark)), bookmark);
    const AnnotationRecord annotation{"a1", 9, "one\ntwo\t\xc3\xa9", {0.1, 2, 3}, "Ada", "s3"};
    EXPECT_EQ(*parse_annotation(record_text(annotation)), annotation);
    const SliceRecord slice{"c1",    2,   "data", {0.1, 1e-300, -0.0}, {1.0 / 3.0, 2, 0}, "p",
                            "other", 0.1, {}};
    EXPECT_EQ(*parse_slice(record_text(slice)), slice);
    const LinesRecord lines{
        "l1",
        2,
        "data",
        {core::LineSeeds::Kind::Sphere, {{0.1, 1e-300, -0.0}}, 1.0 / 3.0, 7, {"in \"let", ""}},
        core::Direction::Backward,
        0.1,
        0.2,
        -1.0,
        1.0 / 7.0,
        "p"};
    EXPECT_EQ(*parse_lines(record_text(lines)), lines);
    std::string older = record_text(lines);
    older.erase(older.find("\"patches\""),
                std::string_view("\"patches\":[\"in \\\"let\",\"\"],").size());
    EXPECT_TRUE(parse_lines(older)->places.patches.empty()) << older;
    const SessionHead head{"a name", 1234, 5, 6, 7, 8};
    EXPECT_EQ(*parse_session_head(record_text(head)), head);
    const SessionHead measured{"a name", 1234, 5, 6, 7, 8, {"mm", ""}, 9, 10};
    EXPECT_EQ(*parse_session_head(record_text(measured)), measured);
}

TEST(RecordText, ARakeFromBeforeRakesHadColoursIsReadAndAWrongColourIsNot) {
    const auto rake = [](const std::string& more) {
        return parse_rake(
            R"({"rake":"r1","rev":3,"kind":"line","points":[[0,0,0],[1,0,0]],"seeds":8,)"
            R"("name":"r1","clipped":false)" +
            more + "}");
    };
    ASSERT_TRUE(rake(""));
    EXPECT_EQ(rake("")->colour, "");
    EXPECT_EQ(rake("")->author, "");
    EXPECT_EQ(rake(R"(,"colour":"#123aBc","author":"Ada")")->colour, "#123aBc");
    for (const char* wrong : {"red", "#12345", "#12345g", "#1234567", "url(x)"})
        EXPECT_FALSE(rake(R"(,"colour":")" + std::string(wrong) + "\"")) << wrong;
}

TEST(RecordText, ASurfaceFromBeforeMayHaveMoreFieldsThanOneIsAskedForWithNow) {
    std::mt19937_64 random(1);
    SurfaceRecord record = some_surface(random);
    record.fields = {"a", "b", "c", "d", "e", "f"};
    EXPECT_EQ(parse_surface(record_text(record)).value(), record);
}

TEST(RecordText, HasOfPlacesAndLinksWhatIsSaid) {
    const std::string digest(64, 'a');
    const MembershipRecord place{"Ada", "#102030", "editor", "", digest};
    EXPECT_EQ(record_text(place),
              R"({"colour":"#102030","grant":"","name":"Ada","role":"editor","roleSet":true,)"
              R"("sha256":")" +
                  digest + "\"}");
    EXPECT_EQ(*parse_membership(record_text(place)), place);
    EXPECT_TRUE(parse_membership(R"({"name":"","colour":"","role":"","grant":"","sha256":""})"))
        << "from before there was roleSet";
    const GrantRecord link{"viewer", digest, 5, "Ada", {"g1"}, {{"p1", "viewer"}}, "g2"};
    EXPECT_EQ(*parse_grant(record_text(link)), link);
    for (const char* damaged : {"[]", R"({"role":"viewer"})", R"({"role":"viewer","sha256":7})",
                                R"({"role":"viewer","sha256":"","expires":0.5})",
                                R"({"role":"viewer","sha256":"","lineage":["g1",2]})",
                                R"({"role":"viewer","sha256":"","lowered":{"p1":true}})"})
        EXPECT_EQ(parse_grant(damaged).error().message, "a saved share link is damaged") << damaged;
}

TEST(RecordText, ALeaseIsNotKept) {
    std::mt19937_64 random(1);
    RakeRecord record = some_rake(random);
    record.dragging = true;
    record.leased_by = "p1";
    const auto again = parse_rake(record_text(record));
    ASSERT_TRUE(again);
    EXPECT_FALSE(again->dragging);
    EXPECT_EQ(again->leased_by, "");
}

TEST(RecordText, WhatANewerServerAddedIsPassedOver) {
    const auto head = parse_session_head(
        R"({"name":"n","seq":1,"nextRake":1,"nextSurface":1,"nextBookmark":1,"nextAnnotation":1,"x":{}})");
    EXPECT_TRUE(head);
}

TEST(RecordText, DamageIsAnErrorOrAnotherSoundRecord) {
    std::mt19937_64 random(2);
    std::size_t refused = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string text =
            i % 2 == 0 ? record_text(some_rake(random)) : record_text(some_surface(random));
        for (std::uint64_t n = 1 + random() % 3; n > 0; --n)
            text[random() % text.size()] = static_cast<char>(random());
        if (random() % 4 == 0)
            text.resize(random() % text.size());
        if (i % 2 == 0) {
            const auto rake = parse_rake(text);
            refused += rake ? 0 : 1;
            if (rake) {
                EXPECT_TRUE(parse_rake(record_text(*rake))) << text;
            }
        } else {
            const auto surface = parse_surface(text);
            refused += surface ? 0 : 1;
            if (surface) {
                EXPECT_TRUE(parse_surface(record_text(*surface))) << text;
            }
        }
    }
    EXPECT_GT(refused, 1000u);
}

TEST(RecordText, RefusesWhatASetterWouldRefuse) {
    for (
        const char* text : {
            "",
            "null",
            "[]",
            "{}",
            "{\"rake\":\"r1\"}",
            R"({"rake":"r1","rev":1,"kind":"line","points":[[0,0,0]],"seeds":5,"name":""})",
            R"({"rake":"r1","rev":1,"kind":"line","points":[[0,0,0],[0,0,0]],"seeds":5,"name":""})",
            R"({"rake":"r1","rev":1,"kind":"line","points":[[0,0,0],[1e39,0,0]],"seeds":5})",
            R"({"rake":"r1","rev":1,"kind":"line","points":[[0,0,0],[1,0,0]],"seeds":5000})",
            R"({"rake":"r1","rev":-1,"kind":"line","points":[[0,0,0],[1,0,0]],"seeds":5})",
            R"({"rake":"r1","rev":1,"kind":"knot","points":[[0,0,0],[1,0,0]],"seeds":5})",
            R"({"rake":7,"rev":1,"kind":"line","points":[[0,0,0],[1,0,0]],"seeds":5})",
        })
        EXPECT_FALSE(parse_rake(text)) << text;
    const std::string deep = std::string(R"({"bookmark":"b1","rev":1,"name":"n","view":{"a":)") +
                             std::string(100, '[') + std::string(100, ']') + "}}";
    EXPECT_FALSE(parse_bookmark(deep));
    const std::string long_view =
        R"({"bookmark":"b1","rev":1,"name":"n","view":{"a":")" + std::string(5000, 'x') + "\"}}";
    EXPECT_FALSE(parse_bookmark(long_view));
}

} // namespace wakesurf::protocol::record_text_test
