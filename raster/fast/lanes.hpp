// N numbers side by side: pipeline/lane.hpp's words for a whole vector register, by Google Highway.
//
//   Floats   f0 f1 f2 ... fN-1                 N = 4 (SSE4), 8 (AVX2), 16 (AVX-512)
//   Ints     i0 i1 i2 ... iN-1
//   Words    w0 w1 w2 ... wN-1                 unsigned, sums mod 2^32
//   Doubles  d0 ... dN/2-1 | dN/2 ... dN-1     two registers: low and high half of the lanes
//   Bools    one truth a lane
//
// Every operation rounds each lane as the plain number's would: no fused multiply-add, no approximation.
// A source file that includes this is compiled for one instruction set; all that is here, and all that is
// made from it, lives in a namespace of that instruction set, so that the linker cannot mix them up.
#pragma once
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <bit>

#include "pipeline/color.hpp"
#include "pipeline/lane.hpp"
#include "pipeline/lane_vector.hpp"
#include "raster/texture.hpp"

namespace relevo::raster::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
#define RELEVO_LANE [[gnu::always_inline]] inline
// After a lambda's parameters: it becomes part of its caller, whatever its size.
#define RELEVO_INSIDE __attribute__((always_inline))

using TagF = hn::ScalableTag<float>;
using TagI = hn::ScalableTag<std::int32_t>;
using TagU = hn::ScalableTag<std::uint32_t>;
using TagD = hn::ScalableTag<double>;
using TagU64 = hn::ScalableTag<std::uint64_t>;
using HalfF = hn::Half<TagF>;
using HalfI = hn::Half<TagI>;

inline constexpr int lanes = static_cast<int>(HWY_LANES(float));

struct Bools {
    hn::Mask<TagF> m;
};
struct Ints {
    hn::Vec<TagI> v;
    Ints() = default;
    RELEVO_LANE explicit Ints(hn::Vec<TagI> raw) : v(raw) {}
    RELEVO_LANE Ints(std::int32_t all_lanes) : v(hn::Set(TagI(), all_lanes)) {}
};
struct Words {
    hn::Vec<TagU> v;
    Words() = default;
    RELEVO_LANE explicit Words(hn::Vec<TagU> raw) : v(raw) {}
    RELEVO_LANE Words(std::uint32_t all_lanes) : v(hn::Set(TagU(), all_lanes)) {}
};
struct Floats {
    hn::Vec<TagF> v;
    Floats() = default;
    RELEVO_LANE explicit Floats(hn::Vec<TagF> raw) : v(raw) {}
    RELEVO_LANE Floats(float all_lanes) : v(hn::Set(TagF(), all_lanes)) {}
};
struct Doubles {
    hn::Vec<TagD> low, high;
    Doubles() = default;
    RELEVO_LANE Doubles(hn::Vec<TagD> l, hn::Vec<TagD> h) : low(l), high(h) {}
    RELEVO_LANE Doubles(double all_lanes) : low(hn::Set(TagD(), all_lanes)), high(low) {}
};

}  // namespace relevo::raster::fast::HWY_NAMESPACE

namespace relevo::pipeline {

template <>
struct LaneTypes<raster::fast::HWY_NAMESPACE::Floats> {
    using Mask = raster::fast::HWY_NAMESPACE::Bools;
    using Wide = raster::fast::HWY_NAMESPACE::Doubles;
    using Whole = raster::fast::HWY_NAMESPACE::Ints;
    using BigWhole = raster::fast::HWY_NAMESPACE::Doubles;
    using Word = raster::fast::HWY_NAMESPACE::Words;
};

}  // namespace relevo::pipeline

namespace relevo::raster::fast::HWY_NAMESPACE {

// ------------------------------------------------------------------------------------------------ truths
RELEVO_LANE Bools operator&(Bools a, Bools b) { return {hn::And(a.m, b.m)}; }
RELEVO_LANE Bools operator|(Bools a, Bools b) { return {hn::Or(a.m, b.m)}; }
RELEVO_LANE Bools operator&&(Bools a, Bools b) { return a & b; }
RELEVO_LANE Bools operator||(Bools a, Bools b) { return a | b; }
RELEVO_LANE Bools operator!(Bools a) { return {hn::Not(a.m)}; }
RELEVO_LANE bool any(Bools a) { return !hn::AllFalse(TagF(), a.m); }
RELEVO_LANE bool all(Bools a) { return hn::AllTrue(TagF(), a.m); }
RELEVO_LANE int count(Bools a) { return static_cast<int>(hn::CountTrue(TagF(), a.m)); }
// Bit k tells lane k.
RELEVO_LANE std::uint32_t bits(Bools a) {
#if HWY_TARGET == HWY_AVX3
    return a.m.raw;
#else
    alignas(8) std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(TagF(), a.m, bytes);
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8;
#endif
}
RELEVO_LANE Bools from_bits(std::uint32_t which) {
#if HWY_TARGET == HWY_AVX3
    return {hn::Mask<TagF>{static_cast<__mmask16>(which)}};
#else
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(which), static_cast<std::uint8_t>(which >> 8)};
    return {hn::LoadMaskBits(TagF(), bytes)};
#endif
}
inline constexpr std::uint32_t all_bits = (2u << (lanes - 1)) - 1;
RELEVO_LANE Bools first_lanes(int n) { return {hn::FirstN(TagF(), static_cast<std::size_t>(n))}; }
RELEVO_LANE hn::Mask<TagI> int_mask(Bools a) { return hn::RebindMask(TagI(), a.m); }
RELEVO_LANE Bools float_mask(hn::Mask<TagI> m) { return {hn::RebindMask(TagF(), m)}; }

// ------------------------------------------------------------------------------------------------ floats
RELEVO_LANE Floats operator+(Floats a, Floats b) { return Floats(hn::Add(a.v, b.v)); }
RELEVO_LANE Floats operator-(Floats a, Floats b) { return Floats(hn::Sub(a.v, b.v)); }
RELEVO_LANE Floats operator*(Floats a, Floats b) { return Floats(hn::Mul(a.v, b.v)); }
RELEVO_LANE Floats operator/(Floats a, Floats b) { return Floats(hn::Div(a.v, b.v)); }
RELEVO_LANE Floats operator-(Floats a) { return Floats(hn::Neg(a.v)); }
RELEVO_LANE Bools operator>(Floats a, Floats b) { return {hn::Gt(a.v, b.v)}; }
RELEVO_LANE Bools operator<(Floats a, Floats b) { return {hn::Lt(a.v, b.v)}; }
RELEVO_LANE Bools operator>=(Floats a, Floats b) { return {hn::Ge(a.v, b.v)}; }
RELEVO_LANE Bools operator<=(Floats a, Floats b) { return {hn::Le(a.v, b.v)}; }
RELEVO_LANE Bools operator==(Floats a, Floats b) { return {hn::Eq(a.v, b.v)}; }
// The processor's own: b where one is not a number, and of two zeros b.
RELEVO_LANE Floats greater(Floats a, Floats b) { return Floats(hn::Max(a.v, b.v)); }
RELEVO_LANE Floats smaller(Floats a, Floats b) { return Floats(hn::Min(a.v, b.v)); }
RELEVO_LANE Floats sqrt(Floats a) { return Floats(hn::Sqrt(a.v)); }
RELEVO_LANE Floats floor(Floats a) { return Floats(hn::Floor(a.v)); }
RELEVO_LANE Bools is_finite(Floats a) { return {hn::IsFinite(a.v)}; }
RELEVO_LANE float sum(Floats a) { return hn::GetLane(hn::SumOfLanes(TagF(), a.v)); }
RELEVO_LANE Floats select(Bools mask, Floats yes, Floats no) {
    return Floats(hn::IfThenElse(mask.m, yes.v, no.v));
}

// ------------------------------------------------------------------------------------------------ integers
RELEVO_LANE Ints operator+(Ints a, Ints b) { return Ints(hn::Add(a.v, b.v)); }
RELEVO_LANE Ints operator-(Ints a, Ints b) { return Ints(hn::Sub(a.v, b.v)); }
RELEVO_LANE Ints operator*(Ints a, Ints b) { return Ints(hn::Mul(a.v, b.v)); }
RELEVO_LANE Ints operator&(Ints a, Ints b) { return Ints(hn::And(a.v, b.v)); }
RELEVO_LANE Ints operator|(Ints a, Ints b) { return Ints(hn::Or(a.v, b.v)); }
RELEVO_LANE Ints operator^(Ints a, Ints b) { return Ints(hn::Xor(a.v, b.v)); }
template <int by>
RELEVO_LANE Ints shift_left(Ints a) {
    return Ints(hn::ShiftLeft<by>(a.v));
}
// The sign comes along, as >> of a plain int does.
template <int by>
RELEVO_LANE Ints shift_right(Ints a) {
    return Ints(hn::ShiftRight<by>(a.v));
}
RELEVO_LANE Ints operator>>(Ints a, int by) { return Ints(hn::ShiftRightSame(a.v, by)); }
RELEVO_LANE Bools operator>(Ints a, Ints b) { return float_mask(hn::Gt(a.v, b.v)); }
RELEVO_LANE Bools operator<(Ints a, Ints b) { return float_mask(hn::Lt(a.v, b.v)); }
RELEVO_LANE Bools operator==(Ints a, Ints b) { return float_mask(hn::Eq(a.v, b.v)); }
RELEVO_LANE Ints min(Ints a, Ints b) { return Ints(hn::Min(a.v, b.v)); }
RELEVO_LANE Ints max(Ints a, Ints b) { return Ints(hn::Max(a.v, b.v)); }
RELEVO_LANE Ints select(Bools mask, Ints yes, Ints no) {
    return Ints(hn::IfThenElse(int_mask(mask), yes.v, no.v));
}
RELEVO_LANE int first_lane(Ints a) { return hn::GetLane(a.v); }
RELEVO_LANE int largest(Ints a) { return hn::GetLane(hn::MaxOfLanes(TagI(), a.v)); }
RELEVO_LANE Bools is_negative(Ints a) { return a < Ints(0); }
RELEVO_LANE Words operator+(Words a, Words b) { return Words(hn::Add(a.v, b.v)); }
RELEVO_LANE Words operator-(Words a, Words b) { return Words(hn::Sub(a.v, b.v)); }
RELEVO_LANE Words operator*(Words a, Words b) { return Words(hn::Mul(a.v, b.v)); }
RELEVO_LANE Words operator&(Words a, Words b) { return Words(hn::And(a.v, b.v)); }
RELEVO_LANE Words operator|(Words a, Words b) { return Words(hn::Or(a.v, b.v)); }
RELEVO_LANE Words operator<<(Words a, int by) { return Words(hn::ShiftLeftSame(a.v, by)); }
RELEVO_LANE Words operator>>(Words a, int by) { return Words(hn::ShiftRightSame(a.v, by)); }
// Of each four lanes the first.
RELEVO_LANE Ints first_of_four(Ints a) { return Ints(hn::Broadcast<0>(a.v)); }
RELEVO_LANE Ints lane_numbers() { return Ints(hn::Iota(TagI(), 0)); }  // 0 1 2 ... N-1

// ------------------------------------------------------------------------------------------------ doubles
RELEVO_LANE Doubles operator+(Doubles a, Doubles b) {
    return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
}
RELEVO_LANE Doubles operator-(Doubles a, Doubles b) {
    return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
}
RELEVO_LANE Doubles operator*(Doubles a, Doubles b) {
    return {hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)};
}
RELEVO_LANE Doubles operator/(Doubles a, Doubles b) {
    return {hn::Div(a.low, b.low), hn::Div(a.high, b.high)};
}
RELEVO_LANE Doubles greater(Doubles a, Doubles b) { return {hn::Max(a.low, b.low), hn::Max(a.high, b.high)}; }
RELEVO_LANE Doubles smaller(Doubles a, Doubles b) { return {hn::Min(a.low, b.low), hn::Min(a.high, b.high)}; }
// A truth a lane, as wide as the lanes of Doubles.
struct WideBools {
    hn::Mask<TagD> low, high;
};
RELEVO_LANE WideBools widen(Bools a) {
#if HWY_TARGET == HWY_AVX3
    return {{static_cast<__mmask8>(a.m.raw)}, {static_cast<__mmask8>(a.m.raw >> 8)}};
#else
    const auto whole = hn::VecFromMask(TagI(), int_mask(a));
    const hn::ScalableTag<std::int64_t> tag;
    return {hn::MaskFromVec(hn::BitCast(TagD(), hn::PromoteTo(tag, hn::LowerHalf(whole)))),
            hn::MaskFromVec(hn::BitCast(TagD(), hn::PromoteTo(tag, hn::UpperHalf(HalfI(), whole))))};
#endif
}
RELEVO_LANE Doubles select(const WideBools& mask, Doubles yes, Doubles no) {
    return {hn::IfThenElse(mask.low, yes.low, no.low), hn::IfThenElse(mask.high, yes.high, no.high)};
}
RELEVO_LANE Doubles select(Bools mask, Doubles yes, Doubles no) { return select(widen(mask), yes, no); }
// The upper 32 bits of each lane: sign, exponent and the first digits.
RELEVO_LANE Ints upper_words(Doubles a) {
    return Ints(hn::ConcatOdd(TagI(), hn::BitCast(TagI(), a.high), hn::BitCast(TagI(), a.low)));
}
RELEVO_LANE Bools is_negative(Doubles a) { return is_negative(upper_words(a)); }  // -0, too
RELEVO_LANE Bools operator>(Doubles a, Doubles b) { return is_negative(b - a); }
RELEVO_LANE Bools operator<(Doubles a, Doubles b) { return is_negative(a - b); }

// ------------------------------------------------------------------------------------------- conversions
RELEVO_LANE Doubles to_wide(Doubles a) { return a; }
RELEVO_LANE Doubles to_wide(Floats a) {
    return {hn::PromoteTo(TagD(), hn::LowerHalf(HalfF(), a.v)),
            hn::PromoteTo(TagD(), hn::UpperHalf(HalfF(), a.v))};
}
RELEVO_LANE Doubles to_wide(Ints a) {
    return {hn::PromoteTo(TagD(), hn::LowerHalf(HalfI(), a.v)),
            hn::PromoteTo(TagD(), hn::UpperHalf(HalfI(), a.v))};
}
RELEVO_LANE Floats rounded(Doubles a) {
#if HWY_TARGET == HWY_AVX3
    return Floats(hn::Vec<TagF>{_mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(a.low.raw)),
                                                   _mm512_cvtpd_ps(a.high.raw), 1)});
#else
    return Floats(hn::Combine(TagF(), hn::DemoteTo(HalfF(), a.high), hn::DemoteTo(HalfF(), a.low)));
#endif
}
// Whole numbers below 2^51, mod 2^32: in the sum they are the last digits.
RELEVO_LANE Ints low_words(Doubles a) {
    const Doubles sum = a + Doubles(0x1.8p52);
    return Ints(hn::ConcatEven(TagI(), hn::BitCast(TagI(), sum.high), hn::BitCast(TagI(), sum.low)));
}
RELEVO_LANE Doubles to_big(Ints a) { return to_wide(a); }
// The processor's own conversions: of numbers within int32; hn's would take care of others, too.
RELEVO_LANE Ints nearest(Doubles a) {  // ties to even
#if HWY_TARGET == HWY_AVX3
    return Ints(hn::Vec<TagI>{_mm512_inserti64x4(_mm512_castsi256_si512(_mm512_cvtpd_epi32(a.low.raw)),
                                                 _mm512_cvtpd_epi32(a.high.raw), 1)});
#elif HWY_TARGET == HWY_AVX2
    return Ints(hn::Vec<TagI>{_mm256_inserti128_si256(_mm256_castsi128_si256(_mm256_cvtpd_epi32(a.low.raw)),
                                                      _mm256_cvtpd_epi32(a.high.raw), 1)});
#else
    return Ints(hn::Vec<TagI>{_mm_unpacklo_epi64(_mm_cvtpd_epi32(a.low.raw), _mm_cvtpd_epi32(a.high.raw))});
#endif
}
RELEVO_LANE Ints truncated(Doubles a) {
#if HWY_TARGET == HWY_AVX3
    return Ints(hn::Vec<TagI>{_mm512_inserti64x4(_mm512_castsi256_si512(_mm512_cvttpd_epi32(a.low.raw)),
                                                 _mm512_cvttpd_epi32(a.high.raw), 1)});
#elif HWY_TARGET == HWY_AVX2
    return Ints(hn::Vec<TagI>{_mm256_inserti128_si256(_mm256_castsi128_si256(_mm256_cvttpd_epi32(a.low.raw)),
                                                      _mm256_cvttpd_epi32(a.high.raw), 1)});
#else
    return Ints(hn::Vec<TagI>{_mm_unpacklo_epi64(_mm_cvttpd_epi32(a.low.raw), _mm_cvttpd_epi32(a.high.raw))});
#endif
}
RELEVO_LANE Ints truncated(Floats a) {
#if HWY_TARGET == HWY_AVX3
    return Ints(hn::Vec<TagI>{_mm512_cvttps_epi32(a.v.raw)});
#elif HWY_TARGET == HWY_AVX2
    return Ints(hn::Vec<TagI>{_mm256_cvttps_epi32(a.v.raw)});
#else
    return Ints(hn::Vec<TagI>{_mm_cvttps_epi32(a.v.raw)});
#endif
}
RELEVO_LANE Floats to_real(Ints a) { return Floats(hn::ConvertTo(TagF(), a.v)); }
RELEVO_LANE Words to_word(Ints a) { return Words(hn::BitCast(TagU(), a.v)); }
RELEVO_LANE Ints to_whole(Words a) { return Ints(hn::BitCast(TagI(), a.v)); }
// Two halves of 16 bits are exact in float, so the sum alone rounds.
RELEVO_LANE Floats to_real(Words a) {
    return to_real(to_whole(a >> 16)) * 65536.0f + to_real(to_whole(a & 65535u));
}
RELEVO_LANE Ints float_bits(Floats a) { return Ints(hn::BitCast(TagI(), a.v)); }
RELEVO_LANE Floats bits_float(Ints a) { return Floats(hn::BitCast(TagF(), a.v)); }

// The lanes that are true move to the front, in their order; what follows is 0 or another lane's number.
#if HWY_TARGET <= HWY_AVX3
RELEVO_LANE Ints compress(Ints a, Bools mask) { return Ints(hn::Compress(a.v, int_mask(mask))); }
#else
// By a table of orders. Highway's own stands inside its function, and g++ copies it to the stack at every
// call.
struct LaneOrders {
    std::uint8_t of[1 << lanes][lanes];
};
inline constexpr LaneOrders lane_orders = [] {
    LaneOrders orders{};
    for (int mask = 0; mask < 1 << lanes; ++mask)
        for (int k = 0, n = 0; k < lanes; ++k)
            if (mask >> k & 1) orders.of[mask][n++] = static_cast<std::uint8_t>(k);
    return orders;
}();
RELEVO_LANE Ints compress(Ints a, Bools mask) {
    const auto order = hn::LoadU(hn::Rebind<std::uint8_t, TagI>(), lane_orders.of[bits(mask)]);
    return Ints(hn::TableLookupLanes(a.v, hn::IndicesFromVec(TagI(), hn::PromoteTo(TagI(), order))));
}
#endif
RELEVO_LANE Floats compress(Floats a, Bools mask) { return bits_float(compress(float_bits(a), mask)); }

// In each lane the number of another one: the same for many registers.
struct Picked {
    decltype(hn::IndicesFromVec(TagI(), hn::Zero(TagI()))) by;
    Ints lane;
    // lane: 0 .. N-1
    RELEVO_LANE explicit Picked(Ints lanes_numbers)
        : by(hn::IndicesFromVec(TagI(), lanes_numbers.v)), lane(lanes_numbers) {}

    RELEVO_LANE Ints operator()(Ints a) const { return Ints(hn::TableLookupLanes(a.v, by)); }
    RELEVO_LANE Floats operator()(Floats a) const { return bits_float((*this)(float_bits(a))); }
    RELEVO_LANE Doubles operator()(Doubles a) const {
        const auto half = [&](auto number) RELEVO_INSIDE {
#if HWY_TARGET == HWY_AVX3
            return hn::Vec<TagD>{
                _mm512_permutex2var_pd(a.low.raw, _mm512_cvtepu32_epi64(number.raw), a.high.raw)};
#else
            const hn::ScalableTag<std::int64_t> wide;
            const auto index = hn::PromoteTo(wide, number);
            const auto last = hn::Set(wide, lanes / 2 - 1);
            const auto in_half = hn::IndicesFromVec(TagD(), hn::And(index, last));
            return hn::IfThenElse(hn::RebindMask(TagD(), hn::Gt(index, last)),
                                  hn::TableLookupLanes(a.high, in_half),
                                  hn::TableLookupLanes(a.low, in_half));
#endif
        };
        return {half(hn::LowerHalf(HalfI(), lane.v)), half(hn::UpperHalf(HalfI(), lane.v))};
    }
};

// ------------------------------------------------------------------------------------------------ memory
// Of N values in a row, anywhere.
RELEVO_LANE Floats load(const float* p) { return Floats(hn::LoadU(TagF(), p)); }
RELEVO_LANE Ints load(const std::int32_t* p) { return Ints(hn::LoadU(TagI(), p)); }
RELEVO_LANE Ints load(const std::uint32_t* p) { return Ints(hn::BitCast(TagI(), hn::LoadU(TagU(), p))); }
RELEVO_LANE Doubles load(const double* p) { return {hn::LoadU(TagD(), p), hn::LoadU(TagD(), p + lanes / 2)}; }
RELEVO_LANE void store(Floats a, float* p) { hn::StoreU(a.v, TagF(), p); }
RELEVO_LANE void store(Ints a, std::int32_t* p) { hn::StoreU(a.v, TagI(), p); }
RELEVO_LANE void store(Ints a, std::uint32_t* p) { hn::StoreU(hn::BitCast(TagU(), a.v), TagU(), p); }
RELEVO_LANE void store(Doubles a, double* p) {
    hn::StoreU(a.low, TagD(), p);
    hn::StoreU(a.high, TagD(), p + lanes / 2);
}
// The lanes of `mask`. The others' memory may be written, too, as it is.
RELEVO_LANE void store_where(Bools mask, Floats a, float* p) {
#if HWY_TARGET == HWY_AVX3
    _mm512_mask_storeu_ps(p, mask.m.raw, a.v.raw);
#else
    store(select(mask, a, load(p)), p);
#endif
}
RELEVO_LANE void store_where(Bools mask, Ints a, std::uint32_t* p) {
#if HWY_TARGET == HWY_AVX3
    _mm512_mask_storeu_epi32(p, mask.m.raw, a.v.raw);
#else
    store(select(mask, a, load(p)), p);
#endif
}
// Four numbers of each lane side by side, or eight: a0 a1 .. of lane 0 | of lane 1 | ...
RELEVO_LANE void store_fours(const Floats* a, float* p) {
    hn::StoreInterleaved4(a[0].v, a[1].v, a[2].v, a[3].v, TagF(), p);
}
RELEVO_LANE void store_eights(const Floats* a, float* p) {
    alignas(64) float first[4 * lanes], second[4 * lanes];
    store_fours(a, first), store_fours(a + 4, second);
    for (int k = 0; k < 4 * lanes; k += lanes) {
        const auto x = hn::Load(TagF(), first + k), y = hn::Load(TagF(), second + k);
#if HWY_TARGET == HWY_AVX3
        const __m512i low = _mm512_set_epi64(11, 10, 3, 2, 9, 8, 1, 0),
                      high = _mm512_set_epi64(15, 14, 7, 6, 13, 12, 5, 4);
        const __m512d xd = _mm512_castps_pd(x.raw), yd = _mm512_castps_pd(y.raw);
        _mm512_storeu_pd(p + 2 * k, _mm512_permutex2var_pd(xd, low, yd));
        _mm512_storeu_pd(p + 2 * k + lanes, _mm512_permutex2var_pd(xd, high, yd));
#elif HWY_TARGET == HWY_AVX2
        hn::StoreU(hn::ConcatLowerLower(TagF(), y, x), TagF(), p + 2 * k);
        hn::StoreU(hn::ConcatUpperUpper(TagF(), y, x), TagF(), p + 2 * k + lanes);
#else
        hn::StoreU(x, TagF(), p + 2 * k), hn::StoreU(y, TagF(), p + 2 * k + lanes);
#endif
    }
}
// Past the caches, to a multiple of the register's size.
RELEVO_LANE void stream(Floats a, float* p) { hn::Stream(a.v, TagF(), p); }
RELEVO_LANE void stream(Ints a, std::uint32_t* p) { hn::Stream(hn::BitCast(TagU(), a.v), TagU(), p); }
// base[index] of each lane, index >= 0.
RELEVO_LANE Ints gather(const std::int32_t* base, Ints index) {
    return Ints(hn::GatherIndex(TagI(), base, index.v));
}
RELEVO_LANE Ints gather(const std::uint32_t* base, Ints index) {
    return gather(reinterpret_cast<const std::int32_t*>(base), index);
}

RELEVO_LANE Words look_up(const std::uint32_t* table, Ints index) {
    return Words(hn::GatherIndex(TagU(), table, index.v));
}
// A texel is four numbers of 16 bits, so two words: red and green, blue and nothing.
RELEVO_LANE TexelOf<Floats> texel(const Texture& texture, Ints index) {
    const auto* words = reinterpret_cast<const std::uint32_t*>(texture.texels.data());
    const Words red_green = look_up(words, index + index), blue = look_up(words + 1, index + index);
    return {red_green & 0xffffu, red_green >> 16, blue & 0xffffu};
}

// Lanes as a block of pixels, 4 wide: lane k is pixel (k % 4, k / 4).
inline constexpr int block_columns = 4, block_rows = lanes / block_columns;
RELEVO_LANE Ints lane_columns() { return lane_numbers() & Ints(block_columns - 1); }
RELEVO_LANE Ints lane_rows() { return Ints(hn::ShiftRight<2>(lane_numbers().v)); }
// p: the block's first pixel, of rows of `stride`. The lambdas are generic so that each instruction set
// compiles its own case alone.
RELEVO_LANE Ints load_block(const std::uint32_t* p, int stride) {
    const hn::Full128<std::int32_t> four;
    const auto block = [&](auto y) RELEVO_INSIDE {
        const auto row = [&](auto number) RELEVO_INSIDE {
            return hn::LoadU(four, reinterpret_cast<const std::int32_t*>(p + number * stride));
        };
        if constexpr (lanes == 4) {
            return row(y);
        } else if constexpr (lanes == 8) {
            return hn::Combine(TagI(), row(y + 1), row(y));
        } else {
            return hn::Combine(TagI(), hn::Combine(HalfI(), row(y + 3), row(y + 2)),
                               hn::Combine(HalfI(), row(y + 1), row(y)));
        }
    };
    return Ints(block(0));
}
RELEVO_LANE void store_block(Ints a, std::uint32_t* p, int stride) {
    const hn::Full128<std::int32_t> four;
    const auto rows = [&](auto self, auto of, int y) RELEVO_INSIDE {
        if constexpr (sizeof(of) == 16) {
            hn::StoreU(of, four, reinterpret_cast<std::int32_t*>(p + y * stride));
        } else {
            const hn::Half<hn::DFromV<decltype(of)>> half;
            self(self, hn::LowerHalf(half, of), y);
            self(self, hn::UpperHalf(half, of), y + static_cast<int>(sizeof(of)) / 32);
        }
    };
    rows(rows, a.v, 0);
}

// Lanes as rows of `columns` pixels, N of them or, in AVX-512, 8: lane k is pixel (k % columns, k / columns).
template <int columns>
inline constexpr int rows_of_lanes = lanes / columns;
template <int columns>
RELEVO_LANE Ints lane_columns_of() {
    return lane_numbers() & Ints(columns - 1);
}
template <int columns>
RELEVO_LANE Ints lane_rows_of() {
    return lane_numbers() >> std::countr_zero(0u + columns);
}
template <int columns>
RELEVO_LANE Floats load_rows(const float* p, [[maybe_unused]] int stride) {
    if constexpr (columns == lanes)
        return load(p);
    else
        return Floats(hn::Combine(TagF(), hn::LoadU(HalfF(), p + stride), hn::LoadU(HalfF(), p)));
}
template <int columns>
RELEVO_LANE void store_rows_where(Bools mask, Floats a, float* p, [[maybe_unused]] int stride) {
#if HWY_TARGET == HWY_AVX3
    if constexpr (columns < lanes) {
        _mm256_mask_storeu_ps(p, static_cast<__mmask8>(mask.m.raw), _mm512_castps512_ps256(a.v.raw));
        _mm256_mask_storeu_ps(p + stride, static_cast<__mmask8>(mask.m.raw >> 8),
                              _mm512_extractf32x8_ps(a.v.raw, 1));
        return;
    }
#else
    static_assert(columns == lanes);
#endif
    store_where(mask, a, p);
}
template <int columns>
RELEVO_LANE void store_rows_where(Bools mask, Ints a, std::uint32_t* p, int stride) {
    store_rows_where<columns>(mask, bits_float(a), reinterpret_cast<float*>(p), stride);
}

// f of each lane, one after the other: for the rare formula that is only written for one.
template <class F>
RELEVO_LANE Floats each_lane(F&& f, Floats x) {
    alignas(64) float lane[lanes];
    store(x, lane);
    for (float& value : lane) value = f(value);
    return load(lane);
}
template <class F>
RELEVO_LANE pipeline::LaneVec3<Floats> each_lane(F&& f, const pipeline::LaneVec3<Floats>& p) {
    alignas(64) float x[lanes], y[lanes], z[lanes];
    store(p.x, x), store(p.y, y), store(p.z, z);
    for (int k = 0; k < lanes; ++k) {
        const pipeline::Vec3 of_lane = f(pipeline::Vec3(x[k], y[k], z[k]));
        x[k] = of_lane.x, y[k] = of_lane.y, z[k] = of_lane.z;
    }
    return {load(x), load(y), load(z)};
}

}  // namespace relevo::raster::fast::HWY_NAMESPACE
