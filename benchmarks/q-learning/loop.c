// The standard rules on the City in C: same generator, same layout of the table, same draws as packages/learning.
// cc -O2 loop.c -o loop && ./loop MOVES < graph; graph: stations start goal, then first[], to[] as text.
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static uint32_t s[4] = {1, 2, 3, 4};

static uint32_t rotate(uint32_t x, int k) { return (x << k) | (x >> (32 - k)); }

static uint32_t next(void) {
  const uint32_t result = rotate(s[1] * 5, 7) * 9, t = s[1] << 9;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = rotate(s[3], 11);
  return result;
}

static double draw(void) { return next() / 4294967296.0; }

int main(int count, char **given) {
  const long moves = atol(given[1]);
  int stations, start, goal;
  if (count != 2 || scanf("%d %d %d", &stations, &start, &goal) != 3) return 2;
  int *first = calloc(stations + 1, sizeof *first), *open = calloc(stations, sizeof *open), opens = 0;
  for (int i = 0; i <= stations; i++)
    if (scanf("%d", first + i) != 1) return 2;
  int *to = calloc(first[stations], sizeof *to);
  uint32_t *tries = calloc(first[stations], sizeof *tries);
  double *q = calloc(first[stations], sizeof *q), *reward = calloc(first[stations], sizeof *reward);
  for (int i = 0; i < first[stations]; i++) {
    if (scanf("%d", to + i) != 1) return 2;
    reward[i] = to[i] == goal ? 50 : 0;
  }
  for (int i = 0; i < stations; i++)
    if (i != goal && first[i + 1] > first[i]) open[opens++] = i;
  const double alpha = 0.5, gamma = 0.8, teleport = 0.1, explore = 0.5;
  int station = -1, length = 0;
  const clock_t begun = clock();
  for (long move = 0; move < moves; move++) {
    const double rho = draw(), nu = draw();
    if (nu < teleport) station = open[(int)(draw() * opens)];
    else if (station < 0) station = start;
    length++;
    const int from = first[station], end = first[station + 1];
    int taken = from;
    if (rho < explore) taken = from + (int)(draw() * (end - from));
    else {
      int ties = 1;
      for (int other = from + 1; other < end; other++) {
        if (q[other] > q[taken]) taken = other, ties = 1;
        else if (q[other] == q[taken]) ties++;
      }
      if (ties > 1)
        for (int other = taken, skip = (int)(draw() * ties);; other++)
          if (q[other] == q[taken] && skip-- == 0) {
            taken = other;
            break;
          }
    }
    const int next_station = to[taken];
    double best = 0;
    if (next_station != goal) {
      best = q[first[next_station]];
      for (int other = first[next_station] + 1; other < first[next_station + 1]; other++)
        if (q[other] > best) best = q[other];
    }
    tries[taken]++;
    q[taken] = (1 - alpha) * q[taken] + alpha * (reward[taken] + gamma * best);
    station = next_station;
    if (station == goal || length >= 20 * stations) station = -1, length = 0;
  }
  const double seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
  printf("%.17g", moves / seconds);
  for (int i = 0; i < first[stations]; i++) printf(" %.17g", q[i]);
  return 0;
}
