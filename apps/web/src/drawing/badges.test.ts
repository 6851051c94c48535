import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { drawBadge, placeBadges, sizeOf, type Around, type Badge } from './badges.ts'

const widthOf = (text: string, size: number) => text.length * size * 0.6
const lamp: Badge = {
  ...{
    id: 'lamp',
    side: 'output',
    icon: { colour: '#FFA51F' },
    label: 'lamp',
    value: ['orange'],
    idle: false,
  },
  part: 'lamp',
}
const area = { x: 0, y: 0, width: 400, height: 500 }
const around = (part: Partial<Around> = {}): Around => ({
  ...{ bo: { x: 200, y: 250 }, heading: 0, radius: 40, area, taken: [] },
  ...part,
})
const two = [
  { id: 'colour 1', width: 120, height: 34 },
  { id: 'lamp', width: 140, height: 34 },
]
type Box = typeof area
const inside = ({ x, y, width, height }: Box) =>
  x >= 0 && y >= 0 && x + width <= area.width && y + height <= area.height
const meet = (a: Box, b: Box) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height

describe('badges beside Bo', () => {
  it('stand behind it first, where its rays do not go', () => {
    const [first] = placeBadges(two, around({ heading: 0 }), new Map())
    expect(first!.x + first!.width / 2).toBeLessThan(200)
    const [other] = placeBadges(two, around({ heading: 180 }), new Map())
    expect(other!.x + other!.width / 2).toBeGreaterThan(200)
  })

  it('stay inside the pane, clear of Bo and of each other, wherever Bo stands and looks', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 40, max: 360 }),
        fc.integer({ min: 40, max: 460 }),
        fc.integer({ min: 0, max: 359 }),
        (x, y, heading) => {
          const [a, b] = placeBadges(two, around({ bo: { x, y }, heading }), new Map())
          expect(inside(a!)).toBe(true)
          expect(inside(b!)).toBe(true)
          expect(meet(a!, b!)).toBe(false)
          for (const box of [a!, b!]) {
            const across = Math.max(box.x - x, 0, x - box.x - box.width)
            const down = Math.max(box.y - y, 0, y - box.y - box.height)
            expect(Math.hypot(across, down)).toBeGreaterThanOrEqual(38)
          }
        },
      ),
    )
  })

  it('keep their side while Bo turns, as long as they stand well there', () => {
    const last = new Map<string, number>()
    const before = placeBadges(two, around({ heading: 0 }), last)
    expect(placeBadges(two, around({ heading: 170 }), last)).toEqual(before)
  })

  it('go elsewhere where something is written already', () => {
    const [free] = placeBadges(two, around(), new Map())
    const [moved] = placeBadges(two, around({ taken: [free!] }), new Map())
    expect(meet(free!, moved!)).toBe(false)
  })

  it('are as wide as their words, and a row higher for every row of a display', () => {
    const narrow = sizeOf(lamp, widthOf)
    const wide = sizeOf({ ...lamp, value: ['orange', 'and green'] }, widthOf)
    expect(wide.width - narrow.width).toBeCloseTo(3 * 15 * 0.6, 6)
    expect(wide.height).toBeGreaterThan(narrow.height)
  })

  it('are painted paler where nothing shines', () => {
    const strokes = (badge: Badge) =>
      drawBadge(badge, { x: 0, y: 0, width: 9, height: 9 }, 4).flatMap((one) =>
        'stroke' in one ? [one.stroke] : [],
      )
    expect(strokes(lamp)).toContain('#F28C45')
    expect(strokes({ ...lamp, idle: true })).not.toContain('#F28C45')
  })
})
