// SHA-256 (FIPS 180-4), by which files and scenes are recognised.
#pragma once

#include <string>

namespace graze {

// The checksum of a text or of bytes, 64 hexadecimal digits.
std::string sha256(const std::string& text);

}  // namespace graze
