#include "server/remote/web/web_disk.hpp"
#include "tests/support/fake_web.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

namespace wakesurf::server::web_disk_test {

namespace {

using core::Error;
using tests::FakeWeb;
using namespace std::chrono_literals;

constexpr std::size_t values_bytes = 4000;

class WebDiskTest : public testing::Test {
  protected:
    WebDiskTest() {
        tests::write_file(folder_ / "store.json", "{}");
        std::string values(values_bytes, '\0');
        std::iota(values.begin(), values.end(), '\0');
        tests::write_file(folder_ / "u.f32", values);
    }

    static std::filesystem::path file(const std::string& name) {
        return std::filesystem::path(FakeWeb::address) / name;
    }

    core::Result<std::string> read(const std::string& name, std::uint64_t at, std::size_t bytes) {
        std::string out(bytes, '?');
        return disk_.read(file(name), at, std::as_writable_bytes(std::span(out))).map([&] {
            return out;
        });
    }

    /// Why a part of the values cannot be read, where the server answers that to every question for a part.
    Error error_where(const std::function<void(HttpAnswer&)>& change) {
        web_->instead([this, change](const HttpRequest& request, std::span<std::byte> body) {
            auto answer = web_->answer(request, body);
            if (request.range)
                change(*answer);
            return std::optional(std::move(answer));
        });
        const auto got = read("u.f32", 100, 200);
        return got ? Error{Error::Code::Cancelled, "it was read", ""} : got.error();
    }

    tests::TemporaryFolder folder_;
    std::shared_ptr<FakeWeb> web_ = std::make_shared<FakeWeb>(folder_.path());
    std::vector<std::chrono::milliseconds> pauses_;
    WebDisk disk_{web_, [this](std::chrono::milliseconds time, const std::stop_token&) {
                      pauses_.push_back(time);
                  }};
};

void expect_error(const Error& error, Error::Code code, const std::string& words) {
    EXPECT_EQ(error.code, code) << error.message;
    EXPECT_EQ(error.message, "https://example.org/data/u.f32" + words);
}

} // namespace

TEST_F(WebDiskTest, ReadsWhatDescribesAStoreWithOneQuestion) {
    EXPECT_EQ(disk_.size(file("store.json")), 2u);
    EXPECT_EQ(read("store.json", 0, 2), "{}");
    EXPECT_EQ(read("store.json", 1, 1), "}");
    EXPECT_EQ(web_->asked(), (std::vector<std::string>{"store.json 0+262144"}));
}

TEST_F(WebDiskTest, AsksOnlyForThoseValuesThatAreWanted) {
    EXPECT_EQ(read("u.f32", 65, 3), "ABC");
    EXPECT_EQ(disk_.identity(file("u.f32"))->size, values_bytes);
    EXPECT_EQ(read("u.f32", values_bytes - 1, 1).value().size(), 1u);
    EXPECT_EQ(web_->asked(),
              (std::vector<std::string>{"HEAD u.f32", "u.f32 65+3", "u.f32 3999+1"}));
}

TEST_F(WebDiskTest, AsksForLongReadsInPartsOf16MiB) {
    tests::write_file(folder_ / "long.f32", std::string((std::size_t{16} << 20) + 7, 'x'));
    EXPECT_EQ(read("long.f32", 2, (std::size_t{16} << 20) + 5).value(),
              std::string((std::size_t{16} << 20) + 5, 'x'));
    EXPECT_EQ(web_->asked(), (std::vector<std::string>{"HEAD long.f32", "long.f32 2+16777216",
                                                       "long.f32 16777218+5"}));
}

TEST_F(WebDiskTest, OneThreadLooksAtAnObjectForAllThatWantIt) {
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([&] { EXPECT_EQ(disk_.size(file("u.f32")), values_bytes); });
    for (auto& each : threads)
        each.join();
    EXPECT_EQ(web_->asked().size(), 1u);
}

TEST_F(WebDiskTest, AsksAgainAfterLongerAndLongerPausesWhereAServerIsBusy) {
    int busy = 3;
    web_->instead([&](const HttpRequest&, std::span<std::byte>) -> std::optional<FakeWeb::Answer> {
        if (busy-- == 0)
            return std::nullopt;
        HttpAnswer answer;
        answer.status = 503;
        return answer;
    });
    EXPECT_EQ(read("store.json", 0, 2), "{}");
    EXPECT_EQ(pauses_, (std::vector<std::chrono::milliseconds>{100ms, 200ms, 400ms}));
}

TEST_F(WebDiskTest, WaitsAsLongAsABusyServerAsksItToButNotForMinutes) {
    int busy = 2;
    web_->instead([&](const HttpRequest&, std::span<std::byte>) -> std::optional<FakeWeb::Answer> {
        if (busy == 0)
            return std::nullopt;
        HttpAnswer answer;
        answer.status = 429;
        answer.retry_after = std::chrono::seconds(busy-- == 2 ? 2 : 600);
        return answer;
    });
    EXPECT_EQ(read("store.json", 0, 2), "{}");
    EXPECT_EQ(pauses_, (std::vector<std::chrono::milliseconds>{2000ms, 5000ms}));
}

TEST_F(WebDiskTest, GivesUpAfterTheFifthTryAndSaysWhatWasWrong) {
    expect_error(error_where([](HttpAnswer& answer) { answer.status = 503; }), Error::Code::Io,
                 ": the server answered 503, 5 times");
    EXPECT_EQ(web_->asked().size(), 6u) << "one to look at it, five to read";
    web_->instead([](const HttpRequest&, std::span<std::byte>) {
        return FakeWeb::Answer(tl::unexpected(HttpFault{"the connection was reset", true}));
    });
    expect_error(read("u.f32", 0, 1).error(), Error::Code::Io,
                 ": the connection was reset, 5 times");
}

TEST_F(WebDiskTest, ReadsAgainWhatEndedEarly) {
    int cut = 2;
    const auto error = error_where([&](HttpAnswer& answer) {
        if (cut-- > 0)
            answer.bytes = 10;
    });
    EXPECT_EQ(error.message, "it was read");
    expect_error(error_where([](HttpAnswer& answer) { answer.bytes = 10; }), Error::Code::Io,
                 ": the answer ends before it should, 5 times");
}

TEST_F(WebDiskTest, AsksOnceForWhatWillNotChange) {
    EXPECT_EQ(read("none.json", 0, 1).error().code, Error::Code::NotFound);
    EXPECT_EQ(read("none.json", 0, 1).error().message,
              "https://example.org/data/none.json is not there");
    EXPECT_EQ(web_->asked().size(), 2u);
    expect_error(
        error_where([](HttpAnswer& answer) { answer.status = 403; }), Error::Code::Io,
        ": the server answered 403: access is denied, or not allowed with these credentials");
    expect_error(error_where([](HttpAnswer& answer) {
                     answer.status = 302;
                     answer.location = "file:///etc/passwd\n";
                 }),
                 Error::Code::Io, ": the server answered 302, a redirect: file:///etc/passwd?");
    EXPECT_TRUE(pauses_.empty());
}

TEST_F(WebDiskTest, TellsAWebPageFromAFile) {
    expect_error(error_where([](HttpAnswer& answer) {
                     answer.status = 200;
                     answer.content_type = "text/html; charset=utf-8";
                 }),
                 Error::Code::Corrupt, ": the server answers with a web page instead of the file");
}

TEST_F(WebDiskTest, NoticesThatAnotherObjectTookThePlaceOfOneThatIsOpen) {
    ASSERT_TRUE(disk_.size(file("u.f32")));
    const std::string changed = " has changed since it was opened";
    expect_error(error_where([](HttpAnswer& answer) { answer.etag = "\"other\""; }),
                 Error::Code::Corrupt, changed);
    expect_error(error_where([](HttpAnswer& answer) { answer.range->total += 1; }),
                 Error::Code::Corrupt, changed);
    web_->instead({});
    EXPECT_TRUE(read("u.f32", 0, 1));
    tests::write_file(folder_ / "u.f32", std::string(values_bytes, 'x'));
    expect_error(read("u.f32", 0, 1).error(), Error::Code::Corrupt, changed);
}

TEST_F(WebDiskTest, TellsObjectsApartByTheirTimeWhereTheyHaveNoMark) {
    std::string modified = "Mon, 02 Nov 2026 10:00:00 GMT";
    web_->instead([&](const HttpRequest& request, std::span<std::byte> body) {
        EXPECT_EQ(request.if_match, "");
        auto answer = web_->answer(request, body);
        answer->etag.clear();
        answer->last_modified = modified;
        return std::optional(std::move(answer));
    });
    EXPECT_TRUE(read("u.f32", 0, 1));
    modified = "Mon, 02 Nov 2026 10:00:01 GMT";
    expect_error(read("u.f32", 0, 1).error(), Error::Code::Corrupt,
                 " has changed since it was opened");
}

TEST_F(WebDiskTest, TakesNoPartForAnother) {
    const std::string other = ": the server sends a different part than was requested";
    expect_error(error_where([](HttpAnswer& answer) {
                     answer.range->first = 101;
                     answer.range->last = 300;
                 }),
                 Error::Code::Corrupt, other);
    expect_error(error_where([](HttpAnswer& answer) { answer.longer = true; }),
                 Error::Code::Corrupt, other);
    expect_error(error_where([](HttpAnswer& answer) { answer.range.reset(); }),
                 Error::Code::Corrupt, other);
    expect_error(error_where([](HttpAnswer& answer) { answer.status = 200; }), Error::Code::Io,
                 ": the server answers with the whole file although a part was requested");
}

TEST_F(WebDiskTest, ReadsNothingBeyondTheEndOfAnObject) {
    expect_error(read("u.f32", values_bytes - 1, 2).error(), Error::Code::Corrupt,
                 " ends before it should");
    expect_error(read("u.f32", ~std::uint64_t{0}, 2).error(), Error::Code::Corrupt,
                 " ends before it should");
    EXPECT_EQ(web_->asked(), (std::vector<std::string>{"HEAD u.f32"}));
}

TEST_F(WebDiskTest, EndsWhereItIsStopped) {
    std::stop_source stop;
    web_->instead([&](const HttpRequest&, std::span<std::byte>) {
        stop.request_stop();
        return FakeWeb::Answer(tl::unexpected(HttpFault{"the connection was reset", true}));
    });
    std::vector<std::byte> out(1);
    const auto got = disk_.read_stoppable(file("u.f32"), 0, out, stop.get_token());
    EXPECT_EQ(got.error().code, Error::Code::Cancelled);
    EXPECT_EQ(web_->asked().size(), 1u);
}

TEST_F(WebDiskTest, EndsEveryQuestionWhereItsDatasetIsClosed) {
    std::stop_source closing;
    const WebDisk disk(web_, WebDisk::wait, closing.get_token());
    web_->instead([&](const HttpRequest&, std::span<std::byte>) {
        closing.request_stop();
        return FakeWeb::Answer(tl::unexpected(HttpFault{"the connection was reset", true}));
    });
    EXPECT_EQ(disk.size(file("u.f32")).error().code, Error::Code::Cancelled);
    std::vector<std::byte> out(1);
    EXPECT_EQ(disk.read(file("u.f32"), 0, out).error().code, Error::Code::Cancelled);
    EXPECT_EQ(web_->asked().size(), 2u);
}

} // namespace wakesurf::server::web_disk_test
