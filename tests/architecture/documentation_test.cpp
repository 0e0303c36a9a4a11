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

// A reader finds every page from docs/index.md, and every decision from their own list.
TEST(Documentation, IndexNamesEveryPage) {
  const fs::path docs = kProjectRoot / "docs";
  const auto named_in = [&](const char* list) {
    const std::vector<std::string> links =
        found(text_of(docs / list), R"(\]\(([\w./-]+[.]md)(?:#[^)]*)?\))");
    return std::set<std::string>(links.begin(), links.end());
  };
  const std::set<std::string> pages = named_in("index.md"),
                              decisions = named_in("decisions/README.md");
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(docs)) {
    const std::string page = fs::relative(entry.path(), docs).generic_string();
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".md" || page == "index.md") continue;
    const bool is_decision = page.starts_with("decisions/") && name != "README.md";
    EXPECT_TRUE(is_decision ? decisions.count(name) : pages.count(page)) << page << " is not named";
  }
}

// A record that another one replaces is folded into it, so that each one holds, and has a number of
// its own.
TEST(Documentation, DecisionsHold) {
  std::set<int> numbers;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(kProjectRoot / "docs" / "decisions")) {
    if (entry.path().filename() == "README.md") continue;
    EXPECT_EQ(text_of(entry.path()).find("Superseded"), std::string::npos) << entry.path();
    EXPECT_TRUE(numbers.insert(std::stoi(entry.path().filename().string())).second) << entry.path();
  }
  EXPECT_GT(numbers.size(), 20u);
}

}  // namespace
