/* Graze from C, and from what calls C: Octave, MATLAB, Julia, Fortran. A scene comes in as text,
 * the options as words of the program's command line; results go out as one JSON document and as
 * columns of numbers. Commands run in this process and print nothing.
 *
 *   const char* words[] = {"simulate", "--periods", "20"};
 *   graze_result* run = graze_run(scene_text, words, 3);
 *   if (graze_status(run) != 0) puts(graze_message(run));
 *   size_t count, stride;
 *   const double* time = graze_column(run, "events", "time", &count, &stride);
 *   for (size_t i = 0; i < count; i++) printf("%g\n", time[i * stride]);
 *   graze_free(run);
 *
 * Units are those of the scene: SI, angles in radians. Texts are UTF-8 and, like columns, belong to
 * the result: they last until graze_free. Different results may be used by different threads at one
 * time, one result by one thread. docs/c.md says more. */
#ifndef GRAZE_H
#define GRAZE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct graze_result graze_result;

/* "0.1.0". */
const char* graze_version(void);

/* Does what `graze WORDS` does with this scene, whose place is behind the first word. `scene`: the
 * text of a scene; null: the words name its file, or the command takes none (view, merge). Paths
 * count from the working folder, those of a scene's text too. Returns null only where memory is
 * out. */
graze_result* graze_run(const char* scene, const char* const* words, size_t count);

/* The same, watched: `watch` is called by this thread some twenty times a second, with the part of
 * the work that is done, 0 to 1, and with `data`. If it returns anything but 0 the work ends and
 * keeps what it finished; the status is then 130. The work itself is done by another thread. */
typedef int (*graze_watch)(double done, void* data);
graze_result* graze_run_watched(const char* scene, const char* const* words, size_t count,
                                graze_watch watch, void* data);

/* The program's exit code: 0 done; 2 words or scene cannot be used; 3 the numerics could not do
 * what was asked, and the result is what was reached; 4 a file or the system failed; 130 the watch
 * ended it. */
int graze_status(const graze_result* result);
/* A sentence about that, with file, line and column of a scene; "" where all went well. */
const char* graze_message(const graze_result* result);

/* The document that --json prints; "" where there is no result (status 2 and 4). */
const char* graze_json(graze_result* result);

/* Tables, which are the files of --out: events, samples, orbits, branches, special, sweep, .. Names
 * by their number from 0, null beyond the last. */
const char* graze_table_name(graze_result* result, size_t table);
/* Names of a table's columns by their number from 0; null beyond the last, and of an unknown table.
 */
const char* graze_column_name(graze_result* result, const char* table, size_t column);
/* A column's `count` numbers, of which the next stands `stride` places behind one; null where there
 * is no such column. Not a number where the table has none. A column of words has their numbers,
 * from 0. */
const double* graze_column(graze_result* result, const char* table, const char* column,
                           size_t* count, size_t* stride);
/* The word that a number in a column of words stands for; null beyond the last, and of a column of
 * numbers. */
const char* graze_word(graze_result* result, const char* table, const char* column, size_t number);

/* Null is allowed. */
void graze_free(graze_result* result);

#ifdef __cplusplus
}
#endif
#endif
