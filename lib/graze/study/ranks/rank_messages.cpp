#include "graze/study/ranks/rank_messages.hpp"

#include <cstring>

namespace graze {
namespace {

void put(std::string& bytes, std::uint64_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void put(std::string& bytes, const std::string& text) {
  put(bytes, static_cast<std::uint64_t>(text.size()));
  bytes += text;
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    const std::string_view part = take(sizeof value);
    if (good_) std::memcpy(&value, part.data(), sizeof value);
    return value;
  }
  // The number of items that follow, each of at least so many bytes.
  std::uint64_t count(std::size_t least) {
    const std::uint64_t count = number();
    good_ = good_ && count <= bytes_.size() / least;
    return good_ ? count : 0;
  }
  std::string text() { return std::string(take(count(1))); }
  bool is_at_end() const { return good_ && bytes_.empty(); }

 private:
  std::string_view take(std::size_t size) {
    good_ = good_ && size <= bytes_.size();
    if (!good_) return {};
    const std::string_view part = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return part;
  }

  std::string_view bytes_;
  bool good_ = true;
};

}  // namespace

std::string bytes_of(const RankMessage& message) {
  std::string bytes;
  put(bytes, static_cast<std::uint64_t>(message.kind));
  put(bytes, message.numbers.size());
  for (const std::uint64_t number : message.numbers) put(bytes, number);
  put(bytes, message.names.size());
  for (const std::string& name : message.names) put(bytes, name);
  put(bytes, message.texts.size());
  for (const auto& [name, text] : message.texts) put(bytes, name), put(bytes, text);
  return bytes;
}

std::optional<RankMessage> read_message(std::string_view bytes) {
  constexpr std::size_t kNumber = sizeof(std::uint64_t);
  Reader reader(bytes);
  RankMessage message;
  const std::uint64_t kind = reader.number();
  if (kind > static_cast<std::uint64_t>(RankMessage::Kind::kOver)) return {};
  message.kind = static_cast<RankMessage::Kind>(kind);
  for (std::uint64_t left = reader.count(kNumber); left > 0; --left)
    message.numbers.push_back(reader.number());
  for (std::uint64_t left = reader.count(kNumber); left > 0; --left)
    message.names.push_back(reader.text());
  for (std::uint64_t left = reader.count(2 * kNumber); left > 0; --left) {
    std::string name = reader.text();
    message.texts.emplace_back(std::move(name), reader.text());
  }
  if (!reader.is_at_end()) return {};
  return message;
}

}  // namespace graze
