#include "graze/report/picture/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "graze/base/errors.hpp"

namespace graze {

void check_picture_name(const std::string& file, const char* allowed) {
  const std::filesystem::path path(file);
  const std::string extension = path.extension().string();
  if (extension == ".html")
    throw InputError(
        fmt::format("{}: this is not drawn as a page; the name ends in {}", file, allowed));
  if (extension != ".svg" && extension != ".png" && extension != ".pdf")
    throw InputError(fmt::format("{}: the name of a picture ends in {}", file, allowed));
  const auto control = [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; };
  if (std::any_of(file.begin(), file.end(), control))
    throw InputError("the name of a picture cannot hold control characters");
  // A leading < in the script's name would make gnuplot run a program: `gnuplot '<x.gp'` runs x.gp.
  const std::string name = path.filename().string();
  if (name.front() == '<' || name.front() == '|')
    throw InputError(
        fmt::format("{}: the name of a picture cannot begin with {}, after which gnuplot takes it "
                    "for a command",
                    file, name.front()));
}

}  // namespace graze
