// relevo compare: are two pictures the same, number by number?
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "samples/io/compare.hpp"
#include "samples/io/png.hpp"
#include "samples/relevo/commands.hpp"

namespace relevo::command {
namespace {

struct Request {
    std::string a, b, difference_file;
    bool json = false;
};

nlohmann::ordered_json to_json(const std::optional<io::PixelDifference>& pixel, int channels) {
    if (!pixel) return nullptr;
    const auto numbers = [&](const std::array<double, 4>& all) {
        return std::vector<double>(all.begin(), all.begin() + channels);
    };
    return {{"x", pixel->x},
            {"y", pixel->y},
            {"a", numbers(pixel->a)},
            {"b", numbers(pixel->b)},
            {"difference", pixel->difference}};
}

std::string as_json(const io::Comparison& c, const Request& request) {
    nlohmann::ordered_json out{{"a", request.a}, {"b", request.b}};
    out["result"] = !c.not_comparable.empty() ? "not comparable" : c.same() ? "same" : "different";
    if (!c.not_comparable.empty()) {
        out["reason"] = c.not_comparable;
    } else {
        out.update({{"width", c.width}, {"height", c.height}, {"channels", c.channels}});
        out["different_pixels"] = c.different;
        out["first"] = to_json(c.first, c.channels);
        out["worst"] = to_json(c.worst, c.channels);
    }
    // Names of files may be no UTF-8.
    return out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

int run(const Request& request) {
    const auto a = io::read_pixels(request.a);
    if (!a) return refuse(a.error());
    const auto b = io::read_pixels(request.b);
    if (!b) return refuse(b.error());
    const io::Comparison comparison = io::compare(*a, *b);
    const bool comparable = comparison.not_comparable.empty();
    const std::string text =
        request.json ? as_json(comparison, request) : io::describe(comparison, request.a, request.b);
    std::fprintf(comparable || request.json ? stdout : stderr, "%s\n", text.c_str());
    if (!comparable) return wrong_input;
    if (!request.difference_file.empty())
        if (const io::Failure failure =
                io::write_png(request.difference_file, io::difference_picture(*a, *b)))
            return refuse(*failure);
    return comparison.same() ? done : check_failed;
}

}  // namespace

void add_compare(CLI::App& app, int& status) {
    const auto request = std::make_shared<Request>();
    CLI::App* const command = app.add_subcommand("compare", "are two pictures the same, number by number?");
    command->add_option("A", request->a, "an image file")->required();
    command->add_option("B", request->b, "an image file")->required();
    command->add_option("-o,--output", request->difference_file,
                        "write A, B and their difference side by side (PNG)");
    command->add_flag("--json", request->json, "the answer as JSON");
    command->footer(
        "Exit status: 0 the same, 1 different, 2 not comparable (sizes, channels, kinds of number, no "
        "image).\n"
        "8-bit differences are shown times 8; those of 16-bit and float images so that the largest is "
        "white.\n\n"
        "Example:  relevo compare expected.png actual.png -o difference.png");
    command->callback([request, &status] { status = run(*request); });
}

}  // namespace relevo::command
