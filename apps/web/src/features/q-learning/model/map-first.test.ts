import { describe, expect, test } from 'vitest'
import { GAP, mapFirst, SHARE } from './map-first.ts'

/** Bars of the page: name and task, and the edge around the playground. */
const roomOf = (width: number, height: number) => ({
  width: width - 12,
  height: height - (height < 700 ? 104 : 120) - 12,
})

/** The share of the window that the drawn map has. */
function shareOf(width: number, height: number, ratio: number) {
  const room = roomOf(width, height)
  const { form, bar, rail, table } = mapFirst(room, { width, height }, ratio, false)
  const free = {
    width: form === 'tower' ? room.width : room.width - rail - GAP - (table > 0 ? table + GAP : 0),
    height: room.height - (bar === 'below' ? 67 : 0) - (form === 'tower' ? 330 : 0),
  }
  const side = Math.min(free.width, free.height * ratio)
  return { form, share: (side * side) / ratio / width / height }
}

describe('the map comes first', () => {
  test.each([
    [1920, 1080, 'columns'],
    [1366, 768, 'columns'],
    [1366, 625, 'columns'],
    [1024, 768, 'side'],
    [1024, 670, 'side'],
    [1024, 600, 'side'],
    [800, 600, 'side'],
    [768, 1024, 'tower'],
  ])('in %d by %d px a map of 8 to 5 has its share, as %s', (width, height, form) => {
    const found = shareOf(width, height, 1.6)
    expect(found.form).toBe(form)
    expect(found.share).toBeGreaterThanOrEqual(SHARE)
  })

  test('a map of 4 to 3 has it too, the bar beside it', () => {
    expect(shareOf(1366, 768, 4 / 3)).toMatchObject({ form: 'columns' })
    for (const [width, height] of [
      [1366, 768],
      [1024, 768],
      [1024, 670],
      [1024, 600],
    ] as const)
      // prettier-ignore
      expect(shareOf(width, height, 4 / 3).share).toBeGreaterThanOrEqual(SHARE)
  })

  test('a square map is as high as the window leaves room', () => {
    const room = roomOf(1366, 768)
    const { share } = shareOf(1366, 768, 1)
    expect(share).toBeCloseTo(room.height ** 2 / 1366 / 768, 3)
  })

  test('a table that slides in has the room that it needs', () => {
    const at = (open: boolean) => mapFirst(roomOf(1024, 768), { width: 1024, height: 768 }, 1.6, open)
    expect(at(false).rail).toBeLessThan(316)
    expect(at(true).rail).toBe(346)
  })
})
