// "Did you mean": the known word that is nearest to a misspelt one.
//
// Source: V. I. Levenshtein, "Binary codes capable of correcting deletions, insertions and reversals", 1966;
// with neighbours that changed places counted as one slip (F. J. Damerau, 1964), the commonest one of a
// keyboard.
#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relevo::io {

// How many slips (a letter too many, too few, wrong, or two neighbours swapped) lead from one word to the
// other.
//   d(i, j) = min { d(i-1, j) + 1, d(i, j-1) + 1, d(i-1, j-1) + [a_i != b_j], d(i-2, j-2) + 1 when swapped }
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1] ? 1 : 0)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
    }
    return row[b.size()];
}

// ", did you mean 'x'?" when a known word is close (a slip for every three letters, at least one), else "".
// Of equally close words the first one in the list is named.
inline std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
    constexpr std::size_t longest = 64;
    if (word.size() > longest) return "";
    std::string_view best;
    std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string_view candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < best_distance && distance < candidate.size())
            best = candidate, best_distance = distance;
    }
    return best.empty() ? "" : ", did you mean '" + std::string(best) + "'?";
}

}  // namespace relevo::io
