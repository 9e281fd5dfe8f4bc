#include "server/net/methods/kept_field_jobs.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace wakesurf::server {

namespace {

std::string line_of(const std::string& dataset) {
    return "\nkept fields " + dataset;
}

core::Error not_made() {
    return {core::Error::Code::Cancelled, "the field was not made", ""};
}

} // namespace

/// Holds what the work and this know of each other.
struct KeptFieldJobs::Shared {
    explicit Shared(DatasetCatalogue& of) : catalogue(of) {}

    DatasetCatalogue& catalogue;
    std::stop_source ending;
    std::mutex mutex; ///< guards what follows
    std::condition_variable idle;
    std::size_t running = 0;
    bool over = false;
};

/// One piece of work while it may use the catalogue.
class KeptFieldJobs::Turn {
  public:
    explicit Turn(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {
        const std::scoped_lock lock(shared_->mutex);
        begun_ = !shared_->over;
        shared_->running += begun_ ? 1 : 0;
    }

    ~Turn() {
        const std::scoped_lock lock(shared_->mutex);
        shared_->running -= begun_ ? 1 : 0;
        shared_->idle.notify_all();
    }

    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    /// False: there is no catalogue any more.
    bool begun() const { return begun_; }

  private:
    std::shared_ptr<Shared> shared_;
    bool begun_ = false;
};

KeptFieldJobs::KeptFieldJobs(Loop& loop,
                             ComputePool& pool,
                             DatasetCatalogue& catalogue,
                             const core::MemoryAccount& account)
    : loop_(loop), pool_(pool), account_(account), shared_(std::make_shared<Shared>(catalogue)) {}

KeptFieldJobs::~KeptFieldJobs() {
    shared_->ending.request_stop();
    std::unique_lock lock(shared_->mutex);
    shared_->over = true;
    shared_->idle.wait(lock, [this] { return shared_->running == 0; });
}

void KeptFieldJobs::run(const std::string& dataset,
                        Work work,
                        std::function<void(core::Result<nlohmann::json>)> answer) {
    compute<nlohmann::json>(
        loop_, pool_, line_of(dataset),
        [shared = shared_, dataset, work = std::move(work),
         account = account_]() -> core::Result<nlohmann::json> {
            const Turn turn(shared);
            std::stop_source either;
            const auto forward = [&either] { either.request_stop(); };
            const std::stop_callback first(work.unwanted, forward);
            const std::stop_callback second(shared->ending.get_token(), forward);
            const std::stop_token stop = either.get_token();
            if (!turn.begun() || stop.stop_requested())
                return tl::unexpected(not_made());
            const auto open = shared->catalogue.find(dataset);
            if (!open)
                return tl::unexpected(open.error());
            core::WorkMemory memory(account, stop, std::chrono::seconds(1), work.what);
            auto made = work.make(**open, stop, {work.done.get(), &memory});
            // Of several fields some may be kept when the next one fails.
            shared->catalogue.refresh_kept_fields(dataset);
            return made;
        },
        std::move(answer));
}

} // namespace wakesurf::server
