// Pieces of long work as one line of text each, which reads back to the last bit.
#pragma once

#include <string>

#include "graze/study/compare/comparison_map.hpp"
#include "graze/study/plane/attractor_map.hpp"
#include "graze/study/sweep/run_series.hpp"
#include "graze/study/sweep/settled_row.hpp"

namespace graze {

std::string piece_text(const SweepRow& row);
std::string piece_text(const SettledCell& cell);
std::string piece_text(const ValueRun& run);
std::string piece_text(const ComparedCell& cell);

// Reads the output of `piece_text`. False for any other text.
bool read_piece(const std::string& text, SweepRow& row);
bool read_piece(const std::string& text, SettledCell& cell);
bool read_piece(const std::string& text, ValueRun& run);
bool read_piece(const std::string& text, ComparedCell& cell);

}  // namespace graze
