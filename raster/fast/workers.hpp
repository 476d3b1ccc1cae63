// A pool of threads that sleep until there is work.
//
//   next_   run | item     one number, so that who wakes too late for a run takes nothing of the following
//   one done_   items of the run that are complete: run() waits for items, never for a thread without one
//
// The calling thread works, too. If the others do not get to run, because the machine is busy, it does
// everything alone and leaves; a helper that wakes later finds another run, or none, and sleeps on.
#pragma once
#include <atomic>
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
    // as the system gives.
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int count() const { return static_cast<int>(helpers_.size()) + 1; }
    // Calls work(item, worker) once for each item 0..items-1, worker in 0..count()-1 (no two calls with the
    // same worker at a time), and returns when all are done. Items are taken in rising order. `work` does not
    // throw; what it writes is visible to the caller afterwards. One run at a time: none inside of another.
    void run(int items, const Work& work);

  private:
    struct Job {
        const Work* work = nullptr;
        int items = 0;
        std::uint32_t run = 0;
    };
    void help(int worker);
    void work_off(const Job& job, int worker);
    int take(const Job& job);

    std::mutex mutex_;
    std::condition_variable invited_, finished_;
    Job job_;              // these three: under the mutex
    int invitations_ = 0;  // helpers that the run still wants
    bool closing_ = false;

    std::atomic<std::uint64_t> next_{0};
    std::atomic<int> done_{0};
    std::atomic<bool> running_{false};
    std::vector<std::thread> helpers_;
};

}  // namespace relevo::raster::fast
