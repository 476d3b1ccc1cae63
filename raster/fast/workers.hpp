// A pool of threads that sleep until there is work.
#pragma once
#include <functional>

namespace relevo::raster::fast {

class Workers {
  public:
    // `threads` >= 1 in all; the calling thread is one of them, the others are started here.
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int count() const;
    // Calls work(item, worker) once for each item 0..items-1, worker in 0..count()-1 (no two calls with the
    // same worker at a time), and returns when all are done. Items are taken in rising order.
    void run(int items, const std::function<void(int item, int worker)>& work);
};

}  // namespace relevo::raster::fast
