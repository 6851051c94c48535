import type { Command } from './commands.ts'
import type { Hit } from './grab.ts'
import type { Point } from './points.ts'

/** What is chosen by a hand: a ring around it, and a handle to turn it by. */
export interface Chosen {
  readonly at: Point
  /** Degrees clockwise. */
  readonly turn: number
  readonly hit: Hit
  /** Middle of the handle. */
  readonly handle: Point
}

const ink = '#3A2A20'
const edge = '#8C7152'

/** A line as an outline outside of what can be grabbed. */
export function ring({ at, turn, hit: { width, height, round } }: Chosen): readonly Command[] {
  const around = (out: number, look: object): Command =>
    round
      ? { kind: 'circle', x: 0, y: 0, r: width / 2 + out, ...look }
      : {
          kind: 'rect',
          x: width / -2 - out,
          y: height / -2 - out,
          width: width + 2 * out,
          height: height + 2 * out,
          round: 6 + out,
          ...look,
        }
  return [
    {
      kind: 'group',
      ...at,
      turn,
      shapes: [
        around(1.5, { stroke: '#fff', lineWidth: 3, opacity: 0.9 }),
        around(1.25, { stroke: edge, lineWidth: 2.5, dash: [4, 5] }),
      ],
    },
  ]
}

export const turnHandle = ({ at, handle }: Chosen): readonly Command[] => [
  { kind: 'line', points: [at, handle], stroke: edge, lineWidth: 2.5, dash: [5, 5] },
  { kind: 'circle', x: handle.x, y: handle.y + 2, r: 16, fill: '#6E5032', opacity: 0.14 },
  { kind: 'circle', ...handle, r: 15, fill: '#FFFDF8', stroke: edge, lineWidth: 2 },
  {
    kind: 'group',
    x: handle.x - 10,
    y: handle.y - 10,
    scale: 20 / 24,
    shapes: [
      {
        kind: 'path',
        d: 'M19.5 12a7.5 7.5 0 1 1-2.6-5.7M20 3.5l-2.8 3.1-3.7-1.7',
        stroke: ink,
        lineWidth: 2.4,
      },
    ],
  },
]
