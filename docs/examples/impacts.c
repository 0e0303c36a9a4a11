/* The first impacts of a ball that falls 1.25 m on a floor, from C:
 *   gcc impacts.c -lgraze -o impacts */
#include <graze.h>
#include <stdio.h>

static const char scene[] =
    "[modal]\n"
    "frequencies = [0.0]\n" /* nothing holds the ball */
    "inertia = [1.0]\n"
    "[gravity]\n"
    "acceleration = 10.0\n"
    "[[stop]]\n"
    "shape = [1.0]\n"
    "gap = 1.25\n"
    "restitution = 0.8\n";

int main(void) {
  const char* words[] = {"simulate", "--duration", "3"};
  graze_result* run = graze_run(scene, words, 3);
  size_t count = 0, stride = 0;
  const double* time = graze_column(run, "events", "time", &count, &stride);
  const double* speed = graze_column(run, "events", "speed", NULL, NULL);
  for (size_t i = 0; time && speed && i < count && i < 3; i++)
    printf("impact at %.12g s, %.12g m/s\n", time[i * stride], speed[i * stride]);
  if (graze_status(run) != 0) fprintf(stderr, "%s\n", graze_message(run));
  const int status = graze_status(run);
  graze_free(run);
  return status;
}
