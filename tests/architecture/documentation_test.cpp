// What the documentation points at exists.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GRAZE_SOURCE_DIR;

std::vector<fs::path> pages() {
  std::vector<fs::path> list;
  for (const fs::directory_entry& entry : fs::directory_iterator(kRoot))
    if (entry.path().extension() == ".md") list.push_back(entry.path());
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / "docs"))
    if (entry.path().extension() == ".md") list.push_back(entry.path());
  EXPECT_GT(list.size(), 10u);
  return list;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Every match's first group.
std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> list;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    list.push_back((*at)[1]);
  return list;
}

// A sketch names files that are still to be written.
bool is_sketch(const fs::path& page) {
  return page.filename().string().find("_sketch_") != std::string::npos;
}

TEST(Documentation, LinksLeadToFiles) {
  for (const fs::path& page : pages())
    for (const std::string& link : found(text_of(page), R"(\]\(([\w./-]+[.]\w+)(?:#[^)]*)?\))"))
      EXPECT_TRUE(fs::exists(page.parent_path() / link)) << page << " links " << link;
}

TEST(Documentation, NamesSourceFilesThatAreThere) {
  std::set<std::string> rooms;
  for (const fs::directory_entry& entry : fs::directory_iterator(kRoot / "lib"))
    rooms.insert(entry.path().filename().string());
  std::size_t checked = 0;
  for (const fs::path& page : pages()) {
    if (is_sketch(page)) continue;
    for (const std::string& name : found(text_of(page), R"(`(?:lib/|graze/)?(\w+/\w+\.[hc]pp)`)")) {
      if (!rooms.count(name.substr(0, name.find('/')))) continue;
      ++checked;
      EXPECT_TRUE(fs::exists(kRoot / "lib" / name)) << page << " names " << name;
    }
  }
  EXPECT_GT(checked, 50u);
}

TEST(Documentation, GalleryShowsWhatItsCommandsDraw) {
  const std::string page = text_of(kRoot / "docs" / "gallery.md");
  const std::vector<std::string> shown = found(page, R"(\]\(pictures/([\w.]+)\))");
  EXPECT_GT(shown.size(), 8u);
  EXPECT_EQ(shown, found(page, R"(\n    build/graze [^\n]* --plot ([\w.]+)\n)"));
}

TEST(Documentation, DecisionsAreNumberedWithoutGaps) {
  std::set<int> numbers;
  for (const fs::directory_entry& entry : fs::directory_iterator(kRoot / "docs" / "decisions"))
    EXPECT_TRUE(numbers.insert(std::stoi(entry.path().filename().string())).second) << entry.path();
  ASSERT_FALSE(numbers.empty());
  EXPECT_EQ(static_cast<std::size_t>(*numbers.rbegin()), numbers.size());
}

}  // namespace
