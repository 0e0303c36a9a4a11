#include "graze/report/picture/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

#include "graze/base/errors.hpp"
#include "graze/record/file/detail/files.hpp"
#include "graze/report/text/detail/shell_word.hpp"

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
  // A group of its own: an interrupt from the terminal ends the computing, not the picture of what
  // was computed.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  // Whatever the user's own gnuplot settings say, the picture stays the same.
  std::string program = "gnuplot", option = "--default-settings";
  char* arguments[] = {program.data(), option.data(), nullptr};
  const int error =
      ::posix_spawnp(&process, program.c_str(), &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

// The last line of gnuplot's messages that says something.
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

// The same picture three times: text of 7 points on a width of 12 cm, still read in a column.
// Points in units of `mark` look alike, too.
std::string terminal(const std::filesystem::path& file, double proportion) {
  const std::string extension = file.extension().string();
  if (extension == ".png")
    return fmt::format(
        "set terminal pngcairo enhanced font 'DejaVu Sans,11' fontscale 2.6 linewidth 3 "
        "pointscale 3.4 dashlength 0.7 size 1360,{:.0f} background '#FFFFFF'\n"
        "mark = 1\n",
        1360.0 * proportion);
  if (extension == ".pdf")
    return fmt::format(
        "set terminal pdfcairo enhanced font 'DejaVu Sans,11' fontscale 0.64 linewidth 1.1 "
        "pointscale 0.9 dashlength 0.7 size 12cm,{:.4g}cm background '#FFFFFF'\n"
        "mark = 1\n",
        12.0 * proportion);
  return fmt::format(
      "set terminal svg enhanced font 'DejaVu Sans,11' fontscale 1.4 linewidth 1.4 dashlength 0.7 "
      "size 640,{:.0f} background '#FFFFFF'\n"
      "mark = 1.6\n",
      640.0 * proportion);
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
  text_ += "$" + name + " << EOD\n" + table.text() + "EOD\n";
}

void GnuplotScript::plot(const std::vector<std::string>& layers) {
  text_ += "plot ";
  for (const std::string& layer : layers) text_ += layer + ", \\\n     ";
  text_ += "NaN notitle\n";
}

std::string gnuplot_string(const std::string& text) {
  std::string quoted = "'";
  for (char c : text) {
    if (c == '\'') quoted += '\'';
    quoted += c;
  }
  return quoted + "'";
}

namespace {

// A file of our own that goes when its picture is drawn.
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

void draw(const std::string& file, const std::string& head, const std::string& layers,
          const GnuplotScript& script, const std::string& picture) {
  const std::filesystem::path path(file);
  // What begins with a minus or a tilde would be an option or a home.
  const std::string script_name = path.stem().string() + ".gp";
  const bool special = script_name.front() == '-' || script_name.front() == '~';
  const std::string comment = fmt::format("# Draws {}: gnuplot {}\n", path.filename().string(),
                                          shell_word((special ? "./" : "") + script_name));
  write_file(path, picture);
  write_file(std::filesystem::path(path).replace_extension(".gp"),
             comment + layers + head + output(path) + script.text());
}

}  // namespace

void draw_picture(const std::string& file, const GnuplotScript& script, double proportion) {
  const std::string head = "set encoding utf8\n" + terminal(file, proportion);
  draw(file, head, "", script, drawn(file, head + script.text()));
}

void draw_picture(const std::string& file, const GnuplotScript& script, double proportion,
                  const PixelLayer& layer) {
  const std::string head = "set encoding utf8\n" + terminal(file, proportion);
  const ScratchFile scratch;
  write_file(scratch.path(), drawn(file, pixel_terminal(layer) + layer.script.text()));
  const std::string picture =
      drawn(file, head + "pixels = " + gnuplot_string(scratch.path()) + "\n" + script.text());
  const std::filesystem::path kept =
      std::filesystem::path(file).replace_extension(".dots.png").filename();
  draw(file, head,
       pixel_terminal(layer) + output(kept) + layer.script.text() +
           "set output\nreset\npixels = " + gnuplot_string(kept.string()) + "\n",
       script, picture);
}

}  // namespace graze
