// The corners of a mesh, shared: corners with the same position, normal and texture index are one vertex.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace relevo::io {

// Indices into the lists of a file; -1 where the corner has none.
struct Corner {
    std::int32_t position = 0, normal = -1, uv = -1;
    friend bool operator==(const Corner&, const Corner&) = default;
};

// Numbers different corners 0, 1, 2... in the order in which they come. A hash table with open addressing
// finds the number again; it is never walked through, so its order shows nowhere.
class Corners {
  public:
    std::uint32_t number(const Corner& corner) {
        if (corners_.size() * 2 >= slots_.size()) grow();
        std::uint32_t& slot = slots_[find(corner)];
        if (slot == none) {
            slot = static_cast<std::uint32_t>(corners_.size());
            corners_.push_back(corner);
        }
        return slot;
    }
    // By number.
    const std::vector<Corner>& list() const { return corners_; }

  private:
    static constexpr std::uint32_t none = 0xffffffff;

    // Any odd multipliers do that carry low bits upwards; the top bits of the product are the well-mixed
    // ones.
    std::size_t find(const Corner& corner) const {
        const auto bits = [](std::int32_t i) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i));
        };
        std::uint64_t hash = (bits(corner.position) << 32 | bits(corner.uv)) * 0x9e3779b97f4a7c15u;
        hash = ((hash >> 29) ^ hash ^ bits(corner.normal)) * 0xd1342543de82ef95u;
        std::size_t at = static_cast<std::size_t>(hash >> 32) & (slots_.size() - 1);
        while (slots_[at] != none && corners_[slots_[at]] != corner) at = (at + 1) & (slots_.size() - 1);
        return at;
    }
    void grow() {
        slots_.assign(slots_.empty() ? 16 : slots_.size() * 2, none);
        for (std::uint32_t i = 0; i < corners_.size(); ++i) slots_[find(corners_[i])] = i;
    }

    std::vector<Corner> corners_;
    std::vector<std::uint32_t> slots_;  // a power of two, at most half full
};

}  // namespace relevo::io
