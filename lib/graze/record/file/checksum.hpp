// A checksum against damage of files: CRC-32.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace graze {

class Checksum {
 public:
  void add(std::string_view text);
  // Eight hexadecimal digits.
  std::string text() const;

 private:
  std::uint32_t remainder_ = 0xffffffff;
};

std::string checksum(std::string_view text);

}  // namespace graze
