// JSON files of known fields, read with the place of everything that is wrong.
//
// nlohmann's parser says where a text stops being JSON, but keeps no places of the values: a small walk over
// the text, which by then is known to be JSON, finds them again (ECMA-404, "The JSON data interchange
// syntax").
#pragma once
#include <glm/vec3.hpp>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "samples/io/place.hpp"

namespace relevo::io {

// The way to a value: names of fields, and numbers of array elements.
using JsonPath = std::vector<std::string>;

// Reads fields one after the other; the first thing that is wrong is kept, and everything after it comes out
// as zero or empty. So ask `failure` at the end, or before a value is used for more than being read.
class JsonFields {
  public:
    // A file of at most 1 MiB, nested at most 16 deep.
    explicit JsonFields(const std::string& path);
    ~JsonFields();
    JsonFields(const JsonFields&) = delete;
    JsonFields& operator=(const JsonFields&) = delete;

    const Failure& failure() const { return failure_; }
    bool has(const JsonPath& path) const;
    double number(const JsonPath& path);  // finite
    int integer(const JsonPath& path);
    glm::dvec3 vector(const JsonPath& path);  // an array of three finite numbers
    std::string text(const JsonPath& path);   // not empty
    // The number in `accepted` of the word that stands there.
    std::size_t choice(const JsonPath& path, std::initializer_list<std::string_view> accepted);
    // The object's fields are among these, whether they are there or not.
    void no_others(const JsonPath& path, std::initializer_list<std::string_view> accepted);
    // Something about the value that only the caller can know.
    void refuse(const JsonPath& path, const std::string& message);

  private:
    const nlohmann::json* find(const JsonPath& path, std::string_view needed);

    std::string file_, text_;
    nlohmann::json* root_;
    Failure failure_;
};

}  // namespace relevo::io
