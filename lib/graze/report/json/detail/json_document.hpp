// Private to this room. A result document as a whole: what all begin with, and its text. To write
// and to read JSON is compiled here alone, and takes long.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// How a result was made and how it ended, with which documents and pages begin.
Json document_head(const RunInfo& info, const Outcome& outcome,
                   const std::vector<std::string>& warnings);

// File names and titles may hold bytes that are no UTF-8; they are replaced, not thrown over.
std::string document_text(const Json& document);
// Of a whole document: without "units" and with every "unit" empty where its scene has none.
std::string document_text(Json document, const RunInfo& info);

}  // namespace graze
