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

const fs::path kProjectRoot = GRAZE_SOURCE_DIR;

std::vector<fs::path> pages() {
  std::vector<fs::path> list;
  for (const fs::directory_entry& entry : fs::directory_iterator(kProjectRoot))
    if (entry.path().extension() == ".md") list.push_back(entry.path());
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kProjectRoot / "docs"))
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

// A merge that was not finished is no page.
TEST(Documentation, HoldsNoMarksOfAMerge) {
  for (const fs::path& page : pages())
    for (const char* mark : {"\n<<<<<<< ", "\n=======\n", "\n>>>>>>> "})
      EXPECT_EQ(text_of(page).find(mark), std::string::npos) << page << " holds" << mark;
}

TEST(Documentation, NamesSourceFilesThatAreThere) {
  std::set<std::string> rooms;
  for (const fs::directory_entry& entry : fs::directory_iterator(kProjectRoot / "lib" / "graze"))
    rooms.insert(entry.path().filename().string());
  std::size_t checked = 0;
  for (const fs::path& page : pages()) {
    if (is_sketch(page)) continue;
    for (const std::string& name :
         found(text_of(page), R"(`(?:lib/graze/|graze/)?((?:\w+/)+\w+\.[hc]pp)`)")) {
      if (!rooms.count(name.substr(0, name.find('/')))) continue;
      ++checked;
      EXPECT_TRUE(fs::exists(kProjectRoot / "lib" / "graze" / name)) << page << " names " << name;
    }
  }
  EXPECT_GT(checked, 50u);
}

// Whoever uses the library finds every header that is installed, and none that is not.
TEST(Documentation, ListsThePublicHeaders) {
  std::set<std::string> there;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(kProjectRoot / "lib" / "graze"))
    if (entry.path().extension() == ".hpp" && entry.path().parent_path().filename() != "detail")
      there.insert(fs::relative(entry.path(), kProjectRoot / "lib").generic_string());
  std::set<std::string> listed;
  for (const std::string& name :
       found(text_of(kProjectRoot / "docs" / "library.md"), R"(`(graze/(?:\w+/)+\w+\.hpp)`)"))
    listed.insert(name);
  EXPECT_EQ(listed, there);
}

TEST(Documentation, GalleryShowsWhatItsCommandsDraw) {
  const std::string page = text_of(kProjectRoot / "docs" / "gallery.md");
  const std::vector<std::string> shown = found(page, R"(\]\(pictures/([\w.]+)\))");
  EXPECT_GT(shown.size(), 8u);
  EXPECT_EQ(shown, found(page, R"(\n    build/graze [^\n]* --plot ([\w.]+)\n)"));
}

// The README's first command builds the program alone.
TEST(Documentation, TellsHowTheExamplesItNamesAreBuilt) {
  std::size_t named = 0;
  for (const fs::path& page : pages()) {
    const std::string text = text_of(page);
    if (text.find("build/tests/example_") == std::string::npos) continue;
    ++named;
    EXPECT_EQ(found(text, "cmake --preset release (-DGRAZE_TESTS=ON) && cmake --build").size(), 1u)
        << page;
    const std::vector<std::string> targets = found(text, R"(--target ((?:example_\w+ ?)+)`)");
    for (const std::string& name : found(text, R"(build/tests/(example_\w+))"))
      EXPECT_TRUE(!targets.empty() && (targets[0] + " ").find(name + " ") != std::string::npos)
          << page << " names " << name;
  }
  EXPECT_GE(named, 3u);
}

// What a test measures shall not change what is under version control.
TEST(Documentation, IsNotWrittenByRunningTheTests) {
  const std::string script = text_of(kProjectRoot / "tests" / "run.sh");
  const std::vector<std::string> commands = found(script, R"(\n *([^#\n][^\n]*))");
  EXPECT_GT(commands.size(), 10u);
  for (const std::string& command : commands)
    EXPECT_EQ(command.find("docs"), std::string::npos) << command;
}

// A reader finds every page from docs/index.md.
TEST(Documentation, IndexNamesEveryPage) {
  const fs::path docs = kProjectRoot / "docs";
  const std::vector<std::string> links =
      found(text_of(docs / "index.md"), R"(\]\(([\w./-]+[.]md)(?:#[^)]*)?\))");
  const std::set<std::string> named(links.begin(), links.end());
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(docs)) {
    const std::string page = fs::relative(entry.path(), docs).generic_string();
    if (entry.path().extension() != ".md" || page == "index.md") continue;
    EXPECT_TRUE(named.count(page)) << "docs/index.md does not name " << page;
  }
}

// A record that does not hold any more says so below its title, and where to read on.
TEST(Documentation, SupersededDecisionsLinkALaterOne) {
  const std::regex form(R"(# [^\n]*\n\nSuperseded (?:in part )?by )"
                        R"(\[(\d+)\]\(\d+_\w+\.md\)[^\n]*: [^\n]+)");
  std::size_t superseded = 0;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(kProjectRoot / "docs" / "decisions")) {
    const std::string text = text_of(entry.path());
    if (text.find("\nSuperseded") == std::string::npos) {
      EXPECT_FALSE(is_sketch(entry.path())) << entry.path() << " is a sketch of what was built";
      continue;
    }
    ++superseded;
    std::smatch match;
    ASSERT_TRUE(std::regex_search(text, match, form, std::regex_constants::match_continuous))
        << entry.path();
    EXPECT_GT(std::stoi(match[1]), std::stoi(entry.path().filename().string())) << entry.path();
  }
  EXPECT_GT(superseded, 5u);
}

TEST(Documentation, DecisionsAreNumberedWithoutGaps) {
  std::set<int> numbers;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(kProjectRoot / "docs" / "decisions"))
    EXPECT_TRUE(numbers.insert(std::stoi(entry.path().filename().string())).second) << entry.path();
  ASSERT_FALSE(numbers.empty());
  EXPECT_EQ(static_cast<std::size_t>(*numbers.rbegin()), numbers.size());
}

}  // namespace
