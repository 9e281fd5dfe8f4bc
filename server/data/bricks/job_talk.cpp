#include "server/data/bricks/job_talk.hpp"

#include "core/base/crc32c.hpp"
#include "server/data/bricks/local_socket.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::Result;

namespace {

constexpr std::size_t most_answers = 1024; // in a message

tl::unexpected<Error> job_gone() {
    return core::fail(Error::Code::Io, "the job has ended");
}

tl::unexpected<Error> no_sense(const char* what) {
    return core::fail(Error::Code::Corrupt,
                      std::string("the job sent an invalid message: ") + what);
}

} // namespace

Result<std::optional<JobTalk>> JobTalk::meet(OpenFile& guest, const WantedJob& wanted) {
    std::array<std::byte, sizeof(JobHello) + longest_marks> words;
    const Received came = receive_message(guest.get(), words);
    if (came.state == Received::State::Nothing)
        return std::nullopt;
    if (came.state == Received::State::Closed)
        return job_gone();
    if (came.bytes < sizeof(JobHello) || came.bytes > words.size())
        return no_sense("its first message is too short or too long");
    JobHello hello;
    std::memcpy(&hello, words.data(), sizeof(hello));
    if (hello.magic != job_magic)
        return no_sense("its first message is not from wakesurf-bricks");
    if (hello.version != job_version)
        return core::fail(Error::Code::InvalidArgument, "the job is of another version of wakesurf",
                          "install wakesurf and wakesurf-bricks of one version");
    const std::string_view marks(reinterpret_cast<const char*>(words.data()) + sizeof(hello),
                                 came.bytes - sizeof(hello));
    if (hello.shape != wanted.shape)
        return core::fail(Error::Code::InvalidArgument,
                          "the job holds the bricks of another store");
    if (marks.empty() || wanted.contradicts(marks))
        return core::fail(Error::Code::InvalidArgument,
                          "the job holds values other than those of the served store",
                          "the store was written again: the next job reads the new one");
    const ServerWelcome welcome{job_magic, static_cast<std::uint32_t>(wanted.slots),
                                brick_record_bytes(wanted.shape.values),
                                static_cast<std::uint64_t>(wanted.patience.count())};
    auto slots = SharedSlots::make(wanted.slots, welcome.slot_bytes);
    if (!slots)
        return tl::unexpected(slots.error());
    if (!send_message(guest.get(), std::as_bytes(std::span(&welcome, 1)), slots->file()))
        return job_gone();
    return JobTalk(std::move(guest), std::move(*slots), hello);
}

JobTalk::JobTalk(OpenFile socket, SharedSlots slots, const JobHello& hello)
    : socket_(std::move(socket)), slots_(std::move(slots)), ranks_(hello.ranks), held_(hello.held),
      asked_(slots_.count()) {
    for (std::size_t i = slots_.count(); i-- > 0;)
        free_.push_back(static_cast<std::uint32_t>(i));
}

Result<std::vector<std::uint32_t>> JobTalk::ask(std::span<const BrickAsk> bricks) {
    std::vector<BrickAsk> asks(bricks.begin(), bricks.end());
    std::vector<std::uint32_t> out;
    for (BrickAsk& each : asks) {
        each.slot = free_.back();
        free_.pop_back();
        asked_[each.slot] = each;
        out.push_back(each.slot);
    }
    if (!send_message(socket_.get(), std::as_bytes(std::span(asks))))
        return job_gone();
    return out;
}

Result<std::vector<std::uint32_t>> JobTalk::filled() {
    std::array<std::uint32_t, most_answers> answers;
    std::vector<std::uint32_t> out;
    for (;;) {
        const Received came =
            receive_message(socket_.get(), std::as_writable_bytes(std::span(answers)));
        if (came.state == Received::State::Nothing)
            return out;
        if (came.state == Received::State::Closed)
            return job_gone();
        if (came.bytes > sizeof(answers) || came.bytes % sizeof(std::uint32_t) != 0)
            return no_sense("a message is cut off, or too long");
        for (const std::uint32_t slot :
             std::span(answers).first(came.bytes / sizeof(std::uint32_t))) {
            if (slot >= asked_.size() || !asked_[slot] || std::ranges::count(out, slot) > 0)
                return no_sense("it sent a brick that was not requested");
            out.push_back(slot);
        }
    }
}

JobTalk::Outcome JobTalk::take(std::uint32_t slot, std::span<float> to) {
    const auto memory = slots_.slot(slot);
    const BrickAsk asked = *std::exchange(asked_[slot], std::nullopt);
    BrickHead head; // the job may still write to the memory: check a copy
    std::memcpy(&head, memory.data(), sizeof(head));
    if (head.held == job_magic)
        std::memcpy(to.data(), memory.data() + sizeof(head), to.size_bytes());
    free_.push_back(slot);
    if (head.held != job_magic)
        return Outcome::NotHeld;
    if (head.step != asked.step || head.brick != asked.brick ||
        core::crc32c(std::as_bytes(to)) != head.checksum)
        return Outcome::Damaged;
    return Outcome::Taken;
}

} // namespace wakesurf::server
