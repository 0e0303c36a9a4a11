#include "fuzz/materials.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "fuzz/damage.hpp"
#include "fuzz/watched_run.hpp"

namespace graze {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const fs::path& folder, const std::string& end) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().string().ends_with(end))
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

// Options of a run whose folder is worth to go on from.
struct Kept {
  std::string name;
  std::vector<std::string> words;
};

std::vector<Kept> runs_to_keep(const std::string& scene) {
  const std::vector<std::string> range{
      "--parameter", "forcing.frequency", "--from", "20", "--to", "120", "--quiet"};
  const auto with = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.begin() + 1, scene);
    words.insert(words.end(), range.begin(), range.end());
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const std::vector<std::string> plane{"--second",        "stop.gap", "--second-from", "5e-4",
                                       "--second-to",     "2e-3",     "--points",      "40",
                                       "--second-points", "40",       "--max-seconds", "0.1"};
  return {{"run", {"simulate", scene, "--periods", "20"}},
          {"branches", with({"continue"}, {})},
          {"share1", with({"diagram"}, {"--points", "8", "--branches", "none", "--shard", "1/2"})},
          {"share2", with({"diagram"}, {"--points", "8", "--branches", "none", "--shard", "2/2"})},
          {"half_diagram", with({"diagram"}, {"--points", "4000", "--max-seconds", "0.1"})},
          {"half_map", with({"map"}, plane)}};
}

}  // namespace

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

Materials prepared_materials(const std::string& program, const fs::path& data,
                             const fs::path& folder) {
  Materials materials;
  materials.scenes = files_in(data / "scenes", ".toml");
  for (const std::string& scene : files_in(data / "measurements", ".toml")) {
    materials.measurements.push_back(scene);
    materials.measurements.push_back(fs::path(scene).replace_extension(".csv").string());
  }
  const std::string one_mode = (data / "scenes/05_wagg_one_mode.toml").string();
  RunLimits limits;
  limits.patience = std::chrono::seconds(60);
  limits.memory = false;
  for (const Kept& kept : runs_to_keep(one_mode)) {
    const std::string run_folder = (folder / kept.name).string();
    std::vector<std::string> words{program};
    words.insert(words.end(), kept.words.begin(), kept.words.end());
    words.insert(words.end(), {"--out", run_folder});
    const WatchedRun run = watched_run(words, folder.string(), limits);
    if ((run.code != 0 && run.code != 3) || !fs::exists(run_folder))
      throw std::runtime_error("no run to start from, " + kept.name + ": " + run.err);
    (kept.name.starts_with("share") ? materials.shares : materials.runs).push_back(run_folder);
  }
  return materials;
}

Materials damaged_copy(const Materials& materials, const fs::path& folder, Draw& draw) {
  Materials copy = materials;
  for (std::vector<std::string>* list : {&copy.shares, &copy.runs})
    for (std::string& run : *list) {
      const fs::path to = folder / fs::path(run).filename();
      fs::copy(run, to, fs::copy_options::recursive);
      run = to.string();
    }
  if (draw.once_in(2)) return copy;
  const std::string run = draw.of(draw.once_in(2) ? copy.shares : copy.runs);
  const std::vector<std::string> files = files_in(run, "");
  const std::string file = draw.of(files);
  const std::string text = damaged(text_of(file), draw);
  std::ofstream(file, std::ios::binary) << text;
  return copy;
}

}  // namespace graze
