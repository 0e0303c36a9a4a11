#include "graze/record/file/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "graze/base/errors.hpp"
#include "graze/record/file/checksum.hpp"
#include "graze/record/file/detail/fields.hpp"

namespace graze {
namespace {

constexpr const char* kHead = "head";
constexpr const char* kEnd = "end";
constexpr std::size_t kChecksum = 8;  // hexadecimal digits
constexpr std::size_t kChunk = 1 << 20;

std::string line_of(const std::string& name, const std::string& text) {
  const std::string body = name + "\t" + text;
  return checksum(body) + " " + body + "\n";
}

}  // namespace

Journal::Journal(std::filesystem::path file, int descriptor)
    : file_(std::move(file)), descriptor_(descriptor) {}

Journal::~Journal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Journal::Journal(Journal&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      head_(std::move(other.head_)),
      has_head_(other.has_head_),
      has_ended_(other.has_ended_),
      end_(other.end_),
      names_(std::move(other.names_)),
      places_(std::move(other.places_)) {}

void Journal::fail(const char* what) const {
  throw FileError(fmt::format("{}: cannot {}: {}", file_.string(), what, std::strerror(errno)));
}

Journal Journal::writable(const std::filesystem::path& file) {
  // It may overwrite a file of that name, but not follow a link of that name.
  Journal journal(file, ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (journal.descriptor_ < 0 && errno == ELOOP)
    throw FileError(file.string() + ": cannot write: it is a symbolic link");
  if (journal.descriptor_ < 0) journal.fail("write");
  struct stat status {};
  if (::fstat(journal.descriptor_, &status) != 0) journal.fail("write");
  if (!S_ISREG(status.st_mode) || status.st_nlink != 1)
    throw FileError(file.string() + ": cannot write: it is no file of its own");
  // The lock ends with the program in any case. Where the disk supports no locks there are none.
  if (::flock(journal.descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw FileError(file.string() + ": another run is writing this journal");
  return journal;
}

Journal Journal::begin(const std::filesystem::path& file, const JournalHead& head,
                       Unfinished unfinished) {
  Journal journal = writable(file);
  journal.read();
  if (unfinished == Unfinished::kRefused) journal.refuse_unfinished(head);
  journal.start(head);
  return journal;
}

void Journal::refuse_unfinished(const JournalHead& head) const {
  if (!has_head_ || has_ended_ || names_.empty()) return;
  require_sound(head_, file_.string());
  require_same_work(head_, head, file_.string());
  const std::size_t kept = head_.pieces - missing_pieces(head_, {this}).size();
  throw InputError(
      fmt::format("{}: the work in it is not finished, {} of {} {}s are done; --resume goes on "
                  "with it, --restart-work throws it away",
                  file_.string(), kept, head_.share.count(head_.pieces, head_.block), head_.piece));
}

void Journal::start(const JournalHead& head) {
  names_.clear();
  places_.clear();
  has_ended_ = false;
  head_ = head;
  cut_off(0);
  write(line_of(kHead, head_text(head)));
  has_head_ = true;
}

Journal Journal::resume(const std::filesystem::path& file, const JournalHead& head) {
  Journal journal = writable(file);
  journal.read();
  if (!journal.has_head_) {
    journal.start(head);
    return journal;
  }
  require_sound(journal.head_, file.string());
  require_same_work(journal.head_, head, file.string());
  journal.cut_off(journal.end_);
  return journal;
}

Journal Journal::open(const std::filesystem::path& file) {
  Journal journal(file, ::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (journal.descriptor_ < 0) journal.fail("read");
  journal.read();
  if (!journal.has_head_)
    throw InputError(file.string() + ": it is no journal of graze, or lacks its first line");
  require_sound(journal.head_, file.string());
  return journal;
}

// Anything after the last whole line was being written when the program ended.
void Journal::cut_off(std::size_t at) {
  if (::ftruncate(descriptor_, static_cast<off_t>(at)) != 0) fail("write");
  end_ = at;
}

void Journal::read() {
  std::string text;  // from `first` in the file on
  std::size_t first = 0;
  for (;;) {
    const std::size_t old = text.size();
    text.resize(old + kChunk);
    const ssize_t count =
        ::pread(descriptor_, text.data() + old, kChunk, static_cast<off_t>(first + old));
    if (count < 0 && errno != EINTR) fail("read");
    text.resize(old + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
      take_line(std::string_view(text).substr(begin, end - begin), first + begin);
    text.erase(0, begin);
    first += begin;
    if (count == 0) return;
  }
}

void Journal::take_line(std::string_view line, std::size_t at) {
  const std::size_t tab = line.find('\t');
  if (tab == std::string_view::npos || tab <= kChecksum) return;
  const std::string_view body = line.substr(kChecksum + 1);
  if (checksum(body) != line.substr(0, kChecksum)) return;
  const std::string name(line.substr(kChecksum + 1, tab - kChecksum - 1));
  if (at == 0) has_head_ = name == kHead && read_head(std::string(line.substr(tab + 1)), head_);
  if (!has_head_) return;
  end_ = at + line.size() + 1;
  if (name == kEnd)
    has_ended_ = true;
  else if (name != kHead)
    note(name, {at + tab + 1, line.size() - tab - 1});
}

void Journal::note(const std::string& name, Place place) {
  if (places_.emplace(name, place).second) names_.push_back(name);
}

bool Journal::has(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  return places_.count(name) > 0;
}

std::optional<std::string> Journal::find(const std::string& name) const {
  Place place;
  {
    const std::lock_guard lock(mutex_);
    const auto found = places_.find(name);
    if (found == places_.end()) return {};
    place = found->second;
  }
  std::string text(place.size, '\0');
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::pread(descriptor_, text.data() + done, text.size() - done,
                                  static_cast<off_t>(place.at + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail("read");
    done += static_cast<std::size_t>(count);
  }
  return text;
}

void Journal::add(const std::string& name, const std::string& text) {
  const std::string line = line_of(name, text);
  const std::lock_guard lock(mutex_);
  const std::size_t at = end_ + line.size() - 1 - text.size();
  write(line);
  note(name, {at, text.size()});
}

void Journal::end() {
  const std::lock_guard lock(mutex_);
  if (!has_ended_) write(line_of(kEnd, ""));
  has_ended_ = true;
}

void Journal::write(const std::string& line) {
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t count = ::pwrite(descriptor_, line.data() + done, line.size() - done,
                                   static_cast<off_t>(end_ + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("write");
    done += static_cast<std::size_t>(count);
  }
  end_ += line.size();
}

std::vector<std::size_t> missing_pieces(const JournalHead& head,
                                        const std::vector<const Journal*>& journals) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < head.pieces; ++i) {
    const std::string name = piece_name(head.piece, i);
    if (std::none_of(journals.begin(), journals.end(),
                     [&](const Journal* journal) { return journal->has(name); }))
      missing.push_back(i);
  }
  return missing;
}

std::string piece_text(const SweepRow& row) { return value_text(row); }
std::string piece_text(const SettledCell& cell) { return value_text(cell); }
std::string piece_text(const ValueRun& run) { return value_text(run); }
std::string piece_text(const ComparedCell& cell) { return value_text(cell); }

bool read_piece(const std::string& text, SweepRow& row) { return read_value(text, row); }
bool read_piece(const std::string& text, SettledCell& cell) { return read_value(text, cell); }
bool read_piece(const std::string& text, ValueRun& run) { return read_value(text, run); }
bool read_piece(const std::string& text, ComparedCell& cell) { return read_value(text, cell); }

}  // namespace graze
