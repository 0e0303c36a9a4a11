// Private to this room. A result document as a whole: what all begin with, and its text. To write
// and to read JSON is compiled here alone, and takes long.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

struct Probe;

Json document_head(const RunInfo& info, const Outcome& outcome,
                   const std::vector<std::string>& warnings);

// Quantity, unit and, of a place on a beam, its position, m.
Json probe_json(const Probe& probe);

// File names and titles may hold bytes that are no UTF-8; they are replaced, not thrown over.
std::string document_text(const Json& document);
// Of a whole document: without "units" and with every "unit" empty where its scene has none.
std::string document_text(Json document, const RunInfo& info);

// Notes of both kinds, which a document does not tell apart.
std::vector<std::string> all_notes(std::vector<std::string> notes,
                                   const std::vector<std::string>& details);

// Of a document's text: numbers survive being written and read again to the last bit.
Json parsed(const std::string& text);

}  // namespace graze
