#include "graze/report/page/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "graze/base/errors.hpp"
#include "graze/record/file/files.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/page/detail/page_looks.hpp"
#include "graze/report/page/detail/page_template.hpp"
#include "graze/report/picture/pictures.hpp"
#include "graze/report/text/shell_word.hpp"

namespace graze {
namespace {

constexpr std::string_view kDataMark = "<!--data-->";

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16 |
                                (left > 1 ? static_cast<std::uint32_t>(bytes[i + 1]) << 8 : 0U) |
                                (left > 2 ? static_cast<std::uint32_t>(bytes[i + 2]) : 0U);
    text += kDigits[group >> 18];
    text += kDigits[group >> 12 & 63];
    text += left > 1 ? kDigits[group >> 6 & 63] : '=';
    text += left > 2 ? kDigits[group & 63] : '=';
  }
  return text;
}

template <class Number>
Json packed_as(const char* kind, const std::vector<Number>& numbers) {
  static_assert(std::endian::native == std::endian::little, "browsers read little-endian arrays");
  std::vector<std::uint8_t> bytes(numbers.size() * sizeof(Number));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return {{kind, base64(bytes)}};
}

// As a script's text: nothing in it may end the script or begin a comment.
std::string script_text(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

std::string data_script(const char* id, const Json& json) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">", id) + script_text(json) +
         "</script>\n";
}

}  // namespace

Json packed(const std::vector<double>& numbers) { return packed_as("f64", numbers); }
Json packed(const std::vector<float>& numbers) { return packed_as("f32", numbers); }
Json packed(const std::vector<std::int32_t>& numbers) { return packed_as("i32", numbers); }
Json packed(const std::vector<std::uint8_t>& numbers) { return packed_as("u8", numbers); }

Json page_axis(const std::string& name, const std::string& si_unit, AxisRange range,
               double margin) {
  if (range.empty()) range.include(0.0);
  range.settle(margin);
  const AxisUnit unit = axis_unit(si_unit, std::max(std::abs(range.low), std::abs(range.high)));
  return {{"name", plain_text(name)},  {"unit", plain_text(unit.unit)},
          {"si", plain_text(si_unit)}, {"factor", unit.factor},
          {"low", range.low},          {"high", range.high}};
}

std::string page_command(const RunInfo& info, const std::string& command,
                         const std::vector<std::string>& more) {
  std::string text = "graze " + command + " " + shell_word(info.scene_file);
  for (const std::vector<std::string>* settings : {&info.settings, &more})
    for (const std::string& setting : *settings) text += " --set " + shell_word(setting);
  return text;
}

Json page_view(const RunInfo& info, const Outcome& outcome,
               const std::vector<std::string>& warnings, const std::vector<std::string>& notes) {
  Json view;
  view["head"] = document_head(info, outcome, warnings);
  const std::string set = fmt::format("{}", fmt::join(info.settings, ", "));
  view["subtitle"] =
      info.scene_title + (set.empty() || info.scene_title.empty() ? "" : " · ") + set;
  view["notes"] = notes;
  view["looks"] = page_looks();
  view["made"] = shell_command(info.arguments);
  return view;
}

void write_page_file(const std::string& file, const Json& view, const Json& orbits) {
  const std::string_view page = page_template();
  const std::size_t mark = page.find(kDataMark);
  PendingFile pending(file);
  pending.append(page.substr(0, mark));
  pending.append(data_script("view", view));
  pending.append(data_script("orbits", orbits));
  pending.append(page.substr(mark + kDataMark.size()));
  pending.sync();
  pending.commit();
}

bool is_page_name(const std::string& file) {
  return std::filesystem::path(file).extension() == ".html";
}

void check_picture_or_page_name(const std::string& file) {
  if (!is_page_name(file)) return check_picture_name(file, ".svg, .png, .pdf or .html");
  check_picture_name(std::filesystem::path(file).replace_extension(".svg").string());
  if (page_template().empty())
    throw InputError(fmt::format(
        "{}: this program was built without npm, so it has no page to draw; .svg, .png and .pdf "
        "are drawn",
        file));
}

}  // namespace graze
