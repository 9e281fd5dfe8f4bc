// A Zarr on a web server that answers badly: no chunk is taken for another, and each error names the chunk.
#include "server/remote/web/web_disk.hpp"
#include "server/remote/zarr/zarr_disk.hpp"
#include "store/open_store.hpp"
#include "tests/support/fake_web.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>

namespace wakesurf::server::zarr_web_test {

namespace {

using core::Error;
using nlohmann::json;
using tests::FakeWeb;

constexpr std::size_t side =
    48; // nodes an axis: a chunk is longer than what is read of it at the first look

class ZarrWebTest : public testing::Test {
  protected:
    ZarrWebTest() {
        json arrays;
        for (const char* name : {"u", "v", "w"}) {
            arrays[std::string(name) + "/.zarray"] = {{"zarr_format", 2},
                                                      {"shape", {side, side, side}},
                                                      {"chunks", {side, side, side}},
                                                      {"dtype", "<f4"},
                                                      {"order", "C"},
                                                      {"filters", nullptr},
                                                      {"compressor", nullptr},
                                                      {"fill_value", 0.0}};
            put(std::string(name) + "/0.0.0", std::string(bytes, '\0'));
        }
        put(".zmetadata", json{{"metadata", arrays}}.dump());
    }

    void put(const std::string& name, const std::string& text) const {
        const auto file = folder_ / "wake.zarr" / name;
        std::filesystem::create_directories(file.parent_path());
        tests::write_file(file, text);
    }

    /// Why the time-step cannot be read. @param change  of what the server answers about v's chunk
    Error error_where(const std::function<void(const HttpRequest&, HttpAnswer&)>& change) const {
        const auto web = std::make_shared<FakeWeb>(folder_.path());
        web->instead([&web = *web, change](const HttpRequest& request, std::span<std::byte> body) {
            auto answer = web.answer(request, body);
            if (request.address.ends_with("/v/0.0.0"))
                change(request, *answer);
            return std::optional(std::move(answer));
        });
        const auto disk = std::make_shared<const WebDisk>(
            web, [](std::chrono::milliseconds, const std::stop_token&) {});
        const auto root = std::filesystem::path(FakeWeb::address) / "wake.zarr";
        const auto zarr = ZarrDisk::open(root, disk, 0);
        if (!zarr)
            return zarr.error();
        const auto step = store::open_store(root, *zarr).value().reader->load(0, {});
        return step ? Error{Error::Code::Cancelled, "it was read", ""} : step.error();
    }

    static constexpr std::size_t bytes = side * side * side * sizeof(float);
    tests::TemporaryFolder folder_;
};

void expect_error(const Error& error, Error::Code code, const std::string& words) {
    EXPECT_EQ(error.code, code) << error.message;
    EXPECT_NE(error.message.find("chunk v/0.0.0: "), std::string::npos) << error.message;
    EXPECT_NE(error.message.find(words), std::string::npos) << error.message;
}

} // namespace

TEST_F(ZarrWebTest, IsReadWhereTheServerAnswersWell) {
    EXPECT_EQ(error_where([](const HttpRequest&, HttpAnswer&) {}).message, "it was read");
}

TEST_F(ZarrWebTest, AWebPageInPlaceOfAChunkIsNoChunk) {
    expect_error(error_where([](const HttpRequest&, HttpAnswer& answer) {
                     answer.status = 200;
                     answer.content_type = "text/html";
                 }),
                 Error::Code::Corrupt, "the server answers with a web page instead of the file");
}

TEST_F(ZarrWebTest, AChunkThatAlwaysEndsEarlyIsGivenUp) {
    expect_error(error_where([](const HttpRequest& request, HttpAnswer& answer) {
                     if (!request.head)
                         answer.bytes /= 2;
                 }),
                 Error::Code::Io, "the answer ends before it should, 5 times");
}

TEST_F(ZarrWebTest, AChunkThatWasCutWhenItWasCopiedThereIsNoticedByItsLength) {
    put("v/0.0.0", std::string(100, '\0'));
    expect_error(error_where([](const HttpRequest&, HttpAnswer&) {}), Error::Code::Corrupt,
                 "it has 100 bytes instead of " + std::to_string(bytes));
}

TEST_F(ZarrWebTest, AChunkThatIsReplacedBetweenTheLookAndTheReadIsNoticed) {
    int asked = 0;
    expect_error(error_where([&asked](const HttpRequest&, HttpAnswer& answer) {
                     if (asked++ > 0)
                         answer.etag = "\"other\"";
                 }),
                 Error::Code::Corrupt, "has changed since it was opened");
}

TEST_F(ZarrWebTest, AChunkThatMayNotBeReadIsNotOneThatIsNotThere) {
    expect_error(error_where([](const HttpRequest&, HttpAnswer& answer) {
                     answer.status = 403;
                     answer.bytes = 0;
                 }),
                 Error::Code::Io, "the server answered 403");
}

TEST_F(ZarrWebTest, AChunkThatIsNotThereIsFilled) {
    std::filesystem::remove(folder_ / "wake.zarr/v/0.0.0");
    EXPECT_EQ(error_where([](const HttpRequest&, HttpAnswer&) {}).message, "it was read");
}

} // namespace wakesurf::server::zarr_web_test
