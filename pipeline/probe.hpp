// A probe watches an algorithm from outside. The algorithm names its moments; the probe says which it wants
// to hear.
//
// A probe is any struct with `void on(const Event&)` for the events it wants; the other events vanish for it
// at compile time. `on(const auto&)` hears all. Events are plain structs in the header of the stage that
// notes them.
#pragma once
#include <concepts>
#include <type_traits>
#include <utility>

namespace relevo::pipeline {

struct NoProbe {};

template <class Probe, class Event>
concept Wants = requires(std::remove_reference_t<Probe>& probe, const Event& event) {
    probe.on(event);
};

// A misspelt `on` would be silently deaf: machines require one of their own events to be heard.
template <class Probe, class... Events>
concept ProbeOf = std::same_as<std::remove_cvref_t<Probe>, NoProbe> ||(Wants<Probe, Events> || ...);

// Arguments are references: nothing is built unless the probe wants the event.
template <class Event, class Probe, class... Arguments>
constexpr void note(Probe& probe, Arguments&&... arguments) {
    if constexpr (Wants<Probe, Event>) probe.on(Event{std::forward<Arguments>(arguments)...});
}

}  // namespace relevo::pipeline
