// Private to this room. A result document as a whole: its common beginning, and its text. Writing
// and reading of JSON is compiled only here, since it takes long.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// How a result was made and how it ended, with which documents and pages begin.
Json document_head(const RunInfo& info, const Outcome& outcome,
                   const std::vector<std::string>& warnings);

// File names and titles may hold bytes that are not UTF-8; these are replaced.
std::string document_text(const Json& document);
// For a whole document: without "units" and with every "unit" empty where its scene has none.
std::string document_text(Json document, const RunInfo& info);

}  // namespace graze
