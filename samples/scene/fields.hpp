// Checked reading of one table: every key is known, every value has the right type, range and a finite
// number.
#pragma once
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/color.hpp"
#include "samples/scene/choices.hpp"
#include "samples/scene/document.hpp"

namespace relevo::scene {

// The first thing found wrong. Reading goes on with defaults after it, so no caller has to look after each
// key.
struct Diagnosis {
    std::optional<io::FileError> error;
    void say(const io::Place& place, std::string message) {
        if (!error) error = io::FileError{place, std::move(message)};
    }
    bool fine() const { return !error; }
};

// Numbers from low to high; `accepted` says so in words.
struct Range {
    double low, high;
    bool without_low = false, without_high = false;
    std::string_view accepted;
    bool holds(double x) const {
        return (without_low ? x > low : x >= low) && (without_high ? x < high : x <= high);
    }
};

// float32 ends at 3.4e38: what is larger would turn infinite on its way into the machine.
inline constexpr double largest_number = std::numeric_limits<float>::max();
inline constexpr Range any_number{-largest_number, largest_number, false, false, "a finite number (float32)"};
inline constexpr Range zero_or_more{0, largest_number, false, false, "0 or more (finite)"};
inline constexpr Range zero_to_one{0, 1, false, false, "0 to 1"};
inline constexpr Range positive{0, largest_number, true, false, "more than 0 (finite)"};

class Fields {
  public:
    // `name` is how messages call the table ("camera"). A key that is not in `known` is said to be unknown at
    // once.
    Fields(const Value& table, std::string name, std::span<const std::string_view> known,
           Diagnosis& diagnosis);

    bool has(std::string_view key) const { return find(key) != nullptr; }
    const Value* find(std::string_view key) const;
    io::Place place(std::string_view key) const;  // of the value, or of the table when the key is missing
    std::string full(std::string_view key) const { return name_ + '.' + std::string(key); }

    double number(std::string_view key, double fallback, const Range& range = any_number) const;
    int whole(std::string_view key, int fallback, int low, int high) const;
    std::string text(std::string_view key, const std::string& fallback) const;
    bool flag(std::string_view key, bool fallback) const;
    glm::dvec3 triple(std::string_view key, glm::dvec3 fallback, const Range& range = any_number) const;
    // A list of as many numbers as there are ranges, which is called `key` in messages; zeros when it is not.
    std::vector<double> numbers(const Value& list, std::string_view key, std::span<const Range> ranges) const;
    pipeline::LinearRgb color(std::string_view key, pipeline::LinearRgb fallback, const Range& range) const;

    template <class Meaning, std::size_t count>
    Meaning choice(std::string_view key, Meaning fallback, const Choice<Meaning> (&choices)[count]) const {
        std::vector<std::string_view> names;
        for (const auto& choice : choices) names.push_back(choice.name);
        const std::optional<std::size_t> which = word(key, names);
        return which ? choices[*which].meaning : fallback;
    }

    // "camera.fov_y is 190, accepted: ..." at the value, or at the table when the key is missing.
    void refuse(std::string_view key, std::string_view accepted) const;
    void refuse(const Value& value, std::string_view key, std::string_view accepted) const;
    Diagnosis& diagnosis() const { return *diagnosis_; }

  private:
    std::optional<std::size_t> word(std::string_view key, std::span<const std::string_view> names) const;
    std::optional<double> as_number(const Value& value, std::string_view key, const Range& range) const;

    io::Place place_;
    std::string name_;
    const Table* table_;
    Diagnosis* diagnosis_;
};

// "a, b, c"
std::string joined(std::span<const std::string_view> words);

}  // namespace relevo::scene
