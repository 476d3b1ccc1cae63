// From a scene to what its golden keeps.
#pragma once
#include "tests/golden/plain.hpp"
#include "tests/golden/product.hpp"
#include "tests/golden/subject.hpp"

namespace relevo::golden {

// What the machine makes of the subject.
Product product_of(Stage stage, const Subject& subject);

// The same by the plain machine, with its mistakes. Not for shaded colours: `subject` must be unlit.
Product plain_product_of(Stage stage, const Subject& subject, const Rules& rules);
bool has_plain_form(Stage stage, const Subject& subject);

// The colours cut off at the next lower 1/255 instead of rounded (raw output).
Product truncated_product_of(const Subject& subject);

}  // namespace relevo::golden
