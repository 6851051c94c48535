import { afterEach, expect, test, vi } from 'vitest'
import type { Badge } from '#drawing/badges.ts'
import { letters } from '#figures/letters.svelte.ts'
import { badgeMemory, layBadges } from './lay-badges.ts'

afterEach(() => vi.restoreAllMocks())

const badge: Badge = {
  ...{ id: 'tone', side: 'output', part: 'lamp', icon: 'sound', idle: false },
  ...{ label: 'Tone', value: ['440 Hz'] },
}

/** A pane of 600 × 400 px, with the scale in its lower right corner. */
const viewport = { pane: { width: 600, height: 400 }, corner: { x: 0, y: 0 }, scale: 1 }
const scaleBar = { left: 600 - 170, top: 400 - 44 }

test('a badge is not written over the scale, though its place behind Bo would be there', () => {
  vi.spyOn(letters, 'widthOf').mockImplementation((text) => 7 * text.length)
  // Bo looks to the upper left: behind it is the lower right.
  const stands = { bo: { x: 470, y: 330 }, heading: 135, tick: 0, others: [], readings: [], viewport }
  const [laid] = layBadges([badge], stands, badgeMemory())
  const { x, y, width, height } = laid!.box
  expect(x + width <= scaleBar.left || y + height <= scaleBar.top).toBe(true)
})

test('a badge is not written under the button of the time in the lower left corner', () => {
  vi.spyOn(letters, 'widthOf').mockImplementation((text) => 7 * text.length)
  // Bo looks to the upper right: behind it is the lower left.
  const stands = { bo: { x: 110, y: 330 }, heading: 45, tick: 0, others: [], readings: [], viewport }
  const [laid] = layBadges([badge], stands, badgeMemory())
  const { x, y, height } = laid!.box
  expect(x >= 60 || y + height <= viewport.pane.height - 60).toBe(true)
})

test('a badge stays on its side while the robot turns; after a jump its side depends on the new place only', () => {
  vi.spyOn(letters, 'widthOf').mockImplementation((text) => 7 * text.length)
  const start = { bo: { x: 200, y: 200 }, heading: 0, tick: 0, others: [], readings: [], viewport }
  const boxOf = (stands: typeof start, memory = badgeMemory()) => layBadges([badge], stands, memory)[0]!.box
  const memory = badgeMemory()
  const first = boxOf(start, memory)
  const turned = { ...start, heading: 170, tick: 60 }
  expect(boxOf(turned, memory)).toEqual(first)
  expect(boxOf(turned)).not.toEqual(first)
  for (const jump of [
    { ...turned, tick: 0 },
    { ...turned, bo: { x: 300, y: 200 } },
    { ...turned, viewport: { ...viewport, scale: 1.2 } },
  ]) {
    const here = badgeMemory()
    boxOf(start, here)
    boxOf({ ...start, tick: 60 }, here)
    expect(boxOf(jump, here)).toEqual(boxOf(jump))
  }
})
