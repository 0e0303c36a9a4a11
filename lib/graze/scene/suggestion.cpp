#include "graze/scene/suggestion.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace graze {
namespace {

// Words longer than any name are close to none, and the distance costs their product.
constexpr std::size_t kLongestWord = 60;

std::string plain(const std::string& word) {
  std::string result;
  for (const char c : word) {
    result += c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

// Insertions, deletions, changes and swaps of neighbours between a and b (optimal string
// alignment), three rows at a time.
int distance(const std::string& a, const std::string& b) {
  std::vector<int> before(b.size() + 1, 0);
  std::vector<int> above(b.size() + 1, 0);
  std::vector<int> row(b.size() + 1, 0);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    above[j] = static_cast<int>(j);
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above[b.size()];
}

std::string last_part(const std::string& name) { return name.substr(name.rfind('.') + 1); }

// The only name for which `fits` holds, or "".
template <typename Fits>
std::string only_name(const std::vector<std::string>& names, Fits fits) {
  std::string result;
  for (const std::string& name : names) {
    if (fits(name)) {
      if (!result.empty()) {
        return "";
      }
      result = name;
    }
  }
  return result;
}

}  // namespace

std::string closest_name(const std::string& word, const std::vector<std::string>& names) {
  if (word.empty() || word.size() > kLongestWord) {
    return "";
  }
  const std::string meant = plain(word);
  // In a short word two slips leave nothing to recognise.
  int least = meant.size() <= 3 ? 2 : 3;
  std::string closest;
  for (const std::string& name : names) {
    const int slips = distance(meant, plain(name));
    if (slips < least && static_cast<std::size_t>(slips) < name.size()) {
      least = slips;
      closest = name;
    }
  }
  if (closest.empty() && meant.size() >= 3) {
    closest = only_name(names, [&](const std::string& name) {
      return plain(name).compare(0, meant.size(), meant) == 0;
    });
  }
  if (closest.empty() && meant.size() >= 3) {
    closest = only_name(names, [&](const std::string& name) {
      return distance(meant, plain(last_part(name))) <= 1;
    });
  }
  return closest;
}

std::string joined(const std::vector<std::string>& words, const std::string& last) {
  std::string result;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) {
      result += k + 1 == words.size() ? " " + last + " " : ", ";
    }
    result += words[k];
  }
  return result;
}

}  // namespace graze
