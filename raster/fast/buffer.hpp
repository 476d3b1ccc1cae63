// Memory that grows, is never cleared and starts on a cache line.
//
// Much of it comes in huge pages where the system has any: the numbers of a mesh's vertices are asked for in
// any order, and of small pages only few are found fast. This is all that the core asks of a system; without
// <sys/mman.h> it does without.
#pragma once
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <utility>

namespace relevo::raster::fast {

template <class T>
class Buffer {
  public:
    T* room_for(std::size_t count) {
        if (count > capacity_) {
            const std::size_t page = count * sizeof(T) < least_huge ? 64 : huge_page;
            const std::size_t bytes = (before + count * sizeof(T) + page - 1) / page * page;
            memory_.reset(static_cast<std::byte*>(std::aligned_alloc(page, bytes)));
            if (memory_ == nullptr) std::abort();
#ifdef MADV_HUGEPAGE
            if (page == huge_page) madvise(memory_.get(), bytes, MADV_HUGEPAGE);
#endif
            capacity_ = count, bytes_ = bytes;
        }
        return first();
    }
    // The same, and what is there stays.
    T* grow(std::size_t count) {
        if (count <= capacity_) return first();
        Buffer larger;
        larger.room_for(count);
        if (capacity_ > 0) std::copy_n(first(), capacity_, larger.first());
        std::swap(*this, larger);
        return first();
    }
    std::size_t capacity() const { return capacity_; }
    std::size_t bytes() const { return bytes_; }  // held

  private:
    static constexpr std::size_t huge_page = std::size_t{2} << 20, least_huge = 2 * huge_page;
    // Not all buffers begin at the same place of a page: what belongs to one vertex would stand in the same
    // few lines of the caches.
    static constexpr std::size_t before = 64 * sizeof(T);

    T* first() const { return memory_ == nullptr ? nullptr : reinterpret_cast<T*>(memory_.get() + before); }

    struct Free {
        void operator()(std::byte* p) const { std::free(p); }
    };
    std::unique_ptr<std::byte, Free> memory_;
    std::size_t capacity_ = 0, bytes_ = 0;
};

}  // namespace relevo::raster::fast
