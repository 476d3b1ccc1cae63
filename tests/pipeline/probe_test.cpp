#include "pipeline/probe.hpp"

#include <gtest/gtest.h>

namespace relevo::pipeline {
namespace {

struct Step {
    int value;
};
struct OtherStep {
    int value;
};

struct HearsSteps {
    int sum = 0;
    void on(const Step& e) { sum += e.value; }
};
struct HearsEverything {
    int events = 0;
    void on(const auto&) { ++events; }
};
struct Misspelt {
    void onn(const Step&) {}
};
struct WrongEvent {
    void on(const int&) {}
};

static_assert(Wants<HearsSteps, Step> && !Wants<HearsSteps, OtherStep>);
static_assert(Wants<HearsEverything, Step> && Wants<HearsEverything&, OtherStep>);
static_assert(!Wants<NoProbe, Step> && !Wants<const NoProbe, Step>);
static_assert(ProbeOf<HearsSteps, Step, OtherStep> && ProbeOf<HearsSteps&, OtherStep, Step>);
static_assert(ProbeOf<NoProbe, Step> && ProbeOf<const NoProbe, Step> && ProbeOf<NoProbe&, Step>);
static_assert(!ProbeOf<Misspelt, Step, OtherStep>, "a deaf probe is refused");
static_assert(!ProbeOf<WrongEvent, Step, OtherStep>, "so is one for another machine");
static_assert(!ProbeOf<const HearsSteps, Step>, "a probe that cannot record is no probe");

TEST(Probe, HearsWhatItWantsAndNothingElse) {
    HearsSteps steps;
    HearsEverything all;
    const NoProbe none;
    note<Step>(steps, 3), note<OtherStep>(steps, 100), note<Step>(steps, 4);
    note<Step>(all, 3), note<OtherStep>(all, 100);
    note<Step>(none, 3);
    EXPECT_EQ(steps.sum, 7);
    EXPECT_EQ(all.events, 2);
}

}  // namespace
}  // namespace relevo::pipeline
