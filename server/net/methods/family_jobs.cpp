#include "server/net/methods/family_jobs.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace wakesurf::server {

namespace {

std::string family_line(const std::string& dataset) {
    return "\nfamily " + dataset;
}

core::Error not_made() {
    return {core::Error::Code::Cancelled, "the family was not made", ""};
}

} // namespace

/// Holds what the work and this know of each other.
struct FamilyJobs::Shared {
    explicit Shared(DatasetCatalogue& of) : catalogue(of) {}

    DatasetCatalogue& catalogue;
    std::stop_source ending;
    std::mutex mutex; ///< guards what follows
    std::condition_variable idle;
    std::size_t running = 0;
    bool over = false;
};

/// One piece of work while it may use the catalogue.
class FamilyJobs::Work {
  public:
    explicit Work(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {
        const std::scoped_lock lock(shared_->mutex);
        begun_ = !shared_->over;
        shared_->running += begun_ ? 1 : 0;
    }

    ~Work() {
        const std::scoped_lock lock(shared_->mutex);
        shared_->running -= begun_ ? 1 : 0;
        shared_->idle.notify_all();
    }

    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    /// False: there is no catalogue any more.
    bool begun() const { return begun_; }

  private:
    std::shared_ptr<Shared> shared_;
    bool begun_ = false;
};

FamilyJobs::FamilyJobs(Loop& loop,
                       ComputePool& pool,
                       DatasetCatalogue& catalogue,
                       const core::MemoryAccount& account)
    : loop_(loop), pool_(pool), account_(account), shared_(std::make_shared<Shared>(catalogue)) {}

FamilyJobs::~FamilyJobs() {
    shared_->ending.request_stop();
    std::unique_lock lock(shared_->mutex);
    shared_->over = true;
    shared_->idle.wait(lock, [this] { return shared_->running == 0; });
}

void FamilyJobs::make(const std::string& dataset,
                      FamilyWish wish,
                      const std::stop_token& unwanted,
                      std::shared_ptr<core::WorkDone> done,
                      std::function<void(core::Result<core::FamilyRecord>)> answer) {
    compute<core::FamilyRecord>(
        loop_, pool_, family_line(dataset),
        [shared = shared_, dataset, wish = std::move(wish), done = std::move(done), unwanted,
         account = account_]() -> core::Result<core::FamilyRecord> {
            const Work work(shared);
            std::stop_source either;
            const auto forward = [&either] { either.request_stop(); };
            const std::stop_callback first(unwanted, forward);
            const std::stop_callback second(shared->ending.get_token(), forward);
            const std::stop_token stop = either.get_token();
            if (!work.begun() || stop.stop_requested())
                return tl::unexpected(not_made());
            const auto open = shared->catalogue.find(dataset);
            if (!open)
                return tl::unexpected(open.error());
            core::WorkMemory memory(account, stop, std::chrono::seconds(1), "this family");
            auto made = make_family(**open, wish, stop, {done.get(), &memory});
            if (made)
                shared->catalogue.refresh_families(dataset);
            return made;
        },
        std::move(answer));
}

void FamilyJobs::remove(const std::string& dataset,
                        const std::string& name,
                        std::function<void(core::Result<std::string>)> answer) {
    compute<std::string>(
        loop_, pool_, family_line(dataset),
        [shared = shared_, dataset, name]() -> core::Result<std::string> {
            const Work work(shared);
            if (!work.begun())
                return tl::unexpected(not_made());
            return shared->catalogue.find(dataset)
                .and_then([&](const auto& open) { return remove_family(*open, name); })
                .map([&] {
                    shared->catalogue.refresh_families(dataset);
                    return name;
                });
        },
        std::move(answer));
}

} // namespace wakesurf::server
