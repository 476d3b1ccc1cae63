#include "raster/fast/workers.hpp"

#include <algorithm>
#include <cassert>
#include <system_error>

namespace relevo::raster::fast {

Workers::Workers(int threads) {
    assert(threads >= 1);
    helpers_.reserve(static_cast<std::size_t>(threads) - 1);
    try {
        for (int worker = 1; worker < threads; ++worker) helpers_.emplace_back([=, this] { help(worker); });
    } catch (const std::system_error&) {  // the system gives no more threads
    }
}

Workers::~Workers() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    invited_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
}

void Workers::run(int items, const Work& work) {
    [[maybe_unused]] const bool nested = running_.exchange(true);
    assert(!nested);
    const int helpers = std::min(count(), items) - 1;
    if (helpers <= 0) {
        for (int item = 0; item < items; ++item) work(item, 0);
    } else {
        Job job;
        {
            const std::lock_guard lock(mutex_);
            job = job_ = {&work, items, job_.run + 1};
            done_ = 0;
            next_ = std::uint64_t(job.run) << 32;
            invitations_ = helpers;
        }
        for (int i = 0; i < helpers; ++i) invited_.notify_one();
        work_off(job, 0);
        std::unique_lock lock(mutex_);
        invitations_ = 0;
        finished_.wait(lock, [&] { return done_ == items; });
    }
    running_ = false;
}

void Workers::help(int worker) {
    for (;;) {
        Job job;
        {
            std::unique_lock lock(mutex_);
            invited_.wait(lock, [&] { return closing_ || invitations_ > 0; });
            if (closing_) return;
            --invitations_;
            job = job_;
        }
        work_off(job, worker);
    }
}

// From the moment that the last item is counted `job.work` may be gone, and another run may have begun.
void Workers::work_off(const Job& job, int worker) {
    for (int item = take(job); item < job.items; item = take(job)) {
        (*job.work)(item, worker);
        if (done_.fetch_add(1) + 1 < job.items || worker == 0) continue;
        { const std::lock_guard lock(mutex_); }  // the caller has not looked yet, or it is asleep
        finished_.notify_one();
    }
}

// The next item of this run; job.items when none is left.
int Workers::take(const Job& job) {
    std::uint64_t next = next_.load();
    while (next >> 32 == job.run && static_cast<int>(next & 0xffffffffu) < job.items)
        if (next_.compare_exchange_weak(next, next + 1)) return static_cast<int>(next & 0xffffffffu);
    return job.items;
}

}  // namespace relevo::raster::fast
