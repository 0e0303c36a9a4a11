// Text of any length on its way to a sink, of which memory holds only a small part.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "graze/record/file/open_file.hpp"

namespace graze {

// Takes a text piece by piece.
using TextSink = std::function<void(std::string_view)>;

// A text that is collected, in memory while it is short, then in a file without a name, which
// disappears with the program. Throws FileError.
class Spool {
 public:
  // Long texts are put into the folder, or among the temporary files.
  Spool();
  explicit Spool(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void append(std::string_view text);
  bool empty() const { return size_ == 0; }
  // Passes all of it to the sink, as often as called.
  void read(const TextSink& sink);
  // The bytes from `position` on, which must be there.
  std::string piece(std::size_t position, std::size_t size);

 private:
  std::filesystem::path folder_;
  std::size_t size_ = 0;
  std::string short_;             // all of it while there is no file
  std::optional<OpenFile> file_;  // all of it, once there is
};

// A text with a long middle.
struct Document {
  Document() = default;
  // Not explicit: a text is a document.
  Document(std::string whole)  // NOLINT(google-explicit-constructor)
      : head(std::move(whole)) {}
  Document(std::string before, Spool& between, std::string after)
      : head(std::move(before)), middle(&between), tail(std::move(after)) {}

  void read(const TextSink& sink) const;

  std::string head;
  Spool* middle = nullptr;  // not owned
  std::string tail;
};

}  // namespace graze
