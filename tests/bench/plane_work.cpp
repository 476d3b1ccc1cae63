#include "tests/bench/plane_work.hpp"

#include "pipeline/elementary.hpp"
#include "tests/support/hard.hpp"

namespace relevo::bench {

std::vector<Primitive> primitives(Kind kind, int count) {
    tests::hard::Random random(static_cast<std::uint64_t>(kind));
    std::vector<Primitive> all(static_cast<std::size_t>(count));
    const auto between = [&](double a, double b) { return static_cast<float>(random.between(a, b)); };
    for (Primitive& p : all) {
        p = {};
        p.x[0] = between(0, plane_size), p.y[0] = between(0, plane_size);
        p.radius = between(2, 64);
        if (kind == Kind::Lines) {
            const pipeline::Degrees angle{random.between(0, 360)};
            const double length = random.between(2, 128);
            p.x[1] = p.x[0] + static_cast<float>(length * pipeline::cos(angle));
            p.y[1] = p.y[0] + static_cast<float>(length * pipeline::sin(angle));
        }
        if (kind == Kind::Triangles)
            for (int k : {1, 2}) {
                p.x[k] = p.x[0] + between(-32, 32);
                p.y[k] = p.y[0] + between(-32, 32);
            }
        const auto level = [&] { return static_cast<std::uint8_t>(random.integer(64, 255)); };
        p.color.r = level(), p.color.g = level(), p.color.b = level();
    }
    return all;
}

}  // namespace relevo::bench
