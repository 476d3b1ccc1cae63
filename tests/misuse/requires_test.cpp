// What the types forbid, said as requirements: the whole list at a glance. It is checked by being compiled.
#include "pipeline/transform.hpp"
#include "pipeline/viewport.hpp"
#include "raster/draw.hpp"

namespace relevo {
namespace {

using namespace pipeline;

template <class A, class B>
concept Adds = requires(A a, B b) {
    a + b;
};
template <class A, class B>
concept Subtracts = requires(A a, B b) {
    a - b;
};
template <class A, class B>
concept Multiplies = requires(A a, B b) {
    a* b;
};
template <class A, class B>
concept Becomes = requires(A a) {
    B{a};
};
template <class P>
concept Divides = requires(P p) {
    perspective_divide(p);
};

static_assert(Adds<Point<World>, Vec<World>> && Adds<Vec<World>, Vec<World>>);
static_assert(!Adds<Point<World>, Point<World>>, "places have no sum");
static_assert(!Adds<Point<World>, Vec<Eye>> && !Adds<Vec<World>, Vec<Eye>>, "two spaces");
static_assert(!Adds<Vec<World>, Point<World>>,
              "a place is moved by a displacement, not the other way around");
static_assert(!Adds<Point<World>, Normal<World>>, "a normal is no displacement");
static_assert(Subtracts<Point<World>, Point<World>>);
static_assert(!Subtracts<Point<World>, Point<Eye>> && !Subtracts<Point<World>, Point<Object>>);

using WorldFromObject = Affine<World, Object>;
using EyeFromWorld = Affine<Eye, World>;
using ClipFromEye = Projective<Clip, Eye>;
static_assert(Multiplies<EyeFromWorld, WorldFromObject> && Multiplies<ClipFromEye, EyeFromWorld>);
static_assert(!Multiplies<WorldFromObject, EyeFromWorld>, "the wrong order");
static_assert(!Multiplies<ClipFromEye, WorldFromObject>, "the eye is left out");
static_assert(!Multiplies<EyeFromWorld, EyeFromWorld>, "twice");
static_assert(!Multiplies<EyeFromWorld, ClipFromEye>);

using Moves = RoundedAffine<World, Object>;
static_assert(Multiplies<Moves, Point<Object>> && Multiplies<Moves, Vec<Object>>);
static_assert(!Multiplies<Moves, Point<World>> && !Multiplies<Moves, Vec<World>>, "already there");
static_assert(!Multiplies<Moves, Normal<Object>>, "a normal has a map of its own");
static_assert(!Multiplies<NormalMap<World, Object>, Point<Object>> &&
              !Multiplies<NormalMap<World, Object>, Vec<Object>>);
static_assert(Multiplies<NormalMap<World, Object>, Normal<Object>> &&
              !Multiplies<NormalMap<World, Object>, Normal<World>>);
static_assert(!Multiplies<WorldFromObject, Point<Object>>, "an unrounded map moves no vertex");

static_assert(Divides<HPoint<Clip>>);
static_assert(!Divides<HPoint<Eye>> && !Divides<Point<Clip>> && !Divides<Point<Eye>> && !Divides<Point<Ndc>>);

static_assert(!Becomes<Point<Object>, Point<World>> && !Becomes<Vec<World>, Point<World>> &&
              !Becomes<Normal<World>, Vec<World>>);

struct Deaf {
    void onn(const raster::FragmentCovered&) {}
};
static_assert(!raster::DrawProbe<Deaf> && raster::DrawProbe<NoProbe>);

}  // namespace
}  // namespace relevo
