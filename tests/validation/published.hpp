// The table of published cases, data/validation/published.toml.
//
// A source has a title and a link; a case a scene, a command and the numbers that the source prints
// of it. A number is kept as it is printed, since its last digit tells how exact it is meant. Where
// it is not exact to that digit the table has the number of an independent computation beside it
// (a script of tests/reference/validation), and the sentence that says who errs. Where the source
// gives a formula or the system alone, there is only the computed number.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace graze::support {

struct PublishedValue {
  std::string what;                        // "time of impact 1, s"
  std::string at;                          // path in the result document, see result_at()
  std::optional<std::string> published{};  // as printed
  std::string formula{};                   // else: what the source gives in place of a number
  // In place of one unit of the last digit printed: relative, or in the number's own unit.
  std::optional<double> within{};
  bool absolute = false;
  std::optional<std::string> independent{};
  std::string script{};      // that computes it, from the project's root
  std::string printed_as{};  // the name that the script prints before it; required of a number with
                             // so few digits that any other may be the same
  std::string because{};     // who errs and by what, or why the tolerance is another

  // What Graze is held to, and by how much it may be off, in the number's own unit.
  double expected() const { return std::stod(independent ? *independent : *published); }
  double allowed() const;
};

struct PublishedCase {
  std::string name, title, source, scene;  // scene: a file of data/validation
  std::string command;                     // with its options, without the scene
  std::vector<PublishedValue> values;
};

struct PublishedSource {
  std::string key, title, link;  // no link where there is none
};

struct PublishedTable {
  std::vector<PublishedSource> sources;
  std::vector<PublishedCase> cases;  // those of one source together

  const PublishedSource& source_of(const PublishedCase& one) const;
};

// Throws InputError (file:line:column) where the table does not say what it must.
PublishedTable published_table(const std::filesystem::path& file);

// One unit of the last digit that a number has as it is written: 1e-3 of "0.352", 1e2 of "3.5e3".
double last_digit(const std::string& number);

}  // namespace graze::support
