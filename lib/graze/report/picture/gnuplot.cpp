#include "graze/report/picture/detail/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "graze/base/errors.hpp"
#include "graze/record/file/files.hpp"
#include "graze/report/text/shell_word.hpp"

// POSIX leaves this to the program, g++ has it declared already.
extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace graze {
namespace {

// A nameless file that vanishes when closed. Handing gnuplot such files for its three streams, in
// place of pipes, leaves no way for the two processes to wait for each other.
class NamelessFile {
 public:
  NamelessFile() : file_(std::tmpfile(), &std::fclose) {
    if (!file_)
      throw FileError(fmt::format("cannot draw the picture: no temporary file can be made: {}",
                                  std::strerror(errno)));
  }

  int descriptor() const { return ::fileno(file_.get()); }

  void fill(const std::string& text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size() &&
                         std::fflush(file_.get()) == 0;
    if (!written)
      throw FileError(fmt::format("cannot draw the picture: no room for a temporary file: {}",
                                  std::strerror(errno)));
    std::rewind(file_.get());
  }

  std::string contents() {
    std::rewind(file_.get());
    std::string text;
    char block[65536];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file_.get()))
      text.append(block, count);
    return text;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

// 0, or the errno of why gnuplot could not be started.
int spawn_gnuplot(const NamelessFile& in, const NamelessFile& out, const NamelessFile& messages,
                  pid_t& process) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages.descriptor(), STDERR_FILENO);
  // A process group of its own: an interrupt from the terminal ends the computation, but not the
  // picture of its results.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  // Keeps the picture independent of the user's own gnuplot settings.
  std::string program = "gnuplot", option = "--default-settings";
  char* arguments[] = {program.data(), option.data(), nullptr};
  const int error =
      ::posix_spawnp(&process, program.c_str(), &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

// The last line of gnuplot's messages with a text.
std::string complaint(const std::string& messages) {
  const std::size_t end = messages.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return "it gave no reason";
  std::size_t start = messages.rfind('\n', end);
  start = messages.find_first_not_of(" \t", start == std::string::npos ? 0 : start + 1);
  return messages.substr(start, end + 1 - start);
}

// The picture that gnuplot writes for the script.
std::string drawn(const std::string& file, const std::string& script) {
  NamelessFile in, out, messages;
  in.fill(script);
  pid_t process = 0;
  if (const int error = spawn_gnuplot(in, out, messages, process)) {
    if (error == ENOENT)
      throw FileError(fmt::format(
          "{}: cannot draw the picture: gnuplot is not installed (package gnuplot-nox)", file));
    throw FileError(fmt::format("{}: cannot draw the picture: gnuplot does not start: {}", file,
                                std::strerror(error)));
  }
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR)
      throw FileError(fmt::format("{}: cannot draw the picture: lost track of gnuplot: {}", file,
                                  std::strerror(errno)));
  if (WIFSIGNALED(status))
    throw FileError(fmt::format("{}: cannot draw the picture: gnuplot was ended by signal {}", file,
                                WTERMSIG(status)));
  // posix_spawnp may also report a missing program the way a shell does.
  if (WEXITSTATUS(status) == 127)
    throw FileError(fmt::format("{}: cannot draw the picture: gnuplot does not start", file));
  std::string picture = out.contents();
  if (WEXITSTATUS(status) != 0 || picture.empty())
    throw FileError(fmt::format("{}: gnuplot could not draw the picture: {}", file,
                                complaint(messages.contents())));
  return picture;
}

// The lines before a script: all that depends on the file, on its size and on its caption.
std::string head_of(const PictureRequest& request, const RunInfo& info, const Canvas& canvas) {
  constexpr double kWidth = 12.0;  // cm, of which lengths across are parts
  std::string caption;
  for (const std::string& line : caption_of(request, info, canvas.width))
    caption += (caption.empty() ? "" : ".\"\\n\".") + plain_gnuplot_string(line);
  return "set encoding utf8\n" + terminal_of(request, canvas) +
         fmt::format("body = {:.6g}\ncaption = {}\nacross = {:.6g}\nupward = {:.6g}\n",
                     canvas.height / (canvas.height + canvas.caption),
                     caption.empty() ? "''" : caption, kWidth / canvas.width,
                     canvas.laid_out / canvas.height);
}

// gnuplot takes a leading | for a command and a leading ~ for a home.
std::string output(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const bool special = name.front() == '|' || name.front() == '~';
  return "set output " + gnuplot_string((special ? "./" : "") + name) + "\n";
}

}  // namespace

void PlotTable::row(std::initializer_list<double> numbers) {
  for (double number : numbers)
    if (!std::isfinite(number)) return gap();
  for (double number : numbers) fmt::format_to(std::back_inserter(text_), "{:.9g} ", number);
  text_.back() = '\n';
  ++rows_;
}

void PlotTable::gap() {
  // One blank line breaks a line, two would begin another data set.
  if (rows_ > 0 && !text_.ends_with("\n\n")) text_ += '\n';
}

void GnuplotScript::command(const std::string& line) { text_ += line + "\n"; }

void GnuplotScript::data(const std::string& name, const PlotTable& table) {
  if (table.empty() || !known_.insert(name).second) return;
  // Two blank lines separate data sets, which are named by the comment above them.
  data_ += (data_.empty() ? "# [" : "\n\n# [") + name + "]\n" + table.text();
}

void GnuplotScript::plot(const std::vector<std::string>& layers) {
  const bool first = !has_caption_;
  has_caption_ = true;
  // It has a tag of its own, to be removed before the next panel.
  if (first)
    text_ += "set label 99 caption at screen 0.02, screen 1 offset 0, -0.8 left font small\n";
  text_ += "plot ";
  for (const std::string& layer : layers) {
    if (!layer.starts_with('$')) {
      text_ += layer + ", \\\n     ";
      continue;
    }
    const std::size_t end = std::min(layer.find(' '), layer.size());
    const std::string name = layer.substr(1, end - 1);
    if (known_.contains(name))
      text_ += "data index '[" + name + "]'" + layer.substr(end) + ", \\\n     ";
  }
  text_ += "NaN notitle\n";
  if (first) text_ += "unset label 99\n";
}

std::string gnuplot_string(const std::string& text) {
  std::string quoted = "'";
  for (char c : text) {
    if (c == '\'') quoted += '\'';
    // Single quotes, in which gnuplot keeps backslashes, end with the line.
    if (c == '\n')
      quoted += "'.\"\\n\".'";
    else
      quoted += c;
  }
  return quoted + "'";
}

std::string plain_gnuplot_string(const std::string& text) {
  return gnuplot_string(as_markup(text));
}

namespace {

// A temporary file that is removed when its picture is drawn.
class ScratchFile {
 public:
  ScratchFile() : path_((std::filesystem::temp_directory_path() / "graze.XXXXXX").string()) {
    const int descriptor = ::mkstemp(path_.data());
    if (descriptor < 0)
      throw FileError(fmt::format("cannot draw the picture: no temporary file can be made: {}",
                                  std::strerror(errno)));
    ::close(descriptor);
  }
  ~ScratchFile() { ::unlink(path_.c_str()); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// Without smooth edges: few colours make a file a tenth as large.
std::string pixel_terminal(const PixelLayer& layer) {
  return fmt::format("set terminal png notruecolor transparent size {},{}\n", layer.width,
                     layer.height);
}

std::string data_line(const std::string& file) { return "data = " + gnuplot_string(file) + "\n"; }

// A picture and the files kept beside it.
struct Drawing {
  std::string picture;
  std::string script;  // without its first comment
  std::string data;
};

void write(const std::string& file, const Drawing& drawing) {
  const std::filesystem::path path(file);
  // A leading minus or tilde would mean an option or a home.
  const std::string script_name = path.stem().string() + ".gp";
  const bool special = script_name.front() == '-' || script_name.front() == '~';
  const std::string comment = fmt::format("# Draws {}: gnuplot {}\n", path.filename().string(),
                                          shell_word((special ? "./" : "") + script_name));
  write_file(path, drawing.picture);
  write_file(std::filesystem::path(path).replace_extension(".gp"), comment + drawing.script);
  // A name that a user's measurements would not have.
  write_file(std::filesystem::path(path).replace_extension(".gp.dat"), drawing.data);
}

// The file as gnuplot finds it, from its own folder.
std::string beside(const std::string& file, const char* extension) {
  const std::string name =
      std::filesystem::path(file).replace_extension(extension).filename().string();
  const bool special = std::string_view("|~-<$").find(name.front()) != std::string_view::npos;
  return (special ? "./" : "") + name;
}

}  // namespace

void draw_picture(const PictureRequest& request, const RunInfo& info, const GnuplotScript& script,
                  const Canvas& canvas) {
  const std::string head = head_of(request, info, canvas);
  const ScratchFile data;
  write_file(data.path(), script.data_text());
  const std::string picture = drawn(request.file, head + data_line(data.path()) + script.text());
  write(request.file,
        {picture,
         head + output(request.file) + data_line(beside(request.file, ".gp.dat")) + script.text(),
         script.data_text()});
}

void draw_picture(const PictureRequest& request, const RunInfo& info, const GnuplotScript& script,
                  const Canvas& canvas, const PixelLayer& layer) {
  const std::string head = head_of(request, info, canvas);
  const ScratchFile data, dots, scratch;
  write_file(data.path(), script.data_text());
  write_file(dots.path(), layer.script.data_text());
  const auto pixels = [&](const std::string& data_file) {
    return pixel_terminal(layer) +
           "body = 1\ncaption = ''\nacross = 1\nupward = 1\nsmall = ''\nmedium = ''\n" +
           data_line(data_file);
  };
  write_file(scratch.path(), drawn(request.file, pixels(dots.path()) + layer.script.text()));
  const std::string picture =
      drawn(request.file, head + data_line(data.path()) +
                              "pixels = " + gnuplot_string(scratch.path()) + "\n" + script.text());
  const std::string kept_data = beside(request.file, ".gp.dat");
  const std::filesystem::path kept =
      std::filesystem::path(request.file).replace_extension(".dots.png").filename();
  const std::string separator =
      layer.script.data_text().empty() || script.data_text().empty() ? "" : "\n\n";
  write(request.file, {picture,
                       pixels(kept_data) + output(kept) + layer.script.text() +
                           "set output\nreset\npixels = " + gnuplot_string(kept.string()) + "\n" +
                           head + output(request.file) + data_line(kept_data) + script.text(),
                       layer.script.data_text() + separator + script.data_text()});
}

}  // namespace graze
