#include <fmt/format.h>
#include <zip.h>

#include <memory>

#include "graze/base/errors.hpp"
#include "graze/fem/detail/numpy_array.hpp"
#include "graze/fem/detail/text_lines.hpp"

namespace graze {
namespace {

// More than any matrix that fits the memory; an archive may claim any size.
constexpr zip_uint64_t kLargestMember = zip_uint64_t(1) << 34;

struct Closing {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* member) const { zip_fclose(member); }
};

}  // namespace

std::map<std::string, std::string> zip_members(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string bytes = read_bytes(file);
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  const std::unique_ptr<zip_t, Closing> archive(
      source ? zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error) : nullptr);
  if (!archive) {
    if (source) zip_source_free(source);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw InputError(fmt::format("{}: it is no .npz archive, {}", name, reason));
  }
  std::map<std::string, std::string> members;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t about;
    const auto index = static_cast<zip_uint64_t>(i);
    if (zip_stat_index(archive.get(), index, 0, &about) != 0 || !(about.valid & ZIP_STAT_SIZE) ||
        !(about.valid & ZIP_STAT_NAME) || about.size > kLargestMember)
      throw InputError(fmt::format("{}: member {} of the archive cannot be read", name, i + 1));
    const std::unique_ptr<zip_file_t, Closing> member(zip_fopen_index(archive.get(), index, 0));
    std::string text;
    // Reads as much as there is: the size that the archive claims is not trusted.
    for (std::vector<char> piece(1 << 20); member;) {
      const zip_int64_t got = zip_fread(member.get(), piece.data(), piece.size());
      if (got <= 0) break;
      text.append(piece.data(), static_cast<std::size_t>(got));
      if (text.size() > about.size) break;
    }
    if (!member || text.size() != about.size)
      throw InputError(fmt::format("{}: member {} of the archive is damaged", name, about.name));
    members.emplace(about.name, std::move(text));
  }
  return members;
}

}  // namespace graze
