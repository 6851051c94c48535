import { afterEach, expect, test, vi } from 'vitest'
import { badgeSides, type Badge } from '#drawing/badges.ts'
import { letters } from '#figures/letters.svelte.ts'
import { layBadges } from './lay-badges.ts'

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
  const stands = { bo: { x: 470, y: 330 }, heading: 135, others: [], readings: [], viewport }
  const [laid] = layBadges([badge], stands, badgeSides())
  const { x, y, width, height } = laid!.box
  expect(x + width <= scaleBar.left || y + height <= scaleBar.top).toBe(true)
})
