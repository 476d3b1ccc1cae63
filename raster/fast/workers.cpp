#include "raster/fast/workers.hpp"

#include <algorithm>
#include <cassert>
#include <ctime>
#include <system_error>

namespace relevo::raster::fast {
namespace {

std::int64_t processor_time() {  // of this thread, ns
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return std::int64_t{t.tv_sec} * 1'000'000'000 + t.tv_nsec;
}

}  // namespace

Workers::Workers(int threads, bool thrifty) : thrifty_(thrifty) {
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
    if (helpers <= 0 || Clock::now() < alone_until_) {
        for (int item = 0; item < items; ++item) work(item, 0);
    } else {
        const Clock::time_point start = Clock::now();
        Job job;
        {
            const std::lock_guard lock(mutex_);
            job = job_ = {&work, items, job_.run + 1};
            done_ = 0;
            next_ = std::uint64_t(job.run) << 32;
            invitations_ = helpers;
        }
        for (int i = 0; i < helpers; ++i) invited_.notify_one();
        const Clock::time_point work_start = Clock::now();
        work_off(job, 0);
        const Clock::time_point work_end = Clock::now();
        waiting_ = true;
        {
            std::unique_lock lock(mutex_);
            invitations_ = 0;
            finished_.wait(lock, [&] { return done_ == items; });
        }
        waiting_ = false;
        balance(work_start - start + (Clock::now() - work_end));
    }
    running_ = false;
}

void Workers::balance(std::chrono::nanoseconds lost) {
    const std::int64_t helped = helped_;
    account_ += std::chrono::nanoseconds(helped - helped_before_) - lost;
    helped_before_ = helped;
    account_ = std::min(account_, credit);  // what was won long ago does not count
    if (account_.count() >= 0 || !thrifty_) return;
    alone_until_ = Clock::now() + std::min<std::chrono::nanoseconds>(-16 * account_, std::chrono::seconds(1));
    account_ = {};
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
    std::int64_t start = worker == 0 ? 0 : processor_time();
    const auto book = [&] {
        const std::int64_t now = processor_time();
        helped_ += now - start;
        start = now;
    };
    for (int item = take(job); item < job.items; item = take(job)) {
        (*job.work)(item, worker);
        if (waiting_ && worker != 0) book();
        if (done_.fetch_add(1) + 1 < job.items || worker == 0) continue;
        { const std::lock_guard lock(mutex_); }  // the caller has not looked yet, or it is asleep
        finished_.notify_one();
    }
    if (worker != 0) book();
}

// The next item of this run; job.items when none is left.
int Workers::take(const Job& job) {
    std::uint64_t next = next_.load();
    while (next >> 32 == job.run && static_cast<int>(next & 0xffffffffu) < job.items)
        if (next_.compare_exchange_weak(next, next + 1)) return static_cast<int>(next & 0xffffffffu);
    return job.items;
}

}  // namespace relevo::raster::fast
