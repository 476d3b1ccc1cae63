// A pool of threads that sleep until there is work.
//
//   next_   run | item     one number: who wakes too late for a run takes nothing of the following one
//   done_                  items of the run that are complete: run() waits for items, not for threads
//
// The calling thread works, too. If the others do not get to run, because the machine is busy, it does
// everything alone and leaves; a helper that wakes later finds another run, or none, and sleeps on.
//
// What remains is a helper that is stopped in the middle of an item, with the caller waiting. So accounts are
// kept: the helpers' processor time is won, the caller's for waking them and waiting is lost. When more is
// lost than won, the caller works alone for 16 times as long: helpers cost at most a 16th of the time,
// however bad the luck.
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace relevo::raster::fast {

class Workers {
  public:
    using Work = std::function<void(int item, int worker)>;

    // `threads` >= 1 in all; the calling thread is one of them, the others are started here: as many of them
    // as the system gives. `thrifty`: helpers that cost more than they do are left asleep for a while; tests
    // of the helpers want them always.
    explicit Workers(int threads, bool thrifty = true);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int count() const { return static_cast<int>(helpers_.size()) + 1; }
    // Calls work(item, worker) once for each item 0..items-1, worker in 0..count()-1 (no two calls with the
    // same worker at a time), and returns when all are done. Items are taken in rising order. `work` does not
    // throw, and no item waits for another: the caller may do all of them. What it writes is visible to the
    // caller afterwards. One run at a time: none inside of another.
    void run(int items, const Work& work);

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::nanoseconds credit = std::chrono::milliseconds(4);

    struct Job {
        const Work* work = nullptr;
        int items = 0;
        std::uint32_t run = 0;
    };
    void help(int worker);
    void work_off(const Job& job, int worker);
    int take(const Job& job);
    void balance(std::chrono::nanoseconds lost);

    std::mutex mutex_;
    std::condition_variable invited_, finished_;
    Job job_;              // these three: under the mutex
    int invitations_ = 0;  // helpers that the run still wants
    bool closing_ = false;

    std::atomic<std::uint64_t> next_{0};
    std::atomic<int> done_{0};
    std::atomic<bool> running_{false};
    std::atomic<bool> waiting_{false};           // the caller, for the last items
    std::atomic<std::int64_t> helped_{0};        // processor time of all helpers, ns
    std::int64_t helped_before_ = 0;             // of that: in the account
    std::chrono::nanoseconds account_ = credit;  // won less lost
    Clock::time_point alone_until_{};
    const bool thrifty_;
    std::vector<std::thread> helpers_;
};

}  // namespace relevo::raster::fast
