// The arrays are in version 1 of the .npy format (numpy.lib.format); they stand uncompressed, so
// that the archive needs no more of the zip format (APPNOTE.TXT, 4.3) than its records, in their
// 64-bit form: columns and archives may exceed 4 GiB.
#include "graze/record/file/numpy_archive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/crc.hpp>
#include <cstdint>
#include <utility>

namespace graze {
namespace {

static_assert(std::endian::native == std::endian::little, "'<f8' is how numbers lie in memory");

constexpr std::size_t kBlock = std::size_t{1} << 20;         // numbers
constexpr std::size_t kArchivePiece = std::size_t{1} << 20;  // bytes

// The header of an array; its numbers begin at a multiple of 64 bytes.
std::string array_head(std::size_t count) {
  constexpr std::size_t kBefore = 10, kAligned = 64;
  std::string text =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({},), }}", count);
  text.append(kAligned - 1 - (kBefore + text.size()) % kAligned, ' ');
  text += '\n';
  const std::size_t size = text.size();
  return std::string("\x93NUMPY\1\0", 8) + static_cast<char>(size & 0xff) +
         static_cast<char>(size >> 8) + text;
}

// Numbers one after another, the lowest byte first.
class Packed {
 public:
  template <int bytes>
  Packed& add(std::uint64_t value) {
    for (int i = 0; i < bytes; ++i) text_ += static_cast<char>(value >> (8 * i) & 0xff);
    return *this;
  }
  Packed& add(std::string_view text) {
    text_ += text;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

struct ArchiveMember {
  std::string name;
  std::uint64_t size, sum, begin;
};

constexpr std::uint64_t kElsewhere = 0xffffffff;  // the number stands in the 64-bit part
constexpr std::uint64_t kVersion = 45;            // the first with 64 bits
constexpr std::uint64_t kDate = 1 << 5 | 1;       // 1 January 1980, as NumPy dates its own

// The fields that both records of a member share.
Packed& add_description(const ArchiveMember& member, std::uint64_t extra, Packed& record) {
  constexpr std::uint64_t kNoFlags = 0, kStored = 0, kTime = 0;
  record.add<2>(kVersion).add<2>(kNoFlags).add<2>(kStored).add<2>(kTime).add<2>(kDate);
  record.add<4>(member.sum).add<4>(kElsewhere).add<4>(kElsewhere);
  return record.add<2>(member.name.size()).add<2>(extra);
}

std::string local_head(const ArchiveMember& member) {
  Packed record;
  record.add<4>(0x04034b50);
  add_description(member, 20, record).add(member.name);
  return record.add<2>(1).add<2>(16).add<8>(member.size).add<8>(member.size).text();
}

std::string directory_entry(const ArchiveMember& member) {
  Packed record;
  record.add<4>(0x02014b50).add<2>(kVersion);
  // No comment, first disk, no attributes.
  add_description(member, 28, record).add<2>(0).add<2>(0).add<2>(0).add<4>(0).add<4>(kElsewhere);
  record.add(member.name).add<2>(1).add<2>(24);
  return record.add<8>(member.size).add<8>(member.size).add<8>(member.begin).text();
}

std::string directory_end(std::uint64_t members, std::uint64_t size, std::uint64_t begin) {
  constexpr std::uint64_t kRest = 44;  // of the first record
  Packed record;
  record.add<4>(0x06064b50).add<8>(kRest).add<2>(kVersion).add<2>(kVersion).add<4>(0).add<4>(0);
  record.add<8>(members).add<8>(members).add<8>(size).add<8>(begin);
  record.add<4>(0x07064b50).add<4>(0).add<8>(begin + size).add<4>(1);
  record.add<4>(0x06054b50).add<2>(0).add<2>(0).add<2>(0xffff).add<2>(0xffff);
  return record.add<4>(kElsewhere).add<4>(kElsewhere).add<2>(0).text();
}

}  // namespace

NumpyArchive::NumpyArchive(const std::filesystem::path& file, std::vector<std::string> columns)
    : columns_(std::move(columns)),
      archive_(file),
      blocks_(file.parent_path()),
      block_rows_(std::max<std::size_t>(1, kBlock / columns_.size())) {
  rows_.reserve(block_rows_ * columns_.size());
}

double* NumpyArchive::add() {
  if (rows_.size() == block_rows_ * columns_.size()) put_away_block();
  ++count_;
  rows_.resize(rows_.size() + columns_.size());
  return rows_.data() + rows_.size() - columns_.size();
}

void NumpyArchive::put_away_block() {
  std::vector<double> column(rows_.size() / columns_.size());
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = rows_[i * columns_.size() + j];
    blocks_.append({reinterpret_cast<const char*>(column.data()), column.size() * sizeof(double)});
  }
  rows_.clear();
}

void NumpyArchive::read_column(std::size_t column,
                               const std::function<void(std::string_view)>& use) {
  for (std::size_t first = 0; first < count_; first += block_rows_) {
    const std::size_t rows = std::min(block_rows_, count_ - first);
    const std::size_t begin = (first * columns_.size() + column * rows) * sizeof(double);
    const std::size_t end = begin + rows * sizeof(double);
    for (std::size_t at = begin; at < end; at += kArchivePiece)
      use(blocks_.piece(at, std::min(kArchivePiece, end - at)));
  }
}

PendingFile NumpyArchive::finished() {
  put_away_block();
  const std::string head = array_head(count_);
  std::vector<ArchiveMember> members;
  std::uint64_t size = 0;
  const auto write = [&](std::string_view bytes) {
    archive_.append(bytes);
    size += bytes.size();
  };
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    // The checksum is written before its contents.
    boost::crc_32_type sum;
    sum.process_bytes(head.data(), head.size());
    read_column(j, [&](std::string_view bytes) { sum.process_bytes(bytes.data(), bytes.size()); });
    members.push_back(
        {columns_[j] + ".npy", head.size() + count_ * sizeof(double), sum.checksum(), size});
    write(local_head(members.back()));
    write(head);
    read_column(j, write);
  }
  const std::uint64_t begin = size;
  for (const ArchiveMember& member : members) write(directory_entry(member));
  write(directory_end(members.size(), size - begin, begin));
  return std::move(archive_);
}

}  // namespace graze
