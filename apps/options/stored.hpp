// Commands that work on folders of earlier results: merge, view.
#pragma once

#include <string>
#include <vector>

#include "options/picture.hpp"
#include "options/shared.hpp"

namespace graze {

struct MergeCommand : CommonOptions {
  std::vector<std::string> folders;
};

struct ViewCommand : CommonOptions {
  std::string result;  // folder, or the document in it
  std::string show,
      at;  // what a picture shows, in the words of the command; empty: as before
};

void describe(auto& v, MergeCommand& o) {
  v.command("merge", "Join the shares of a diagram, map or comparison (--shard) to its result",
            "merge runs/part* --out runs/whole --plot whole.svg");
  v.file("FOLDER", o.folders, "Folders that --shard wrote to", kMandatory);
  describe_output(v, o, kMandatory);
  describe(v, o.plot, kAllFeatures);
  describe_max_seconds(v, o);
}

void describe(auto& v, ViewCommand& o) {
  v.command("view", "Print and draw the result in a folder that --out wrote",
            "view runs/map --show speed --plot speed.svg");
  v.file("RESULT", o.result, "Folder that --out of a command wrote, or the result.json in it",
         kMandatory);
  describe_printing(v, o);
  describe(v, o.plot, kAllFeatures);
  v.heading("What is shown");
  v.option("show", o.show, "WHAT",
           "What the picture shows, in the words of --show of the command that made the result "
           "(default: what it was asked for)");
  v.option("at", o.at, "PLACE", "Of response curves: the place, e.g. probe.1 or stop.2",
           Needs{{"show"}});
}

}  // namespace graze
