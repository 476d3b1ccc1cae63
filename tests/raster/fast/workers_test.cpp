// The pool: every item once, in rising order, whoever is late; asleep when there is nothing to do.
#include "raster/fast/workers.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace relevo::raster::fast {
namespace {

constexpr int thread_counts[] = {1, 2, 7};

void compute_for(std::chrono::microseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end) {
    }
}

TEST(Workers, DoEveryItemExactlyOnceAndAreThenDone) {
    for (const int threads : thread_counts) {
        Workers workers(threads);
        EXPECT_EQ(workers.count(), threads);
        for (const int items : {0, 1, 2, 3, 6, 7, 8, 1000}) {
            std::vector<std::atomic<int>> times(static_cast<std::size_t>(items));
            workers.run(items, [&](int item, int) { ++times[static_cast<std::size_t>(item)]; });
            for (const auto& n : times) ASSERT_EQ(n, 1) << threads << " threads, " << items << " items";
        }
    }
}

// What the work writes needs no lock: the caller sees it afterwards, and so does the next run. Who is late
// with one work must not take an item of the next.
TEST(Workers, ManyRunsInARow) {
    for (const int threads : thread_counts) {
        Workers workers(threads, false);
        int current = 0;
        std::vector<int> sums(3);
        std::atomic<int> late = 0;
        const auto work_of = [&](int parity) -> Workers::Work {
            return [&, parity](int item, int) {
                if (parity != current) ++late;
                ++sums[static_cast<std::size_t>(item)];
            };
        };
        const Workers::Work works[2] = {work_of(0), work_of(1)};
        constexpr int runs = 30000;
        for (int run = 0; run < runs; ++run) {
            current = run % 2;
            workers.run(3, works[current]);
        }
        EXPECT_EQ(sums, std::vector<int>(3, runs)) << threads << " threads";
        EXPECT_EQ(late, 0) << threads << " threads";
    }
}

// An item is taken only when all lower ones are; those may have a taker that has not started yet.
TEST(Workers, TakeItemsInRisingOrder) {
    for (const int threads : thread_counts) {
        Workers workers(threads);
        constexpr int items = 3000;
        std::atomic<int> started = 0, too_early = 0;
        std::vector<std::vector<int>> taken(static_cast<std::size_t>(threads));
        workers.run(items, [&](int item, int worker) {
            if (started.fetch_add(1) < item - (threads - 1)) ++too_early;
            taken[static_cast<std::size_t>(worker)].push_back(item);
        });
        EXPECT_EQ(too_early, 0);
        for (const auto& list : taken) EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
    }
}

TEST(Workers, GoWithoutEverHavingWorkedOrRightAfter) {
    for (int i = 0; i < 200; ++i) Workers workers(7);
    for (int i = 0; i < 200; ++i) {
        std::atomic<int> done = 0;
        Workers(7).run(3, [&](int, int) { ++done; });
        ASSERT_EQ(done, 3);
    }
}

// ---------------------------------------------------------------------------------------- who sleeps, who is
// late The numbers in /proc/self/task of this process's threads but this one's.
std::vector<std::string> other_threads() {
    std::vector<std::string> out;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
        if (task.path().filename() != std::to_string(gettid())) out.push_back(task.path().string());
    return out;
}
std::string field_of(const std::string& thread, const std::string& name) {
    std::ifstream status(thread + "/status");
    std::string line;
    while (std::getline(status, line))
        if (line.starts_with(name + ":")) return line.substr(name.size() + 2);
    return "";
}
void wait_until_asleep(const std::vector<std::string>& threads) {
    for (const std::string& thread : threads)
        while (!field_of(thread, "State").starts_with("S"))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// Runs until all threads meet in one run. `work` may be called more often. Threads are counted, not items:
// who has waited in vain takes another item.
void meet(
    Workers& workers, const std::function<void(int worker)>& work = [](int) {}) {
    std::atomic<int> here = 0;
    while (here < workers.count()) {
        here = 0;
        std::vector<std::atomic<bool>> came(static_cast<std::size_t>(workers.count()));
        workers.run(workers.count(), [&](int, int worker) {
            work(worker);
            if (!came[static_cast<std::size_t>(worker)].exchange(true)) ++here;
            const auto patience = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
            while (here < workers.count() && std::chrono::steady_clock::now() < patience)
                std::this_thread::yield();
        });
    }
}

TEST(Workers, HaveNumbersOfTheirOwn) {
    for (const int threads : thread_counts) {
        Workers workers(threads, false);
        std::vector<std::atomic<int>> inside(static_cast<std::size_t>(threads));
        std::atomic<int> wrong = 0;
        for (int run = 0; run < 50; ++run)
            workers.run(2 * threads, [&](int, int worker) {
                if (inside.at(static_cast<std::size_t>(worker))++ != 0) ++wrong;
                compute_for(std::chrono::microseconds(200));
                --inside.at(static_cast<std::size_t>(worker));
            });
        EXPECT_EQ(wrong, 0) << threads << " threads";
    }
}

TEST(Workers, SleepWhenThereIsNothingToDo) {
    Workers workers(7, false);
    meet(workers);
    const std::clock_t before = std::clock();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_LT(std::clock() - before, CLOCKS_PER_SEC / 10);
}

TEST(Workers, NoMoreThreadsWakeThanThereAreItems) {
    Workers workers(7, false);
    meet(workers);
    const std::vector<std::string> helpers = other_threads();
    const auto naps = [&] {
        wait_until_asleep(helpers);
        int sum = 0;
        for (const std::string& helper : helpers)
            sum += std::stoi(field_of(helper, "voluntary_ctxt_switches"));
        return sum;
    };
    const int before = naps(), runs = 200;
    for (int run = 0; run < runs; ++run)
        workers.run(2, [](int, int) { compute_for(std::chrono::microseconds(200)); });
    EXPECT_LT(naps() - before, 3 * runs);  // one for each run; 6 if all woke
}

std::atomic<int> caught = 0;
int gate[2];  // a pipe: a thread that reads from it stays until something is written
void stay_until_released(int) {
    ++caught;
    char byte;
    while (read(gate[0], &byte, 1) < 0) {
    }
}

// The machine is so busy that no helper runs: a signal holds them all.
TEST(Workers, TheCallerFinishesAloneWhenNobodyElseGetsToRun) {
    alarm(60);  // else it waits for ever
    ASSERT_EQ(pipe(gate), 0);
    std::signal(SIGUSR1, stay_until_released);
    constexpr int threads = 4;
    Workers workers(threads, false);
    std::vector<pthread_t> handles(threads);
    meet(workers, [&](int worker) { handles[static_cast<std::size_t>(worker)] = pthread_self(); });
    wait_until_asleep(other_threads());
    caught = 0;
    for (int helper = 1; helper < threads; ++helper)
        pthread_kill(handles[static_cast<std::size_t>(helper)], SIGUSR1);
    while (caught < threads - 1) std::this_thread::yield();

    for (int run = 0; run < 3; ++run) {  // of which the helpers hear afterwards
        std::vector<int> by(100, -1);
        workers.run(100, [&](int item, int worker) { by[static_cast<std::size_t>(item)] = worker; });
        EXPECT_EQ(by, std::vector<int>(100, 0));
    }

    EXPECT_EQ(write(gate[1], "xxx", threads - 1), threads - 1);
    meet(workers);  // they work again
    alarm(0);
    std::signal(SIGUSR1, SIG_DFL);
    close(gate[0]), close(gate[1]);
}

// Helpers that sleep in the middle of an item, as those of a busy machine do, are asked seldom. With 2 ms an
// item and two threads the caller would wait nearly half of the time.
TEST(Workers, HelpersThatOnlyKeepTheCallerWaitingAreAskedSeldom) {
    Workers workers(2);
    int asked = 0;
    for (int run = 0; run < 100; ++run) {
        std::atomic<bool> begun = false, ended = false;
        workers.run(2, [&](int item, int worker) {
            if (worker == 0) {
                for (int i = 0; i < 100 && item == 0 && !begun; ++i)
                    compute_for(std::chrono::microseconds(50));
            } else {
                begun = true;
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                ended = true;
            }
        });
        ASSERT_EQ(ended, begun) << "run() returned before the work was done";
        asked += begun;
    }
    EXPECT_LT(asked, 40);
}
// Those that are worth it are asked again and again (on a busy machine not always).
TEST(Workers, HelpersThatPayAreAskedAgain) {
    Workers workers(2);
    int asked = 0;
    for (int run = 0; run < 100; ++run) {
        std::atomic<bool> helped = false;
        workers.run(50, [&](int, int worker) {
            if (worker == 1) helped = true;
            compute_for(std::chrono::microseconds(50));
        });
        asked += helped;
    }
    EXPECT_GT(asked, 10);
}

#ifndef NDEBUG
TEST(WorkersDeathTest, ARunInsideOfARunIsRefused) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    Workers workers(2);
    EXPECT_DEATH(workers.run(1, [&](int, int) { workers.run(1, [](int, int) {}); }), "nested");
}
#endif

}  // namespace
}  // namespace relevo::raster::fast
