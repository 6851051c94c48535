import { cos, draw, sin, stream, type StreamState } from '@botgarten/numbers'

type Rows = number[][]
const PI = 3.141592653589793

/** About −1 to 1, most of it in the middle. */
const near = (chance: StreamState) => (draw(chance) + draw(chance) + draw(chance) - 1.5) / 1.5

const heap = (chance: StreamState, count: number, x: number, y: number, wide: number): Rows =>
  Array.from({ length: count }, () => [x + wide * near(chance), y + wide * near(chance)])

const arc = (chance: StreamState, count: number, x: number, y: number, turn: number): Rows =>
  Array.from({ length: count }, (_, index) => {
    const angle = turn + (PI * index) / (count - 1)
    return [x + 2.9 * cos(angle) + 0.35 * near(chance), y + 2.9 * sin(angle) + 0.35 * near(chance)]
  })

/** Data sets on which one sees what k-means can and cannot do. `flags`: with how many it begins. */
export const traps: { readonly [name: string]: { readonly flags: number; readonly rows: () => Rows } } = {
  heaps: {
    flags: 3,
    rows: () => {
      const chance = stream(3, 'heaps')
      return [
        ...heap(chance, 14, 2.2, 7.6, 1.5),
        ...heap(chance, 14, 7.6, 7.2, 1.5),
        ...heap(chance, 14, 5, 2.3, 1.5),
      ]
    },
  },
  /** Two arcs into each other: flags cut straight through. */
  moons: {
    flags: 2,
    rows: () => {
      const chance = stream(4, 'moons')
      return [...arc(chance, 32, 3.9, 4.2, 0), ...arc(chance, 32, 6.3, 5.8, PI)]
    },
  },
  /** A wide heap beside two small ones loses its rim to them. */
  unequal: {
    flags: 3,
    rows: () => {
      const chance = stream(5, 'unequal')
      return [
        ...heap(chance, 70, 3.4, 5, 3.1),
        ...heap(chance, 9, 8.6, 7.6, 0.6),
        ...heap(chance, 9, 8.6, 2.4, 0.6),
      ]
    },
  },
  /** One point far away may take a flag for itself. */
  outlier: {
    flags: 2,
    rows: () => {
      const chance = stream(6, 'outlier')
      return [...heap(chance, 14, 1.9, 2.6, 1), ...heap(chance, 14, 3.9, 4.9, 1), [9.7, 9.5]]
    },
  },
  /** Five heaps, two flags: too few. */
  few: { flags: 2, rows: () => fiveHeaps() },
  /** One heap, five flags: it is cut to pieces. */
  many: { flags: 5, rows: () => heap(stream(8, 'many'), 60, 5, 5, 3.2) },
}

function fiveHeaps(): Rows {
  const chance = stream(7, 'few')
  const places = [
    [1.8, 1.9],
    [8.1, 1.7],
    [1.9, 8.2],
    [8.2, 8.1],
    [5, 5],
  ] as const
  return places.flatMap(([x, y]) => heap(chance, 12, x, y, 1.1))
}
