// The house rules that a compiler does not see: which room may know which, that no files know each
// other in a circle, which library stands where, and how long a file may be.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = GRAZE_SOURCE_DIR;

// Each room and the rooms directly above it; what those may use, it may use too.
const std::map<std::string, std::set<std::string>> kAbove = {
    {"base", {}},
    {"fem", {"base"}},
    {"scene", {"contact", "fem"}},
    {"structure", {"scene"}},
    {"contact", {"base"}},
    {"system", {"contact"}},
    {"assembly", {"structure", "system"}},
    {"flow", {"system"}},
    {"motion", {"flow"}},
    {"orbit", {"motion"}},
    {"continuation", {"base"}},
    {"bifurcation", {"orbit", "continuation", "assembly"}},
    {"study", {"bifurcation"}},
    {"fit", {"motion", "assembly"}},
    {"record", {"study", "fit"}},
    {"report", {"record"}},
};

std::set<std::string> allowed(const std::string& room) {
  std::set<std::string> rooms{room};
  for (const std::string& above : kAbove.at(room)) rooms.merge(allowed(above));
  return rooms;
}

std::vector<fs::path> sources(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const std::string extension = entry.path().extension().string();
    if (entry.is_regular_file() && (extension == ".cpp" || extension == ".hpp"))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  EXPECT_FALSE(files.empty()) << folder;
  return files;
}

std::vector<std::string> lines(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> list;
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

// What stands between <> or "" in a file's include directives.
std::vector<std::string> includes(const fs::path& file) {
  const std::string directive = "#include ";
  std::vector<std::string> list;
  for (const std::string& line : lines(file)) {
    const std::size_t at = line.find_first_not_of(" \t");
    if (at == std::string::npos || line.compare(at, directive.size(), directive) != 0) continue;
    const std::size_t open = line.find_first_of("<\"", at);
    const std::size_t close = line.find_first_of(">\"", open + 1);
    list.push_back(line.substr(open + 1, close - open - 1));
  }
  return list;
}

std::string name_of(const fs::path& file) { return fs::relative(file, kRoot).generic_string(); }

// Headers that are not installed lie in a folder of this name beside what they belong to.
bool is_internal(const fs::path& file) { return file.parent_path().filename() == "detail"; }

// Below lib/graze, as in an include: "flow/exact".
std::string folder_of(const fs::path& file) {
  const fs::path folder = is_internal(file) ? file.parent_path().parent_path() : file.parent_path();
  return fs::relative(folder, kRoot / "lib" / "graze").generic_string();
}

std::string room_of(const fs::path& file) {
  return fs::relative(file, kRoot / "lib" / "graze").begin()->string();
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

// A header and what it is written in: exact_flow.hpp and exact_flow.cpp are
// flow/exact/detail/exact_flow, and so is whatever *_impl.hpp says in its first line that it holds
// the definitions of exact_flow.hpp.
std::string module_of(const fs::path& file) {
  std::string name = file.stem().string();
  const auto ends_with = [&](const std::string& ending) {
    return name.size() > ending.size() &&
           name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  };
  // A file here, or as an include names it.
  const fs::path here = file.is_absolute() ? file : kRoot / "lib" / file;
  if (ends_with("_impl")) {
    const std::string first = lines(here.parent_path() / (name + ".hpp")).at(0);
    const std::string says = "// Definitions of ";
    EXPECT_TRUE(starts_with(first, says)) << name;
    name = first.substr(says.size(), first.find(".hpp") - says.size());
  } else if (ends_with("_extended")) {
    name.resize(name.size() - std::string("_extended").size());
  }
  return folder_of(here) + "/" + name;
}

TEST(Architecture, EveryRoomIsInTheTable) {
  for (const fs::directory_entry& entry : fs::directory_iterator(kRoot / "lib" / "graze")) {
    EXPECT_TRUE(entry.is_directory()) << entry.path();
    EXPECT_TRUE(kAbove.count(entry.path().filename().string())) << entry.path();
  }
}

TEST(Architecture, RoomsIncludeOnlyRoomsAboveThem) {
  for (const fs::path& file : sources("lib")) {
    const std::set<std::string> rooms = allowed(room_of(file));
    for (const std::string& header : includes(file)) {
      if (!starts_with(header, "graze/")) continue;
      const std::string room = (++fs::path(header).begin())->string();
      EXPECT_TRUE(rooms.count(room)) << name_of(file) << " includes " << header;
    }
  }
}

TEST(Architecture, HeadersOfTheProjectAreIncludedByTheirFullName) {
  for (const fs::path& file : sources("lib"))
    for (const std::string& header : includes(file)) {
      const bool own = header.size() > 4 && header.substr(header.size() - 4) == ".hpp" &&
                       fs::exists(file.parent_path() / header);
      EXPECT_FALSE(own) << name_of(file) << " includes " << header;
    }
}

// So that a header that needs another before it does not compile. Those without a .cpp are compiled
// alone (tests/CMakeLists.txt).
TEST(Architecture, EverySourceIncludesItsOwnHeaderFirst) {
  for (const fs::path folder : {"lib", "apps"}) {
    for (const fs::path& file : sources(folder)) {
      if (file.extension() != ".cpp") continue;
      const fs::path header = fs::path(file).filename().replace_extension(".hpp");
      fs::path own = file.parent_path() / header;
      if (!fs::exists(own)) own = file.parent_path() / "detail" / header;
      if (!fs::exists(own)) continue;
      const fs::path name = folder == "lib" ? fs::relative(own, kRoot / folder) : own.filename();
      ASSERT_FALSE(includes(file).empty()) << name_of(file);
      EXPECT_EQ(includes(file).front(), name.generic_string()) << name_of(file);
    }
  }
}

// The tail of a chatter that stops share is a motion itself: the one thing that needs what it is
// part of.
const std::set<std::string> kPartOfAMotion = {"motion/shared_chatter"};

// What each module of lib includes of the others.
std::map<std::string, std::set<std::string>> module_includes() {
  std::map<std::string, std::set<std::string>> graph;
  for (const fs::path& file : sources("lib")) {
    const std::string module = module_of(file);
    if (kPartOfAMotion.count(module)) continue;
    std::set<std::string>& known = graph[module];
    for (const std::string& header : includes(file))
      if (starts_with(header, "graze/") && module_of(header) != module)
        known.insert(module_of(header));
  }
  return graph;
}

// All that a module stands on: what it includes, and what that stands on.
std::set<std::string> foundation(const std::map<std::string, std::set<std::string>>& graph,
                                 const std::string& module) {
  std::set<std::string> reached;
  std::vector<std::string> next = {module};
  while (!next.empty()) {
    const auto known = graph.find(next.back());
    next.pop_back();
    if (known == graph.end()) continue;
    for (const std::string& name : known->second)
      if (reached.insert(name).second) next.push_back(name);
  }
  return reached;
}

// So that a room can be read from the bottom up.
TEST(Architecture, ModulesDoNotIncludeEachOtherInCircles) {
  const std::map<std::string, std::set<std::string>> graph = module_includes();
  EXPECT_TRUE(foundation(graph, "continuation/branch").count("continuation/branch/zero_problem"));
  for (const auto& [module, known] : graph) {
    for (const std::string& name : known)
      EXPECT_FALSE(foundation(graph, name).count(module)) << module << " includes " << name;
  }
}

// The same of folders: whoever reads one has to know only those that it stands on.
TEST(Architecture, FoldersDoNotIncludeEachOtherInCircles) {
  std::map<std::string, std::set<std::string>> graph;
  for (const fs::path& file : sources("lib"))
    for (const std::string& header : includes(file)) {
      if (!starts_with(header, "graze/")) continue;
      const std::string folder = folder_of(kRoot / "lib" / header);
      if (folder != folder_of(file)) graph[folder_of(file)].insert(folder);
    }
  EXPECT_TRUE(foundation(graph, "orbit/search").count("flow/exact"));
  for (const auto& [folder, known] : graph)
    for (const std::string& name : known)
      EXPECT_FALSE(foundation(graph, name).count(folder)) << folder << " includes " << name;
}

// A third party and the only places that may include it: a folder, and there .cpp files alone
// unless said otherwise.
struct Fence {
  std::string header;  // what its headers' names start with
  std::vector<std::string> folders;
  bool headers_too = false;
};

TEST(Architecture, ThirdPartiesAreFenced) {
  const std::vector<Fence> fences = {
      {"toml++", {"lib/graze/scene/"}},
      {"ceres/", {"lib/graze/orbit/", "lib/graze/fit/"}},
      {"glog/", {"lib/graze/orbit/"}},
      {"nlohmann/", {"lib/graze/record/", "lib/graze/report/"}},
      {"CLI/", {"apps/"}, true},
      {"nettle/", {"lib/graze/base/"}},
      {"pybind11/", {"apps/python/"}, true},
      {"Spectra/", {"lib/graze/fem/"}},
      {"suitesparse/", {"lib/graze/fem/"}},
      {"zip.h", {"lib/graze/fem/"}},
      {"nlopt", {"lib/graze/orbit/", "lib/graze/fit/"}},
      {"tbb/", {"lib/graze/base/"}},
      {"hwy/", {"lib/graze/flow/", "lib/graze/motion/lanes/"}},
  };
  for (const char* folder : {"lib", "apps"}) {
    for (const fs::path& file : sources(folder)) {
      for (const std::string& header : includes(file)) {
        for (const Fence& fence : fences) {
          if (!starts_with(header, fence.header)) continue;
          const bool there = std::any_of(
              fence.folders.begin(), fence.folders.end(),
              [&](const std::string& name) { return starts_with(name_of(file), name); });
          const bool shown = file.extension() != ".cpp" && !is_internal(file);
          const bool inside = there && (fence.headers_too || !shown);
          EXPECT_TRUE(inside) << name_of(file) << " includes " << header;
        }
      }
    }
  }
}

// Standard headers have neither a dot nor a slash in their names.
bool is_standard(const std::string& header) {
  return header.find_first_of("./") == std::string::npos;
}

TEST(Architecture, PublicHeadersShowOnlyEigen) {
  for (const fs::path& file : sources("lib")) {
    if (file.extension() != ".hpp" || is_internal(file) ||
        name_of(file) == "lib/graze/flow/exact/extended.hpp")
      continue;
    for (const std::string& header : includes(file)) {
      const bool fine =
          is_standard(header) || starts_with(header, "graze/") || starts_with(header, "Eigen/");
      EXPECT_TRUE(fine) << name_of(file) << " includes " << header;
    }
  }
}

// Else an installed header would ask for one that is not.
TEST(Architecture, PublicHeadersIncludePublicHeaders) {
  for (const fs::path& file : sources("lib")) {
    if (file.extension() != ".hpp" || is_internal(file)) continue;
    for (const std::string& header : includes(file))
      EXPECT_EQ(header.find("/detail/"), std::string::npos)
          << name_of(file) << " includes " << header;
  }
}

// Else who uses the library could not do what the program does.
TEST(Architecture, ProgramsIncludePublicHeaders) {
  for (const fs::path& file : sources("apps"))
    for (const std::string& header : includes(file))
      EXPECT_EQ(header.find("/detail/"), std::string::npos)
          << name_of(file) << " includes " << header;
}

// Else two headers could not be included in one file.
TEST(Architecture, NoTwoTypesHaveOneName) {
  const std::regex type(R"(^(?:struct|class|enum class) (\w+)(?: final)?(?: : [^;{]*)? ?\{.*)");
  std::map<std::string, std::string> known;
  for (const fs::path& file : sources("lib")) {
    if (file.extension() != ".hpp") continue;
    for (const std::string& line : lines(file)) {
      std::smatch match;
      if (!std::regex_match(line, match, type)) continue;
      const auto [first, is_new] = known.emplace(match[1], name_of(file));
      EXPECT_TRUE(is_new) << match[1] << " of " << name_of(file) << " and " << first->second;
    }
  }
  EXPECT_GT(known.size(), 400u);
}

TEST(Architecture, NoFileIsLongerThanFourHundredLines) {
  for (const char* folder : {"lib", "apps", "tests"})
    for (const fs::path& file : sources(folder))
      EXPECT_LE(lines(file).size(), 400u) << name_of(file);
}

TEST(Architecture, FoldersAreNamedAfterWhatTheyHold) {
  for (const char* folder : {"lib", "apps", "tests"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (!entry.is_directory()) continue;
      const std::string name = entry.path().filename().string();
      for (const char* vague : {"util", "helper", "manager", "misc", "tmp"})
        EXPECT_EQ(name.find(vague), std::string::npos) << name_of(entry.path());
    }
  }
}

TEST(Architecture, HeadersOpenWithWhatTheyHoldAndGuardThemselves) {
  for (const fs::path& file : sources("lib")) {
    if (file.extension() != ".hpp") continue;
    const std::vector<std::string> text = lines(file);
    ASSERT_FALSE(text.empty()) << name_of(file);
    EXPECT_TRUE(starts_with(text[0], "// ")) << name_of(file);
    // What is compiled once for every vector unit is included as often (Highway's guard).
    const bool is_kernel = file.filename().string().find("-inl.hpp") != std::string::npos;
    const auto guards = [&](const std::string& line) {
      return is_kernel ? line.find("HWY_TARGET_TOGGLE") != std::string::npos
                       : line == "#pragma once";
    };
    EXPECT_TRUE(std::any_of(text.begin(), text.end(), guards)) << name_of(file);
  }
}

// Tests run beside one another, and a file of a fixed name is written by one while another reads
// it.
TEST(Architecture, TestsWriteIntoFoldersOfTheirOwn) {
  const std::string own = "tests/support/scratch_folder.hpp";
  for (const fs::path& file : sources("tests")) {
    if (name_of(file) == own || name_of(file).find("/architecture/") != std::string::npos) continue;
    for (const std::string& line : lines(file))
      for (const char* shared : {"temp_directory_path", "TempDir()", "tmpnam", "\"/tmp/graze"})
        EXPECT_EQ(line.find(shared), std::string::npos)
            << name_of(file) << ": " << line << ", see " << own;
  }
}

// std::get of a variant that a call returns by value is a reference into what is gone with the
// line.
TEST(Architecture, NothingRefersIntoAVariantThatACallReturns) {
  const std::regex reference(R"(&\s*\w+ = \*?std::get<[\w:]+>\([\w.>-]+\(.*\)\);)");
  for (const char* folder : {"lib", "apps", "tests"})
    for (const fs::path& file : sources(folder))
      for (const std::string& line : lines(file))
        EXPECT_FALSE(std::regex_search(line, reference)) << name_of(file) << ": " << line;
}

// Eigenvalues of a formed product lose all that is smaller than its rounding (decision 0048), and
// a product is not seen by its type. So rooms beside base take those of factors, but for files
// whose matrix comes as one: a generator, or what a motion followed once round gives.
TEST(Architecture, OutsideBaseEigenvaluesAreTakenOfFactors) {
  const std::set<std::string> whole = {"lib/graze/flow/held/generator_parts.cpp",
                                       "lib/graze/orbit/problem/grazing_multipliers.cpp"};
  const std::regex call(R"((^|[^_[:alnum:]])eigenvalues\([^)])");
  std::set<std::string> found;
  for (const fs::path& file : sources("lib")) {
    if (starts_with(name_of(file), "lib/graze/base/")) continue;
    for (const std::string& line : lines(file)) {
      const std::string code = line.substr(0, line.find("//"));
      if (std::regex_search(code, call)) found.insert(name_of(file));
    }
  }
  EXPECT_EQ(found, whole);
}

}  // namespace
