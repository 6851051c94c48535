// Practice of a 4-8-2 network in C: the same loop as packages/learning, momentum 0.9, rate 0.03, in the order of the rows.
// cc -O2 loop.c -lm -o loop && ./loop relu|tanh BATCH ROUNDS < numbers; numbers: 58 parameters, then 512 rows of 4 + 2.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { NI = 4, NH = 8, NO = 2, ROWS = 512 };
struct net {
  double w1[NH][NI], b1[NH], w2[NO][NH], b2[NO];
};
enum { COUNT = sizeof(struct net) / sizeof(double) };
static struct net at, slope, velocity;
static double x[ROWS][NI], t[ROWS][NO];

static void change(int examples) {
  double *w = (double *)&at, *g = (double *)&slope, *v = (double *)&velocity;
  for (int k = 0; k < COUNT; k++) {
    v[k] = 0.9 * v[k] + g[k] / examples;
    w[k] -= 0.03 * v[k];
    g[k] = 0;
  }
}

int main(int count, char **given) {
  if (count != 4) return 2;
  const int curved = strcmp(given[1], "tanh") == 0, batch = atoi(given[2]), rounds = atoi(given[3]);
  for (int k = 0; k < COUNT; k++)
    if (scanf("%lf", (double *)&at + k) != 1) return 2;
  for (int row = 0; row < ROWS; row++)
    for (int k = 0; k < NI + NO; k++)
      if (scanf("%lf", k < NI ? &x[row][k] : &t[row][k - NI]) != 1) return 2;
  const clock_t begun = clock();
  for (int round = 0; round < rounds; round++)
    for (int row = 0, done = 0; row < ROWS; row++) {
      double y[NH], d[NO];
      for (int j = 0; j < NH; j++) {
        double s = at.b1[j];
        for (int i = 0; i < NI; i++) s += at.w1[j][i] * x[row][i];
        y[j] = curved ? tanh(s) : s > 0 ? s : 0;
      }
      for (int j = 0; j < NO; j++) {
        double s = at.b2[j];
        for (int i = 0; i < NH; i++) s += at.w2[j][i] * y[i];
        d[j] = s - t[row][j];
        slope.b2[j] += d[j];
        for (int i = 0; i < NH; i++) slope.w2[j][i] += d[j] * y[i];
      }
      for (int i = 0; i < NH; i++) {
        double z = 0;
        for (int j = 0; j < NO; j++) z += d[j] * at.w2[j][i];
        z *= curved ? 1 - y[i] * y[i] : y[i] > 0;
        slope.b1[i] += z;
        for (int k = 0; k < NI; k++) slope.w1[i][k] += z * x[row][k];
      }
      if (++done == batch || row == ROWS - 1) change(done), done = 0;
    }
  printf("%.17g", (double)rounds * ROWS * CLOCKS_PER_SEC / (clock() - begun));
  for (int k = 0; k < COUNT; k++) printf(" %.17g", ((double *)&at)[k]);
  return 0;
}
