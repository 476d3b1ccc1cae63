// The inspection points of relief textures, r01 to r18: what each of them keeps of small scenes, and how
// nearly it must be the same.
//
//   r01 source          colour, normal, coverage, depth       r10 offset map   sources; channels fetched by
//   it r02 codes           8-bit depths and their error          r11 polygon      window and square on the
//   screen r03 order           epipole, rank of painting             r12 final        lit and unlit, in a
//   scene r04 displacement    du, dv                                r13 truth        rays, 16 samples a pixel
//   r05 rows            after the horizontal pass             r14 difference   of the two, and the error set
//   r06 resamplers      the four of them                      r15 depth        cut by another object
//   r07 mesh            their difference to the mesh          r16 inverse      8 to 256 slices, 32 + 8
//   r08 kinds           sampled, filled, across; overdraw     r17 thickness    none, some, a back layer
//   r09 wrong order     beside the right one                  r18 six faces    captures, contributions
#pragma once
#include <vector>

#include "tests/golden/exhibit.hpp"

namespace relevo::golden {

std::vector<Exhibit> relief_exhibits();
std::vector<MistakeName> relief_mistake_names();

}  // namespace relevo::golden
