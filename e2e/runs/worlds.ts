import type { Obstacle, RobotConfig, Shape, World } from '@botgarten/simulation'

const config: RobotConfig = {
  wheelDiameter: 5.6,
  trackWidth: 18,
  sensors: {
    1: { kind: 'colour', x: 5, y: 0, angle: 0 },
    2: { kind: 'ultrasonic', x: 10, y: 4, angle: 20 },
    3: { kind: 'ultrasonic', x: 10, y: -4, angle: -20 },
  },
  drive: { left: 'C', right: 'B' },
}

const shapes: readonly Shape[] = [
  { kind: 'rectangle', width: 24, height: 18 },
  { kind: 'circle', radius: 9 },
  { kind: 'triangle', width: 26, height: 22 },
]

// Eight places round the start: one is taken by something that cannot be pushed.
const places = [-1, 0, 1].flatMap((row) => [-1, 0, 1].map((column) => ({ column, row })))

function things(k: number): Obstacle[] {
  return places
    .filter(({ column, row }) => column !== 0 || row !== 0)
    .map(({ column, row }, index) => ({
      id: `thing${index}`,
      shape: shapes[(index + k) % shapes.length]!,
      pose: { x: 150 + column * (50 + 3 * k), y: 150 + row * (52 - 2 * k), heading: 23 * index + 7 * k },
      fixed: index === 3,
      colour: '#B9AFA6',
    }))
}

/** A small walled world full of things that can be pushed. `k` 0..3 varies it. */
export function pushingWorld(k: number): World {
  return {
    size: { width: 300, height: 300 },
    floor: { colour: '#FFFFFF' },
    areas: [
      {
        id: 'dark',
        shape: { kind: 'circle', radius: 40 + 5 * k },
        pose: { x: 90, y: 210, heading: 0 },
        colour: '#000000',
      },
    ],
    lines: [
      {
        id: 'line',
        points: [
          { x: 20, y: 40 },
          { x: 280, y: 60 + 20 * k },
        ],
        width: 4,
        colour: '#B30006',
      },
    ],
    obstacles: things(k),
    robots: [
      {
        ...{ id: 'bo', program: 'main', brain: '', pose: { x: 150, y: 150, heading: 40 + 77 * k } },
        config: k % 2 === 1 ? { ...config, noise: 5 } : config,
      },
    ],
  }
}
