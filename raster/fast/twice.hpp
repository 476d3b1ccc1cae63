// Two registers of everything: 2 N lanes that go through the shared arithmetic together.
//
//   Twice<Floats>   a0 .. aN-1 | b0 .. bN-1
//
// Light is a long chain of operations that wait for each other. Two chains side by side fill the waiting.
#pragma once
#include <concepts>

#include "raster/fast/lanes.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

template <class T>
struct Twice {
    T a, b;
    Twice() = default;
    RELEVO_LANE Twice(T first, T second) : a(first), b(second) {}
    template <class All>
    requires std::convertible_to<All, T> RELEVO_LANE Twice(All all_lanes) : a(all_lanes), b(a) {}

    RELEVO_LANE friend Twice operator+(Twice x, Twice y) { return {x.a + y.a, x.b + y.b}; }
    RELEVO_LANE friend Twice operator-(Twice x, Twice y) { return {x.a - y.a, x.b - y.b}; }
    RELEVO_LANE friend Twice operator*(Twice x, Twice y) { return {x.a * y.a, x.b * y.b}; }
    RELEVO_LANE friend Twice operator/(Twice x, Twice y) { return {x.a / y.a, x.b / y.b}; }
    RELEVO_LANE friend Twice operator-(Twice x) { return {-x.a, -x.b}; }
    RELEVO_LANE friend Twice operator&(Twice x, Twice y) { return {x.a & y.a, x.b & y.b}; }
    RELEVO_LANE friend Twice operator|(Twice x, Twice y) { return {x.a | y.a, x.b | y.b}; }
    RELEVO_LANE friend Twice operator&&(Twice x, Twice y) { return {x.a && y.a, x.b && y.b}; }
    RELEVO_LANE friend Twice operator||(Twice x, Twice y) { return {x.a || y.a, x.b || y.b}; }
    RELEVO_LANE friend Twice operator!(Twice x) { return {!x.a, !x.b}; }
    RELEVO_LANE friend Twice operator<<(Twice x, int by) { return {x.a << by, x.b << by}; }
    RELEVO_LANE friend Twice operator>>(Twice x, int by) { return {x.a >> by, x.b >> by}; }
    RELEVO_LANE friend Twice<Bools> operator>(Twice x, Twice y) { return {x.a > y.a, x.b > y.b}; }
    RELEVO_LANE friend Twice<Bools> operator<(Twice x, Twice y) { return {x.a < y.a, x.b < y.b}; }
    RELEVO_LANE friend Twice<Bools> operator>=(Twice x, Twice y) { return {x.a >= y.a, x.b >= y.b}; }
    RELEVO_LANE friend Twice<Bools> operator<=(Twice x, Twice y) { return {x.a <= y.a, x.b <= y.b}; }
    RELEVO_LANE friend Twice<Bools> operator==(Twice x, Twice y) { return {x.a == y.a, x.b == y.b}; }
    RELEVO_LANE friend Twice select(Twice<Bools> mask, Twice yes, Twice no) {
        return {select(mask.a, yes.a, no.a), select(mask.b, yes.b, no.b)};
    }
};
using Floats2 = Twice<Floats>;

RELEVO_LANE bool any(Twice<Bools> x) { return any(x.a || x.b); }
RELEVO_LANE bool all(Twice<Bools> x) { return all(x.a && x.b); }
RELEVO_LANE Floats2 greater(Floats2 x, Floats2 y) { return {greater(x.a, y.a), greater(x.b, y.b)}; }
RELEVO_LANE Floats2 smaller(Floats2 x, Floats2 y) { return {smaller(x.a, y.a), smaller(x.b, y.b)}; }
RELEVO_LANE Floats2 sqrt(Floats2 x) { return {sqrt(x.a), sqrt(x.b)}; }
RELEVO_LANE Floats2 floor(Floats2 x) { return {floor(x.a), floor(x.b)}; }
RELEVO_LANE Twice<Ints> truncated(Floats2 x) { return {truncated(x.a), truncated(x.b)}; }
template <class T>
RELEVO_LANE Floats2 to_real(Twice<T> x) {
    return {to_real(x.a), to_real(x.b)};
}
RELEVO_LANE Twice<Words> to_word(Twice<Ints> x) { return {to_word(x.a), to_word(x.b)}; }
RELEVO_LANE Twice<Ints> to_whole(Twice<Words> x) { return {to_whole(x.a), to_whole(x.b)}; }
RELEVO_LANE Twice<Words> look_up(const std::uint32_t* table, Twice<Ints> index) {
    return {look_up(table, index.a), look_up(table, index.b)};
}

template <class F>
RELEVO_LANE Floats2 each_lane(F&& f, Floats2 x) {
    return {each_lane(f, x.a), each_lane(f, x.b)};
}
template <class F>
RELEVO_LANE pipeline::LaneVec3<Floats2> each_lane(F&& f, const pipeline::LaneVec3<Floats2>& p) {
    const pipeline::LaneVec3<Floats> a = each_lane(f, pipeline::LaneVec3<Floats>{p.x.a, p.y.a, p.z.a}),
                                     b = each_lane(f, pipeline::LaneVec3<Floats>{p.x.b, p.y.b, p.z.b});
    return {{a.x, b.x}, {a.y, b.y}, {a.z, b.z}};
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE

namespace relevo::pipeline {

template <>
struct LaneTypes<raster::fast::HWY_NAMESPACE::Floats2> {
    template <class T>
    using Twice = raster::fast::HWY_NAMESPACE::Twice<T>;
    using Mask = Twice<raster::fast::HWY_NAMESPACE::Bools>;
    using Wide = Twice<raster::fast::HWY_NAMESPACE::Doubles>;
    using Whole = Twice<raster::fast::HWY_NAMESPACE::Ints>;
    using BigWhole = Twice<raster::fast::HWY_NAMESPACE::Doubles>;
    using Word = Twice<raster::fast::HWY_NAMESPACE::Words>;
};

}  // namespace relevo::pipeline

namespace relevo::raster::fast::HWY_NAMESPACE {

RELEVO_LANE TexelOf<Floats2> texel(const Texture& texture, Twice<Ints> index) {
    const TexelOf<Floats> a = texel(texture, index.a), b = texel(texture, index.b);
    return {{a.r, b.r}, {a.g, b.g}, {a.b, b.b}};
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
