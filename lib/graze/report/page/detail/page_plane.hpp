// A plane of two numbers as a page: a chart whose first things are its cells, and what these open.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/report/page/detail/page_chart.hpp"
#include "graze/scene/scene.hpp"
#include "graze/study/plane/plane.hpp"

namespace graze {

// A command that follows what a cell does: what stands before and after the settings of the cell,
// and the start that its coordinates replace numbers of.
Json cell_command_json(const std::string& before, const std::string& after, const Plane& plane,
                       const Scene& scene);

// What is told of a cell that is opened.
struct PageCells {
  std::function<const std::string&(std::size_t cell)> message;  // a sentence, or an empty one
  Json command;
  std::vector<std::string> remarks = {};  // by kind, beside the message
  // Whether all cells of a kind lead to one motion; else a page says of which cell its motion is.
  std::vector<bool> is_one_motion = {};
  std::vector<std::int32_t> kept = {};  // those whose motions the page has
  Json motions = Json::array();
};

// `cells`: null without any; `traced`: the loci, or null; `more`: tables below the others.
void write_plane(const std::string& file, const Chart& chart, Json view, const PageCells* cells,
                 const OrbitLoci* traced, const std::vector<PageTable>& more = {});

}  // namespace graze
