// The accuracy table: one row for each place where the machine computes with less than exact arithmetic.
// `relevo list knobs --accuracy` prints it, a test measures every row.
#pragma once
#include <span>
#include <string_view>

namespace relevo::scene {

struct AccuracyRow {
    std::string_view name;       // what is approximated
    std::string_view reference;  // what it is measured against
    std::string_view domain;     // for which inputs the error holds
    double allowed_error;
    std::string_view unit;  // of allowed_error
    int instructions;       // a call, roughly
};

inline std::span<const AccuracyRow> accuracy_table() { return {}; }

}  // namespace relevo::scene
