/* The C interface from C: results against closed forms and independent numbers, wrong calls.
 *   interface_test SCENES */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include <graze.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failed = 0;

#define EXPECT(condition)                                             \
  do {                                                                \
    if (!(condition)) {                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      failed = 1;                                                     \
    }                                                                 \
  } while (0)

#define WORDS(...) \
  (const char* const[]){__VA_ARGS__}, sizeof((const char* const[]){__VA_ARGS__}) / sizeof(char*)

static char* text_of(const char* folder, const char* name) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE* file = fopen(path, "rb");
  if (!file) return NULL;
  char* text = calloc(1, 1 << 16);
  const size_t read = fread(text, 1, (1 << 16) - 1, file);
  text[read] = '\0';
  fclose(file);
  return text;
}

/* A ball that falls 1.25 m on a floor and comes back with 0.8 of its speed: the first impact after
 * sqrt(2 h / g), with sqrt(2 g h); the second 2 * 0.8 of that time later. */
static void a_ball_bounces(void) {
  const char* scene =
      "[modal]\nfrequencies = [0.0]\ninertia = [1.0]\n[gravity]\nacceleration = 10.0\n"
      "[[stop]]\nshape = [1.0]\ngap = 1.25\nrestitution = 0.8\n";
  graze_result* run = graze_run(
      scene, WORDS("simulate", "--duration", "2", "--record", "samples", "--sample-rate", "100"));
  EXPECT(graze_status(run) == 0);
  EXPECT(strcmp(graze_message(run), "") == 0);
  size_t count = 0, stride = 0;
  const double* time = graze_column(run, "events", "time", &count, &stride);
  EXPECT(time != NULL && count >= 2);
  if (time && count >= 2) {
    EXPECT(fabs(time[0] - 0.5) < 1e-12);
    EXPECT(fabs(time[stride] - 1.3) < 1e-12);
  }
  const double* speed = graze_column(run, "events", "speed", &count, &stride);
  EXPECT(speed && fabs(speed[0] - 5.0) < 1e-12);
  const double* kind = graze_column(run, "events", "kind", &count, &stride);
  EXPECT(kind && strcmp(graze_word(run, "events", "kind", (size_t)kind[0]), "impact") == 0);
  EXPECT(graze_word(run, "events", "kind", 1000) == NULL);
  EXPECT(graze_word(run, "events", "time", 0) == NULL);
  time = graze_column(run, "samples", "time", &count, &stride);
  EXPECT(time && count == 201 && fabs(time[100 * stride] - 1.0) < 1e-12);
  EXPECT(strstr(graze_json(run), "\"outcome\": \"reached_end\"") != NULL);
  EXPECT(strcmp(graze_table_name(run, 0), "events") == 0);
  EXPECT(strcmp(graze_table_name(run, 1), "samples") == 0);
  EXPECT(graze_table_name(run, 1000) == NULL);
  EXPECT(strcmp(graze_column_name(run, "events", 0), "kind") == 0);
  EXPECT(graze_column_name(run, "events", 1000) == NULL);
  EXPECT(graze_column(run, "events", "nought", &count, &stride) == NULL && count == 0);
  EXPECT(graze_column(run, "nought", "time", &count, &stride) == NULL);
  graze_free(run);
}

/* The orbit of the README; its phase and speed are independent 40-digit values. */
static void an_orbit_is_found(const char* folder) {
  char* scene = text_of(folder, "05_wagg_one_mode.toml");
  EXPECT(scene != NULL);
  graze_result* found = graze_run(scene, WORDS("orbit", "--set", "forcing.frequency=40"));
  EXPECT(graze_status(found) == 0);
  size_t count = 0;
  const double* phase = graze_column(found, "orbits", "phase", &count, NULL);
  EXPECT(phase && count == 1 && fabs(phase[0] - 0.201791940738459) < 1e-12);
  const double* speed = graze_column(found, "orbits", "speed", NULL, NULL);
  EXPECT(speed && fabs(speed[0] - 0.135344897739007) < 1e-12);
  graze_free(found);
  free(scene);
}

static void a_file_may_be_named(const char* folder) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s", folder, "02_wagg_momentum.toml");
  graze_result* checked = graze_run(NULL, WORDS("check", path));
  EXPECT(graze_status(checked) == 0);
  EXPECT(graze_column_name(checked, "modes", 0) != NULL || graze_table_name(checked, 0) == NULL);
  EXPECT(strstr(graze_json(checked), "\"modes\"") != NULL);
  graze_free(checked);
}

/* A folder that a command wrote is the same result, without another word on standard output. */
static void a_folder_is_read_again(const char* folder) {
  char* scene = text_of(folder, "05_wagg_one_mode.toml");
  char out[] = "/tmp/graze_c_XXXXXX", remove_it[64];
  EXPECT(mkdtemp(out) != NULL);
  graze_result* found =
      graze_run(scene, WORDS("orbit", "--set", "forcing.frequency=40", "--out", out));
  graze_result* seen = graze_run(NULL, WORDS("view", out));
  EXPECT(graze_status(seen) == 0 && strcmp(graze_json(found), "") != 0);
  EXPECT(strcmp(graze_json(seen), graze_json(found)) == 0);
  size_t count = 0;
  const double* speed = graze_column(seen, "orbits", "speed", &count, NULL);
  EXPECT(speed && count == 1 && speed[0] == graze_column(found, "orbits", "speed", NULL, NULL)[0]);
  graze_free(seen);
  graze_free(found);
  snprintf(remove_it, sizeof remove_it, "rm -r %s", out);
  EXPECT(system(remove_it) == 0);
  free(scene);
}

static void expect_refused(const char* scene, const char* const* words, size_t count, int status,
                           const char* sentence) {
  graze_result* refused = graze_run(scene, words, count);
  EXPECT(graze_status(refused) == status);
  EXPECT(strstr(graze_message(refused), sentence) != NULL);
  if (!strstr(graze_message(refused), sentence)) fprintf(stderr, "%s\n", graze_message(refused));
  EXPECT(strcmp(graze_json(refused), "") == 0);
  EXPECT(graze_table_name(refused, 0) == NULL);
  EXPECT(graze_column(refused, "events", "time", NULL, NULL) == NULL);
  graze_free(refused);
}

static void wrong_calls_are_told(void) {
  const char* scene = "[modal]\nfrequencies = [1.0]\n";
  expect_refused(scene, NULL, 0, 2, "give a command");
  expect_refused(scene, WORDS("simulat"), 2, "did you mean 'simulate'?");
  expect_refused(scene, WORDS("simulate", NULL), 2, "");
  expect_refused(scene, WORDS("simulate", "--duration", "x"), 2, "--duration: 'x' is not");
  expect_refused(scene, WORDS("help"), 2, "printed by the program alone");
  expect_refused(scene, WORDS("init"), 2, "init");
  expect_refused(NULL, WORDS("check", "no/such/scene.toml"), 4, "cannot be read");
  expect_refused("[modal]\nfrequencies = [1.0]\nx = 1\n", WORDS("check"), 2,
                 "scene.toml:3:1: modal.x");
  expect_refused("\xff", WORDS("check"), 2, "scene.toml:1");
  graze_free(NULL);
  EXPECT(graze_status(NULL) == 4);
  EXPECT(strcmp(graze_json(NULL), "") == 0);
  EXPECT(graze_column(NULL, "events", "time", NULL, NULL) == NULL);
  graze_result* run = graze_run(scene, WORDS("simulate", "--duration", "1"));
  EXPECT(graze_column(run, NULL, NULL, NULL, NULL) == NULL);
  graze_free(run);
}

/* No orbit repeats after two periods here and is alone in that: what was found is told, with why.
 */
static void numerics_that_cannot_say_so(const char* folder) {
  char* scene = text_of(folder, "05_wagg_one_mode.toml");
  graze_result* none = graze_run(scene, WORDS("orbit", "--start", "simulation", "--period", "2"));
  EXPECT(graze_status(none) == 3);
  EXPECT(strcmp(graze_message(none), "") != 0);
  EXPECT(strstr(graze_json(none), "\"outcome\": \"none\"") != NULL);
  graze_free(none);
  free(scene);
}

static int end_at_once(double done, void* calls) {
  EXPECT(done >= 0.0 && done <= 1.0);
  ++*(int*)calls;
  return 1;
}

static int only_look(double done, void* calls) {
  ++*(int*)calls;
  return done > 2.0;
}

/* A run of a million periods, which takes seconds, keeps the events it had when it was ended. */
static void a_watch_ends_the_work(const char* folder) {
  char* scene = text_of(folder, "04_impact_oscillator.toml");
  int calls = 0;
  graze_result* run =
      graze_run_watched(scene, WORDS("simulate", "--periods", "1000000"), end_at_once, &calls);
  EXPECT(calls > 0);
  EXPECT(graze_status(run) == 130);
  size_t count = 0;
  EXPECT(graze_column(run, "events", "time", &count, NULL) && count > 0 && count < 1000000);
  graze_free(run);
  calls = 0;
  run = graze_run_watched(scene, WORDS("simulate", "--periods", "100000"), only_look, &calls);
  EXPECT(graze_status(run) == 0 && calls > 0);
  graze_free(run);
  run = graze_run_watched(scene, WORDS("simulate", "--periods", "x"), NULL, NULL);
  EXPECT(graze_status(run) == 2);
  graze_free(run);
  free(scene);
}

/* KiB that this process holds. */
static long held(void) {
  long pages = 0, resident = 0;
  FILE* file = fopen("/proc/self/statm", "r");
  if (file && fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
  if (file) fclose(file);
  return resident * 4;
}

static void calls_keep_no_memory(const char* folder) {
  char* scene = text_of(folder, "04_impact_oscillator.toml");
  long before = 0;
  for (int call = 0; call < 1100; call++) {
    if (call == 100) before = held();
    graze_result* run = graze_run(
        scene, WORDS("simulate", "--periods", "20", call % 3 ? "--record=samples" : "--energy"));
    EXPECT(graze_status(run) == 0);
    EXPECT(graze_column(run, "events", "time", NULL, NULL) != NULL);
    EXPECT(strcmp(graze_json(run), "") != 0);
    graze_free(run);
    graze_free(graze_run(scene, WORDS("simulate", "--periods", "x")));
    graze_free(graze_run("[modal]\nfrequencies = 1\n", WORDS("check")));
  }
  /* A thousand results hold 200 kB each, documents and samples: 200 MB. */
  EXPECT(held() - before < 2048);
  free(scene);
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  EXPECT(strcmp(graze_version(), "0.1.0") == 0);
  a_ball_bounces();
  an_orbit_is_found(argv[1]);
  a_file_may_be_named(argv[1]);
  a_folder_is_read_again(argv[1]);
  wrong_calls_are_told();
  numerics_that_cannot_say_so(argv[1]);
  a_watch_ends_the_work(argv[1]);
  calls_keep_no_memory(argv[1]);
  if (!failed) puts("the C interface does what it says");
  return failed;
}
