import { cos, sin } from '@botgarten/numbers'
import { expect, test } from 'vitest'
import { bodiesWithin } from './gaps.ts'
import { createOutlines, moveBody } from './outlines.ts'
import { partOfShape } from './parts.ts'

const box = partOfShape({ kind: 'rectangle', width: 40, height: 20 })
const disc = partOfShape({ kind: 'circle', radius: 5 })

/** Is the gap smaller, with the disc at (x, y) in the frame of a box that is turned? Asked from both sides. */
function isWithin(x: number, y: number, heading: number, margin: number): boolean {
  const outlines = createOutlines([[box], [disc]])
  moveBody(outlines, 0, 100, 100, heading)
  const [c, s] = [cos(heading), sin(heading)]
  moveBody(outlines, 1, 100 + c * x - s * y, 100 + s * x + c * y, 0)
  const answers = [bodiesWithin(outlines, 0, 1, margin), bodiesWithin(outlines, 1, 0, margin)]
  expect(answers[0]).toBe(answers[1])
  return answers[0]!
}

/** Centres of the disc whose rim is `gap` cm away from the box. */
const places = (gap: number) => {
  const away = 5 + gap
  // To a corner by 3² + 4² = 5².
  const [byX, byY] = [20 + (3 / 5) * away, 10 + (4 / 5) * away]
  return [
    ...[-9, 0, 9].flatMap((y) => [[20 + away, y] as const, [-20 - away, y] as const]),
    ...[-19, 0, 19].flatMap((x) => [[x, 10 + away] as const, [x, -10 - away] as const]),
    ...[-1, 1].flatMap((a) => [-1, 1].map((b) => [a * byX, b * byY] as const)),
  ]
}

test.each([0, 0.3, 1, 2.5])(
  'a disc beside a box that is turned by %s rad is as far away as it is',
  (heading) => {
    for (const gap of [0.05, 1, 3])
      for (const [x, y] of places(gap)) {
        expect(isWithin(x, y, heading, gap + 0.01)).toBe(true)
        expect(isWithin(x, y, heading, gap - 0.01)).toBe(false)
      }
  },
)
