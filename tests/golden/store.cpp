#include "tests/golden/store.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "samples/io/file.hpp"
#include "samples/io/picture.hpp"
#include "samples/io/png.hpp"

namespace relevo::golden {
namespace {

io::FileError error_at(const std::string& path, const toml::source_region& place, std::string message) {
    return {{path, int(place.begin.line), int(place.begin.column)}, std::move(message)};
}

std::string quoted(const std::string& words) {
    std::ostringstream out;
    out << toml::value<std::string>(words);
    return out.str();
}

io::FileResult<Golden> golden_of(const std::string& path, const toml::table& table) {
    Golden out;
    for (const auto& [key, value] : table) {
        const std::string name(key.str());
        std::string* const words = name == "about"    ? &out.about
                                   : name == "reason" ? &out.reason
                                   : name == "hash"   ? &out.hash
                                                      : nullptr;
        if (words && value.is_string()) {
            *words = value.ref<std::string>();
        } else if (name == "mistakes" && value.is_array()) {
            for (const auto& item : *value.as_array())
                out.mistakes.push_back(item.value_or(std::string("(no text)")));
        } else {
            return error_at(path, value.source(),
                            "'" + name + "': only about, mistakes (a list), reason and hash stand here");
        }
    }
    return out;
}

}  // namespace

io::FileResult<Golden> read_golden(const std::string& folder, const std::string& name) {
    const std::string path = folder + "/" + name + ".toml";
    const auto text = io::read_text(path);
    if (!text) return text.error();
    try {
        return golden_of(path, toml::parse(*text, path));
    } catch (const toml::parse_error& wrong) {
        return error_at(path, wrong.source(), std::string(wrong.description()));
    }
}

io::FileResult<Product> read_product(const std::string& folder, const std::string& name,
                                     const Product& like) {
    const std::string path = folder + "/" + name;
    Product out;
    if (!like.text.empty()) {
        const auto text = io::read_text(path + ".txt");
        if (!text) return text.error();
        out.text = *text;
    }
    if (!like.picture.empty()) {
        auto picture = io::read_image(path + ".png");
        if (!picture) return picture.error();
        out.picture = std::move(*picture);
    }
    if (!like.numbers.empty()) {
        auto numbers = io::read_exr(path + ".exr");
        if (!numbers) return numbers.error();
        out.numbers = std::move(*numbers);
    }
    return out;
}

io::Failure write_golden(const std::string& folder, const std::string& name, const Golden& golden) {
    std::string text = "about = " + quoted(golden.about) + "\nmistakes = [\n";
    for (const std::string& mistake : golden.mistakes) text += "    " + quoted(mistake) + ",\n";
    text += "]\n\n# Written by scripts/accept:\nreason = " + quoted(golden.reason) +
            "\nhash = " + quoted(golden.hash) + "\n";
    return io::write_file(folder + "/" + name + ".toml", text);
}

io::Failure write_product(const std::string& path, const Product& product) {
    io::Failure failure;
    if (!product.text.empty()) failure = io::write_file(path + ".txt", product.text);
    if (!product.picture.empty() && !failure) failure = io::write_png(path + ".png", product.picture);
    if (product.numbers.empty() || failure) return failure;
    raster::Image<pipeline::Scalar> numbers(product.numbers.width(), product.numbers.height());
    std::copy(product.numbers.pixels().begin(), product.numbers.pixels().end(), numbers.pixels().begin());
    return io::write_exr(path + ".exr", numbers);
}

}  // namespace relevo::golden
