#include "tests/golden/exhibit.hpp"

#include <algorithm>

#include "tests/golden/mistakes.hpp"
#include "tests/golden/relief/points.hpp"

namespace relevo::golden {
namespace {

Exhibit of_machine(const Case& which) {
    Exhibit e;
    e.name = which.name;
    e.product = [&which] { return product_of(which.stage, which.make()); };
    e.mistaken = [&which](std::string_view name) -> std::optional<Product> {
        const Mistake* const mistake = find_mistake(name);
        if (!mistake) return {};
        return golden::mistaken(which, *mistake);
    };
    e.plain = [&which]() -> std::optional<Product> {
        const Subject subject =
            which.make();  // a shaded one has no plain form: its mistakes are in the scene
        if (!has_plain_form(which.stage, subject)) return {};
        return plain_product_of(which.stage, subject, {});
    };
    e.noticed = first_difference;
#ifdef RELEVO_DOUBLE  // the goldens are of float: here they must agree but for rounding
    e.difference = large_difference;
#else
    e.difference = first_difference;
#endif
    return e;
}

}  // namespace

const std::vector<Exhibit>& all_exhibits() {
    static const std::vector<Exhibit> all = [] {
        std::vector<Exhibit> made;
        for (const Case& c : all_cases()) made.push_back(of_machine(c));
        for (Exhibit& e : relief_exhibits()) made.push_back(std::move(e));
        return made;
    }();
    return all;
}

const Exhibit* find_exhibit(std::string_view name) {
    const auto& all = all_exhibits();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Exhibit& e) { return e.name == name; });
    return found == all.end() ? nullptr : &*found;
}

std::vector<MistakeName> all_mistake_names() {
    std::vector<MistakeName> names;
    for (const Mistake& m : all_mistakes()) names.push_back({m.name, m.sentence});
    for (const MistakeName& m : relief_mistake_names()) names.push_back(m);
    return names;
}

}  // namespace relevo::golden
