// The script and the data that a command's picture leaves.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "program.hpp"

namespace graze {

class PictureScripts : public testing::Test {
 protected:
  // The script that a command leaves.
  std::string script(const std::string& command) {
    const Finished run = run_graze(command + " --quiet --plot " + (scratch / "x.svg").string());
    EXPECT_EQ(run.code, 0) << run.err;
    return read_text(scratch / "x.gp");
  }
  std::string refusal(const std::string& command) {
    const Finished run = run_graze(command + " --quiet --plot " + (scratch / "y.svg").string());
    EXPECT_EQ(run.code, 2) << command;
    EXPECT_FALSE(std::filesystem::exists(scratch / "y.svg"));
    return run.err;
  }
  // Rows of two numbers of a data set.
  std::vector<std::pair<double, double>> data(const std::string& name) {
    std::istringstream text(read_text(scratch / "x.gp.dat"));
    std::vector<std::pair<double, double>> rows;
    bool within = false;
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with("#")) within = line == "# [" + name + "]";
      std::istringstream numbers(line);
      double x = 0.0, y = 0.0;
      if (within && numbers >> x >> y) rows.emplace_back(x, y);
    }
    return rows;
  }

  ScratchFolder scratch;
};

}  // namespace graze
