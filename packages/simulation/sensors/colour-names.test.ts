import { describe, expect, test } from 'vitest'
import { COLOURS, colourOf } from '../floor/colours.ts'
import { startMove } from '../index.ts'
// Made by reference/colours.py from the spec's rules, in exact fractions.
import reference from '../reference/colours.json'
import { createSimulation } from '../simulation.ts'
import { pose, robotAt } from '../testing/worlds.ts'
import type { Colour, Floor, World } from '../types.ts'

const named = reference as unknown as readonly (readonly [
  colour: Colour,
  name: keyof typeof COLOURS | null,
])[]
const channelsOf = (colour: Colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16))
const wanted = (name: keyof typeof COLOURS | null) => (name === null ? '' : COLOURS[name])

/** Each colour is a stripe this many cm wide across a floor of one pixel a cm. */
const STRIPE = 2
const MARGIN = 20

function striped(): Floor {
  const stripes = named.flatMap(([colour]) => Array.from({ length: STRIPE }, () => channelsOf(colour)))
  const data = new Uint8Array([...Array.from({ length: MARGIN }, () => [0, 0, 0]), ...stripes].flat())
  return { width: data.length / 3, height: 1, pixelsPerCm: 1, data }
}

describe("the colour sensor's names", () => {
  test('drives over every colour on both sides of every boundary of hue, saturation and value, and round all eight', () => {
    const floor = striped()
    const world: World = {
      size: { width: floor.width + MARGIN, height: 60 },
      floor: { colour: '#FFFFFF' },
      areas: [],
      lines: [],
      obstacles: [],
      robots: [robotAt(pose(MARGIN - 5, 30))],
    }
    const sim = createSimulation(world, floor, 1)
    startMove(sim, 0, { left: 100, right: 100 })
    const seen = new Set<number>()
    const wrong: string[] = []
    for (let x = 0; x < floor.width - 1; x = sim.state.robots[0]!.x + 5) {
      const stripe = Math.floor((x - MARGIN) / STRIPE)
      if (stripe >= 0) {
        const [colour, name] = named[stripe]!
        const read = sim.read(0, '1', 'colour')
        if (read !== wanted(name)) wrong.push(`${colour}: ${read}, not ${name}`)
        seen.add(stripe)
      }
      sim.step()
    }
    expect(wrong).toEqual([])
    expect(seen.size).toBe(named.length)
  })

  test('name each of the eight by itself', () => {
    for (const colour of Object.values(COLOURS)) {
      const [r, g, b] = channelsOf(colour) as [number, number, number]
      expect(colourOf(r, g, b)).toBe(colour)
    }
  })

  test('know grey of every brightness between black and white, and no other colour in it', () => {
    const names = Array.from({ length: 256 }, (_, level) => colourOf(level, level, level))
    // v ≤ 10 is black up to 25 of 255, v > 90 is white from 230 on.
    expect(names.slice(0, 26).every((name) => name === COLOURS.black)).toBe(true)
    expect(names.slice(26, 230).every((name) => name === COLOURS.grey)).toBe(true)
    expect(names.slice(230).every((name) => name === COLOURS.white)).toBe(true)
  })
})
