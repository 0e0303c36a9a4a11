#include "graze/record/file/checksum.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

namespace graze {

void Checksum::add(std::string_view text) {
  // Continues with the checksum of the text so far.
  boost::crc_32_type crc;
  crc.reset(remainder_);
  crc.process_bytes(text.data(), text.size());
  remainder_ = crc.get_interim_remainder();
}

std::string Checksum::text() const {
  boost::crc_32_type crc;
  crc.reset(remainder_);
  return fmt::format("{:08x}", crc.checksum());
}

std::string checksum(std::string_view text) {
  Checksum sum;
  sum.add(text);
  return sum.text();
}

}  // namespace graze
