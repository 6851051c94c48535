import { describe, expect, test } from 'vitest'
import type { Command } from './commands.ts'
import {
  drawHeld,
  drawKnobs,
  drawLinks,
  drawNode,
  drawSignal,
  shownValue,
  type LinkLook,
  type NodeLook,
  type Theme,
} from './net.ts'
import { freeLine, knobPlace } from './track.ts'

const plain: Theme = { forced: null, strong: false }
const stage = { x: 0, y: 0, width: 400, height: 200 }
const track = freeLine({ x: 50, y: 100 }, { x: 350, y: 100 }, 40, { least: -1, most: 1, unit: 1 })
const link = (weight: number, more: Partial<LinkLook> = {}): LinkLook => ({
  track,
  at: knobPlace(track, weight),
  weight,
  idle: false,
  marked: false,
  grip: 24,
  label: weight === 0 ? null : { text: String(weight), width: 30, side: 'above' },
  ...more,
})
const node = (more: Partial<NodeLook> = {}): NodeLook => ({
  at: { x: 50, y: 100 },
  colour: '#2F9C95',
  value: 40,
  missing: false,
  pale: false,
  lit: false,
  chosen: false,
  ...more,
})

/** All shapes of a drawing, without their groups. */
const flat = (commands: readonly Command[]): readonly Exclude<Command, { kind: 'group' }>[] =>
  commands.flatMap((one) => (one.kind === 'group' ? flat(one.shapes) : [one]))
const texts = (commands: readonly Command[]) =>
  flat(commands).flatMap((one) => (one.kind === 'text' ? [one.text] : []))

describe('a link', () => {
  const outlines = (weight: number) => flat([drawLinks([link(weight)], stage, plain)])

  test('is 3 px and 13 more for a weight of 1 wide, with an edge of 2 px on each side', () => {
    expect(outlines(0.5).map(({ lineWidth }) => lineWidth)).toEqual([13.5, 9.5])
    expect(outlines(1).map(({ lineWidth }) => lineWidth)).toEqual([20, 16])
  })

  test('below 0 is striped, and at 0 it is dotted', () => {
    expect(outlines(0.5).some(({ stripes }) => stripes)).toBe(false)
    expect(outlines(-0.5).some(({ stripes }) => stripes)).toBe(true)
    expect(outlines(0)).toMatchObject([{ kind: 'line', dash: [2, 8], stroke: '#8C7152' }])
  })

  test('is darker at 0 on the wall', () => {
    expect(flat([drawLinks([link(0)], stage, { ...plain, strong: true })])[0]!.stroke).toBe('#6B5237')
  })
})

describe('a knob', () => {
  test('stands where its weight is, with the number beside it', () => {
    const [knob] = drawKnobs([link(0.5)], stage, plain).shapes
    expect(knob).toMatchObject({ kind: 'group', ...knobPlace(track, 0.5) })
    expect(texts([knob!])).toEqual(['0.5'])
  })

  test('is smaller at 0, without a number, and under those with one', () => {
    const { shapes } = drawKnobs([link(0.5), link(0)], stage, plain)
    expect(shapes.map((one) => texts([one]).length)).toEqual([0, 1])
    const radius = (at: number) => (flat([shapes[at]!])[0] as { readonly r: number }).r
    expect(radius(0)).toBeLessThan(radius(1))
  })

  test('has a tint around it when it was touched, a ring in the theme’s colour where colours are forced', () => {
    const around = (theme: Theme) => flat([drawKnobs([link(0.5, { marked: true })], stage, theme)])[0]
    expect(around(plain)).toMatchObject({ r: 24, fill: '#D8322A', opacity: 0.16 })
    expect(around({ ...plain, forced: 'Highlight' })).toMatchObject({ r: 22, stroke: 'Highlight' })
  })

  test('in the hand lies over its link and what travels there', () => {
    const kinds = flat([drawHeld(link(0.5), [{ track, count: 1, share: 0 }], plain)]).map(({ kind }) => kind)
    expect(kinds.lastIndexOf('line')).toBeLessThan(kinds.indexOf('circle'))
    expect(kinds.at(-1)).toBe('text')
  })
})

test('the pulses of a signal are as far from each other as from the link’s ends', () => {
  const places = drawSignal({ track, count: 4, share: 0.125 }).shapes.map((one) => (one as { x: number }).x)
  const length = track.to.x - track.from.x
  expect(places.map((x) => (x - track.from.x) / length)).toEqual([
    expect.closeTo(0.125),
    expect.closeTo(0.375),
    expect.closeTo(0.625),
    expect.closeTo(0.875),
  ])
})

describe('a ring', () => {
  const arc = (value: number) =>
    flat([drawNode(node({ value }), 47.5, plain)]).find(({ dash }) => dash !== undefined)

  test('is filled from the top by as much of 100 as its value is', () => {
    const [filled, round] = arc(25)!.dash as [number, number]
    expect(filled / round).toBeCloseTo(0.25)
    expect(arc(0)).toBeUndefined()
    expect(arc(25)!.stripes).toBeUndefined()
  })

  test('is filled the other way round and striped below 0', () => {
    const turnedOf = (value: number) =>
      JSON.stringify(drawNode(node({ value }), 47.5, plain)).includes('"scale":[1,-1]')
    expect(arc(-25)!.stripes).toMatchObject({ colour: '#2F9C95' })
    expect([turnedOf(-25), turnedOf(25)]).toEqual([true, false])
  })

  test('has a whole number inside, a long minus, a dash before anything has run, a question mark without its sensor', () => {
    const shown = (value: number | null, missing = false) => shownValue({ value, missing })
    expect([shown(12.4), shown(-3.6), shown(null), shown(5, true)]).toEqual(['12', '−4', '–', '?'])
    expect(texts([drawNode(node({ value: 12.4 }), 40, plain)])).toEqual(['12'])
  })

  test('writes long numbers smaller', () => {
    const size = (value: number) =>
      flat([drawNode(node({ value }), 40, plain)]).flatMap((one) =>
        one.kind === 'text' ? [one.size] : [],
      )[0]!
    expect(size(1000)).toBeLessThan(size(100))
    expect(size(-1000)).toBeLessThan(size(1000))
  })

  test('lights up, and shows whose sum is seen', () => {
    const fills = (more: Partial<NodeLook>) => flat([drawNode(node(more), 40, plain)]).map(({ fill }) => fill)
    expect(fills({ lit: true })).toContain('#FFC83D')
    expect(fills({})).not.toContain('#FFC83D')
    expect(flat([drawNode(node({ chosen: true }), 40, plain)])[0]).toMatchObject({ r: 41.5, opacity: 0.28 })
  })

  test('is filled with its colour where nothing runs, on paper', () => {
    const shapes = flat([drawNode(node(), 40, plain, true)])
    expect(shapes.map(({ fill }) => fill)).toContain('#2F9C95')
    expect(texts(shapes)).toEqual([])
  })
})
