// Graze as a function of Octave, on the C interface:
//   mkoctfile -lgraze -o graze_run.oct graze_octave.cc
//   run = graze_run (fileread ("scene.toml"), "simulate", "--periods", "20");
//   plot (run.samples.time, run.samples.u1)
#include <octave/oct.h>
#include <octave/ov-struct.h>

#include <memory>
#include <vector>

#include <graze.h>

namespace {

Cell words_of(graze_result* run, const char* table, const char* name, const double* data,
              std::size_t count, std::size_t stride) {
  Cell words(static_cast<octave_idx_type>(count), 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double number = data[i * stride];
    const char* word =
        number >= 0.0 ? graze_word(run, table, name, static_cast<std::size_t>(number)) : nullptr;
    words(static_cast<octave_idx_type>(i)) = std::string(word ? word : "");
  }
  return words;
}

octave_scalar_map table_of(graze_result* run, const char* table) {
  octave_scalar_map columns;
  const char* name = nullptr;
  for (std::size_t column = 0; (name = graze_column_name(run, table, column)); ++column) {
    std::size_t count = 0, stride = 0;
    const double* data = graze_column(run, table, name, &count, &stride);
    if (graze_word(run, table, name, 0)) {
      columns.assign(name, words_of(run, table, name, data, count, stride));
      continue;
    }
    ColumnVector numbers(static_cast<octave_idx_type>(count));
    for (std::size_t i = 0; i < count; ++i)
      numbers(static_cast<octave_idx_type>(i)) = data[i * stride];
    columns.assign(name, numbers);
  }
  return columns;
}

// Ctrl-C; Octave itself acts on it once the work has ended.
int is_interrupted(double, void*) { return octave_signal_caught || octave_interrupt_state > 0; }

}  // namespace

DEFUN_DLD(graze_run, args, ,
          "RESULT = graze_run (SCENE, COMMAND, OPTION, ..)\n\n"
          "Does `graze COMMAND OPTION ..` with a scene given as text.  RESULT has the document as\n"
          "text in json, a sentence in message, and a struct of columns for every table.") {
  if (args.length() < 2) print_usage();
  const std::string scene = args(0).string_value();
  std::vector<std::string> given;
  std::vector<const char*> words;
  for (octave_idx_type i = 1; i < args.length(); ++i) given.push_back(args(i).string_value());
  for (const std::string& word : given) words.push_back(word.c_str());
  const std::unique_ptr<graze_result, void (*)(graze_result*)> run(
      graze_run_watched(scene.c_str(), words.data(), words.size(), is_interrupted, nullptr),
      graze_free);
  octave_quit();
  const int status = graze_status(run.get());
  if (status == 2 || status == 4) error("%s", graze_message(run.get()));
  octave_scalar_map result;
  result.assign("json", std::string(graze_json(run.get())));
  result.assign("message", std::string(graze_message(run.get())));
  const char* table = nullptr;
  for (std::size_t i = 0; (table = graze_table_name(run.get(), i)); ++i)
    result.assign(table, table_of(run.get(), table));
  return ovl(result);
}
