// One reader for each format of labelled_matrix.hpp; errors as described there.
#pragma once

#include <filesystem>
#include <string>

#include "graze/fem/detail/text_lines.hpp"
#include "graze/fem/labelled_matrix.hpp"

namespace graze {

LabelledMatrix read_matrix_market(TextLines& lines);
LabelledMatrix read_abaqus(TextLines& lines);
LabelledMatrix read_calculix(TextLines& lines);
// `wanted`: the name of the matrix, or empty where the file has but one.
LabelledMatrix read_dmig(TextLines& lines, const std::string& wanted);
LabelledMatrix read_npy(const std::string& name, const std::string& bytes);
LabelledMatrix read_npz(const std::filesystem::path& file);

// Reads a .npy file with one column or one row, or with one dimension.
Vector read_npy_vector(const std::string& name, const std::string& bytes);

}  // namespace graze
