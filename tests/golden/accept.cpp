// Makes what the machine draws today the golden of the named cases. (scripts/accept builds and runs it.)
//   golden_accept FOLDER NAME... --reason TEXT
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/golden/exhibit.hpp"
#include "tests/golden/store.hpp"

namespace {

using namespace relevo;
using namespace relevo::golden;

struct Order {
    std::string folder, reason;
    std::vector<std::string> names;
};

// What is wrong with the order, or nothing.
std::string read_order(int count, char** words, Order& order) {
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--reason") {
            if (++i == count) return "--reason needs a text";
            order.reason = words[i];
        } else if (word.starts_with('-')) {
            return "'" + word + "' is no option; there is one: --reason TEXT";
        } else {
            (order.folder.empty() ? order.folder : order.names.emplace_back()) = word;
        }
    }
    if (std::getenv("CI"))
        return "CI does not accept goldens: look at the pictures yourself, then accept them";
    if (order.names.empty()) return "which one? scripts/accept NAME --reason TEXT";
    if (order.reason.find_first_not_of(" \t\n") == std::string::npos)
        return "why? scripts/accept NAME --reason TEXT";
    return "";
}

// The mistakes that would pass the new golden, one after the other.
std::string unnoticed(const Exhibit& which, const Golden& golden, const Product& product) {
    std::string out;
    for (const std::string& name : golden.mistakes) {
        const auto wrong = which.mistaken(name);
        if (!wrong || !which.noticed(product, *wrong)) out += " '" + name + "'";
    }
    return out;
}

struct Accepted {
    std::string name, difference;
    Golden golden;
    Product product;
};

std::string examine(const Order& order, const std::string& name, Accepted& accepted) {
    const Exhibit* which = find_exhibit(name);
    if (!which)
        return name +
               ": there is no such golden (they are listed in tests/golden/*/points.cpp and subject.cpp)";
    auto golden = read_golden(order.folder, name);
    if (!golden) return golden.error().text() + " (first write about = and mistakes = there)";
    if (golden->mistakes.empty()) return name + ".toml: a golden needs mistakes that it notices";
    Product product = which->product();
    if (const std::string names = unnoticed(*which, *golden, product); !names.empty())
        return name + ": it would not notice" + names;
    const auto old = read_product(order.folder, name, product);
    const auto difference = old ? first_difference(*old, product) : std::optional<std::string>("new");
    if (!difference && golden->hash == hash(product)) return name + ": it passes, there is nothing to accept";
    golden->reason = order.reason, golden->hash = hash(product);
    accepted = {name, difference.value_or("its .toml"), *golden, std::move(product)};
    return "";
}

int refuse(const std::string& why) { return std::fprintf(stderr, "accept: %s\n", why.c_str()), 2; }

}  // namespace

int main(int count, char** words) {
#ifdef RELEVO_DOUBLE
    return refuse("the goldens are of float, and this is the double build");
#endif
    Order order;
    if (const std::string wrong = read_order(count, words, order); !wrong.empty()) return refuse(wrong);
    std::vector<Accepted> all(order.names.size());  // all or none
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const std::string wrong = examine(order, order.names[i], all[i]); !wrong.empty())
            return refuse(wrong);
    for (const Accepted& a : all) {
        if (const auto failure = write_product(order.folder + "/" + a.name, a.product))
            return refuse(failure->text());
        if (const auto failure = write_golden(order.folder, a.name, a.golden)) return refuse(failure->text());
        std::printf("accepted %s\n%s\n", a.name.c_str(), a.difference.c_str());
    }
}
