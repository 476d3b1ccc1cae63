// A value, or one sentence that says why there is none. (std::expected is not in g++ 12.)
#pragma once
#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace relevo::pipeline {

struct Error {
    std::string
        message;  // what was wrong and what is accepted, without a place: the reader of the file adds it
};

template <class Value, class Failure = Error>
class [[nodiscard]] Result {
  public:
    Result(Value value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Failure failure) : state_(std::in_place_index<1>, std::move(failure)) {}

    explicit operator bool() const { return state_.index() == 0; }
    // The value; asking a failure for it is the caller's mistake.
    const Value& operator*() const& { return assert(*this), *std::get_if<0>(&state_); }
    Value& operator*() & { return assert(*this), *std::get_if<0>(&state_); }
    Value&& operator*() && { return assert(*this), std::move(*std::get_if<0>(&state_)); }
    const Value* operator->() const { return &**this; }
    Value* operator->() { return &**this; }
    const Failure& error() const { return assert(!*this), *std::get_if<1>(&state_); }

  private:
    std::variant<Value, Failure> state_;
};

}  // namespace relevo::pipeline
