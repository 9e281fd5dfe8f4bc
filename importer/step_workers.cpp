#include "importer/step_workers.hpp"

#include "core/base/result.hpp"
#include "importer/base/library_messages.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/step_conversion.hpp"
#include "store/file_writing.hpp"
#include "store/store_writer.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

using core::Error;

namespace {

// A worker process reports each time-step to the one that started it, as bytes in a pipe.

struct StepMessage {
    std::size_t index = 0;
    core::Result<StepRecord> outcome = StepRecord();
};

struct Head {
    std::uint64_t index = 0;
    std::uint64_t failed = 0;
    std::uint64_t code = 0;
    std::uint64_t numbers = 0; ///< that follow, then the texts
    std::uint64_t message = 0; ///< characters
    std::uint64_t hint = 0;
};

template <class T>
auto bytes_of(T& value) {
    if constexpr (std::is_const_v<T>)
        return std::as_bytes(std::span(&value, 1));
    else
        return std::as_writable_bytes(std::span(&value, 1));
}

// Checksums have 32 bits: exact as doubles.
std::vector<double> numbers_of(const StepRecord& record) {
    std::vector<double> out{record.speed.lo, record.speed.hi};
    for (const Range& range : record.scalars)
        out.insert(out.end(), {range.lo, range.hi});
    out.insert(out.end(), record.checksums.begin(), record.checksums.end());
    out.push_back(record.tears ? 1.0 : 0.0);
    return out;
}

StepRecord record_of(const std::vector<double>& numbers) {
    StepRecord record;
    const std::size_t columns = numbers.size() / 3;
    record.speed = {numbers.at(0), numbers.at(1)};
    for (std::size_t i = 1; i < columns; ++i)
        record.scalars.push_back({numbers.at(2 * i), numbers.at(2 * i + 1)});
    for (std::size_t i = 2 * columns; i + 1 < numbers.size(); ++i)
        record.checksums.push_back(static_cast<std::uint32_t>(numbers[i]));
    record.tears = numbers.back() != 0.0;
    return record;
}

// Returns false if the other end is closed.
bool send(int pipe, const StepMessage& message) {
    Head head{message.index};
    std::vector<double> numbers;
    std::string texts;
    if (message.outcome) {
        numbers = numbers_of(*message.outcome);
        head.numbers = numbers.size();
    } else {
        const core::Error& error = message.outcome.error();
        texts = error.message + error.hint;
        head.failed = 1;
        head.code = static_cast<std::uint64_t>(error.code);
        head.message = error.message.size();
        head.hint = error.hint.size();
    }
    return store::write_whole(pipe, bytes_of(std::as_const(head))) &&
           store::write_whole(pipe, std::as_bytes(std::span<const double>(numbers))) &&
           store::write_whole(pipe, std::as_bytes(std::span<const char>(texts)));
}

// Returns empty at the end of the pipe, also within a message.
std::optional<StepMessage> receive(int pipe) {
    Head head;
    if (!store::read_whole(pipe, bytes_of(head)))
        return std::nullopt;
    std::vector<double> numbers(head.numbers);
    std::string message(head.message, '\0');
    std::string hint(head.hint, '\0');
    if (!store::read_whole(pipe, std::as_writable_bytes(std::span(numbers))) ||
        !store::read_whole(pipe, std::as_writable_bytes(std::span(message))) ||
        !store::read_whole(pipe, std::as_writable_bytes(std::span(hint))))
        return std::nullopt;
    StepMessage out{static_cast<std::size_t>(head.index), StepRecord()};
    if (head.failed != 0)
        out.outcome =
            tl::unexpected(core::Error{static_cast<core::Error::Code>(head.code), message, hint});
    else
        out.outcome = record_of(numbers);
    return out;
}

constexpr std::size_t most_workers = 256;

// The process ids that a signal handler may read; 0 for a free entry.
std::array<std::atomic<pid_t>, most_workers> running{};

struct Worker {
    pid_t process = 0;
    int tasks = -1;   ///< to it: numbers of time-steps
    int results = -1; ///< from it
    std::optional<std::size_t> step;
};

[[noreturn]] void work_off(int tasks, int results, const StepWork& work) {
    core::Result<void> begun = work.begin ? work.begin() : core::Result<void>();
    std::uint64_t index = 0;
    while (store::read_whole(tasks, std::as_writable_bytes(std::span(&index, 1)))) {
        StepMessage message{static_cast<std::size_t>(index), StepRecord()};
        try {
            if (begun)
                message.outcome = work.convert(message.index);
            else
                message.outcome = tl::unexpected(begun.error());
        } catch (const std::exception& error) {
            message.outcome = tl::unexpected(error_of(error, work.name(message.index)));
        }
        if (!send(results, message))
            break;
    }
    ::_exit(0);
}

Error how_it_ended(int status, const std::string& step) {
    if (progress_marks().out_of_memory)
        return {Error::Code::OverLimit, "there is not enough memory to convert " + step, {}};
    const std::string how =
        WIFSIGNALED(status) ? " (signal " + std::to_string(WTERMSIG(status)) + ")" : "";
    return {Error::Code::Corrupt, "the library that reads " + step + " crashed" + how,
            "the file is damaged, or holds something that the library cannot handle"};
}

class Workers {
  public:
    Workers(std::span<const std::size_t> todo, const StepWork& work) : todo_(todo), work_(work) {}

    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    ~Workers() {
        for (auto& worker : workers_) {
            ::close(worker.tasks);
            ::close(worker.results);
        }
        end_step_workers(); // an idle one ends with its pipe; one in the middle of a step is not needed
    }

    core::Result<void> start(std::size_t jobs) {
        for (std::size_t i = 0; i < std::min(jobs, most_workers); ++i)
            if (auto started = start_one(i); !started)
                return i == 0 ? started : core::Result<void>();
        return {};
    }

    core::Result<void> run() {
        for (auto& worker : workers_)
            give(worker);
        if (work_.meanwhile)
            if (auto done = work_.meanwhile(); !done)
                return done;
        while (committed_ < todo_.size()) {
            if (auto waited = wait(); !waited)
                return waited;
            if (auto done = commit(); !done)
                return done;
        }
        return {};
    }

  private:
    core::Result<void> start_one(std::size_t number) {
        int tasks[2];
        int results[2];
        const auto failed = core::fail(Error::Code::Io, "cannot start a process");
        if (::pipe2(tasks, O_CLOEXEC) != 0)
            return failed;
        if (::pipe2(results, O_CLOEXEC) != 0) {
            ::close(tasks[0]);
            ::close(tasks[1]);
            return failed;
        }
        const pid_t parent = ::getpid();
        const pid_t process = ::fork();
        if (process == 0) {
            for (auto& entry : running)
                entry = 0; // not ours to end
            store::end_on_signals({});
            ::prctl(PR_SET_PDEATHSIG, SIGKILL);
            if (::getppid() != parent)
                ::_exit(1);
            for (const auto& other : workers_) { // else their pipes would never end
                ::close(other.tasks);
                ::close(other.results);
            }
            ::close(tasks[1]);
            ::close(results[0]);
            work_off(tasks[0], results[1], work_);
        }
        ::close(tasks[0]);
        ::close(results[1]);
        if (process < 0) {
            ::close(tasks[1]);
            ::close(results[0]);
            return failed;
        }
        running[number] = process;
        workers_.push_back({process, tasks[1], results[0], std::nullopt});
        return {};
    }

    void give(Worker& worker) {
        // Results behind a failed time-step are ignored.
        const bool failed = std::any_of(outcomes_.begin(), outcomes_.end(),
                                        [](const auto& entry) { return !entry.second; });
        if (failed || given_ == todo_.size())
            return;
        const std::uint64_t index = todo_[given_++];
        worker.step = index;
        store::write_whole(
            worker.tasks,
            std::as_bytes(std::span(&index, 1))); // a worker that has ended shows in its results
    }

    core::Result<void> wait() {
        std::vector<pollfd> polled;
        std::vector<Worker*> busy;
        for (auto& worker : workers_)
            if (worker.step) {
                polled.push_back({worker.results, POLLIN, 0});
                busy.push_back(&worker);
            }
        while (::poll(polled.data(), polled.size(), -1) < 0)
            if (errno != EINTR)
                return core::fail(Error::Code::Io, "cannot wait for the converting processes");
        for (std::size_t i = 0; i < polled.size(); ++i)
            if (polled[i].revents != 0)
                take(*busy[i]);
        return {};
    }

    void take(Worker& worker) {
        const std::size_t index = *worker.step;
        worker.step.reset();
        if (auto message = receive(worker.results)) {
            outcomes_.emplace(index, std::move(message->outcome));
            give(worker);
            return;
        }
        int status = 0;
        ::waitpid(worker.process, &status, 0);
        for (auto& entry : running)
            if (entry == worker.process)
                entry = 0;
        outcomes_.emplace(index, tl::unexpected(how_it_ended(status, work_.name(index))));
    }

    core::Result<void> commit() {
        while (committed_ < todo_.size()) {
            const auto outcome = outcomes_.find(todo_[committed_]);
            if (outcome == outcomes_.end())
                return {};
            if (!outcome->second)
                return tl::unexpected(outcome->second.error());
            if (auto done = work_.commit(outcome->first, *outcome->second); !done)
                return done;
            outcomes_.erase(outcome);
            ++committed_;
        }
        return {};
    }

    std::span<const std::size_t> todo_;
    const StepWork& work_;
    std::vector<Worker> workers_;
    std::map<std::size_t, core::Result<StepRecord>> outcomes_; ///< not committed yet
    std::size_t given_ = 0;
    std::size_t committed_ = 0;
};

} // namespace

core::Result<void>
convert_steps(std::span<const std::size_t> todo, std::size_t jobs, const StepWork& work) {
    Workers workers(todo, work);
    if (!todo.empty())
        if (auto started = workers.start(std::clamp<std::size_t>(jobs, 1, todo.size())); !started)
            return started;
    return workers.run();
}

void end_step_workers() {
    for (const auto& process : running)
        if (process.load() > 0)
            ::kill(process.load(), SIGTERM);
    for (auto& process : running)
        if (process.load() > 0) {
            while (::waitpid(process.load(), nullptr, 0) < 0 && errno == EINTR) {
            }
            process = 0;
        }
}

} // namespace wakesurf::importer
