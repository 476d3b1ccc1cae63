// The goldens' files, below a folder: STAGE/CASE.toml says what the golden is for, and beside it lie its
// data: .txt (texts), .png (pictures), .exr (numbers).
#pragma once
#include <string>
#include <vector>

#include "samples/io/place.hpp"
#include "tests/golden/product.hpp"

namespace relevo::golden {

struct Golden {
    std::string about;                  // what it shows, a sentence
    std::vector<std::string> mistakes;  // those it must notice (mistakes.hpp)
    std::string reason;                 // why it was accepted last; empty: never
    std::string hash;                   // of its product
};

// NAME is STAGE/CASE. Errors: a missing or wrong file, an unknown key.
io::FileResult<Golden> read_golden(const std::string& folder, const std::string& name);
// The data, of which `like` says what there is to read.
io::FileResult<Product> read_product(const std::string& folder, const std::string& name, const Product& like);

io::Failure write_golden(const std::string& folder, const std::string& name, const Golden& golden);
// PATH.txt or PATH.png, and PATH.exr when there are numbers.
io::Failure write_product(const std::string& path, const Product& product);

}  // namespace relevo::golden
