// A TOML document as plain values that know their place in the file.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "samples/io/place.hpp"

namespace relevo::scene {

struct Entry;
using Table = std::vector<Entry>;  // in the order of the names, which is toml++'s

struct Value {
    struct Other {};  // dates and times: no key of a scene takes them
    io::Place place;
    std::variant<double, std::int64_t, bool, std::string, std::vector<Value>, Table, Other> data;
};

struct Entry {
    std::string key;
    io::Place place;  // of the key
    Value value;
};

// Text to values; `path` names the file in places and messages.
io::FileResult<Value> parse_document(std::string_view text, const std::string& path);

// The value as a message shows it: "wide", 190, true, a list, a table.
std::string describe(const Value& value);

// A number as a message shows it: the shortest decimals that read back as the same double.
std::string describe(double number);

}  // namespace relevo::scene
