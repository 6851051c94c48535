import { completeLanguages, ownTableOf } from '@botgarten/messages/folder'
import { expect, test } from 'vitest'
import { heightOf, laidOut, laidWays } from './flow.ts'
import { qLearning } from './flows.ts'

const boxes = laidOut(qLearning)
const ways = laidWays(qLearning)
const left = (box: (typeof boxes)[number]) => box.x - box.width / 2
const top = (box: (typeof boxes)[number]) => box.y - box.height / 2

test('no box covers another, and all stand inside', () => {
  for (const a of boxes) {
    expect(left(a)).toBeGreaterThan(0)
    expect(left(a) + a.width).toBeLessThan(qLearning.width)
    expect(top(a) + a.height).toBeLessThanOrEqual(heightOf(qLearning))
    for (const b of boxes)
      if (a !== b)
        expect(
          Math.abs(a.x - b.x) >= (a.width + b.width) / 2 + 8 ||
            Math.abs(a.y - b.y) >= (a.height + b.height) / 2 + 16,
          `${a.id} and ${b.id}`,
        ).toBe(true)
  }
})

test('no way runs through a box', () => {
  for (const { from, to, corners } of ways)
    corners.slice(1).forEach((end, at) => {
      const start = corners[at]!
      const through = boxes.filter(
        (box) =>
          Math.max(start.x, end.x) > left(box) + 0.1 &&
          Math.min(start.x, end.x) < left(box) + box.width - 0.1 &&
          Math.max(start.y, end.y) > top(box) + 0.1 &&
          Math.min(start.y, end.y) < top(box) + box.height - 0.1,
      )
      expect(through.map(({ id }) => `${from} to ${to} through ${id}`)).toEqual([])
    })
})

test('from every box a round leads back to it, and questions alone have more than one way out', () => {
  const next = (id: string) => ways.filter(({ from }) => from === id).map(({ to }) => to)
  for (const { id, look } of boxes) {
    expect(next(id).length > 1).toBe(look === 'question')
    const reached = new Set(next(id))
    for (const one of reached) for (const further of next(one)) reached.add(further)
    expect([...reached]).toContain(id)
  }
})

test.each(completeLanguages)('every box and every way has its words, in "%s"', (language) => {
  const said = ownTableOf('materials', language)
  const asked = [
    ...boxes.map(({ id }) => id),
    ...ways.flatMap(({ word, then }) => [word ?? [], then ?? []].flat()),
  ]
  expect(asked.filter((word) => !said[`materials.flow.${word}`])).toEqual([])
})
