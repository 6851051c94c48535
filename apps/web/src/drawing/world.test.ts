import type { RobotView } from '@botgarten/lab'
import { defaultConfig, type Obstacle } from '@botgarten/simulation'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { boRadius, grabbedAt, hitOf, roundHit } from './grab.ts'
import type { Command } from './commands.ts'
import { drawResting, drawWorld, type Scene } from './world.ts'

const floor = { width: 200, height: 100 }
const bo: RobotView = {
  id: 'bo',
  pose: { x: 50, y: 40, heading: 90 },
  motors: { B: 0, C: 0 },
  led: null,
  display: [],
  frequency: null,
  speech: null,
  bumps: 0,
  trying: false,
  touching: [],
  rays: {},
  trail: [],
  tones: [],
  lit: null,
  problem: null,
}
const crate: Obstacle = {
  id: 'crate',
  pose: { x: 120, y: 50, heading: 30 },
  shape: { kind: 'rectangle', width: 60, height: 20 },
  colour: '#0057A6',
} as Obstacle
const scene: Scene = {
  floor,
  scale: 2,
  seen: { x: 0, y: 0, width: 1000, height: 800 },
  view: { robots: [bo] },
  configs: new Map([['bo', defaultConfig]]),
  things: [{ pose: crate.pose, thing: crate }],
  moving: [{ pose: crate.pose, thing: crate }],
  resting: [],
  colours: ['#F28C45', '#5AA9DE'],
  trails: [],
  sensing: null,
  ghosts: [],
  chosen: null,
  gap: null,
  lights: () => false,
  strong: false,
}
const all = (shapes: readonly Command[]): readonly Command[] =>
  shapes.flatMap((shape) => [shape, ...(shape.kind === 'group' ? all(shape.shapes) : [])])
const group = (drawn: readonly Command[], index: number) => {
  const found = drawn[index]
  if (found?.kind !== 'group') throw new Error('no group')
  return found
}
const written = (drawn: readonly Command[]) =>
  all(drawn).flatMap((shape) => (shape.kind === 'text' ? [shape.text] : []))

describe('the world as it is painted', () => {
  test('things lie under robots, each at its place, y down, turned clockwise', () => {
    const drawn = drawWorld(scene)
    expect(group(drawn, 0)).toMatchObject({ x: 240, y: 100, scale: 2 })
    expect(group(group(drawn, 0).shapes, 1)).toMatchObject({ turn: -30 })
    expect(group(drawn, 1)).toMatchObject({ x: 100, y: 120, turn: 0, scale: 2 })
  })

  test('a shadow falls the same way however its thing is turned', () => {
    for (const heading of [0, 90, 211]) {
      const turned = { ...scene, moving: [{ pose: { ...crate.pose, heading }, thing: crate }] }
      expect(group(group(drawWorld(turned), 0).shapes, 0)).toMatchObject({ x: 3, y: 4, opacity: 0.12 })
    }
  })

  test('a robot that only moves is the same drawing elsewhere', () => {
    const later = { ...bo, pose: { x: 60, y: 40, heading: 80 } }
    const [first, second] = [drawWorld(scene), drawWorld({ ...scene, view: { robots: [later] } })]
    expect(group(second, 1).shapes[0]).toBe(group(first, 1).shapes[0])
    expect(group(second, 1)).toMatchObject({ x: 120, y: 120, turn: 10 })
  })

  test('its lamp, its display and what lights up change the drawing', () => {
    const plain = JSON.stringify(drawWorld(scene))
    const changed = [
      { ...scene, view: { robots: [{ ...bo, led: 'red' as const }] } },
      { ...scene, view: { robots: [{ ...bo, display: ['hello'] }] } },
      { ...scene, view: { robots: [{ ...bo, touching: ['crate'] }] } },
      { ...scene, lights: (_: string, part: string) => part === 'lamp' },
    ].map((one) => JSON.stringify(drawWorld(one)))
    expect(new Set([plain, ...changed]).size).toBe(5)
  })

  test('a second robot has its number and its own colour', () => {
    const several = { ...scene, view: { robots: [bo, { ...bo, id: 'bo2' }] } }
    const configs = new Map([...scene.configs, ['bo2', defaultConfig]])
    const drawn = drawWorld({ ...several, configs })
    expect(written(drawn)).toEqual(['2'])
    expect(JSON.stringify(drawn)).toContain('#5AA9DE')
  })

  test('only the robot that is asked for shows what its sensors read', () => {
    const ray = { fromX: 50, fromY: 45, toX: 50, toY: 95, distance: 50 }
    const seeing = { ...bo, rays: { '4': [ray] } } as RobotView
    expect(written(drawWorld({ ...scene, view: { robots: [seeing] } }))).toEqual([])
    expect(written(drawWorld({ ...scene, view: { robots: [seeing] }, sensing: 'bo' }))).toEqual(['50'])
  })

  test('of many things that rest there is one picture, the same shapes for as long as they rest', () => {
    const things = Array.from({ length: 10 }, () => ({ pose: crate.pose, thing: crate }))
    const place = { x: 0, y: 0, width: 400, height: 200 }
    expect(drawResting(things, floor, 2, place)).toMatchObject([{ kind: 'group', still: place }])
    expect(drawResting(things.slice(0, 2), floor, 2, place)).toHaveLength(2)
    const resting = drawResting(things, floor, 2, place)
    expect(drawWorld({ ...scene, moving: [], resting })[0]).toBe(resting[0])
  })

  test('a robot that stood there is grey, one that would stand there is pale, both with their names', () => {
    const ghost = { config: defaultConfig, pose: { x: 20, y: 20, heading: 0 }, label: 'here', labelWidth: 30 }
    const [was, would] = [true, false].map((grey) => drawWorld({ ...scene, ghosts: [{ ...ghost, grey }] }))
    expect(written(was!)).toEqual(['here'])
    const colours = (drawn: readonly Command[]) => JSON.stringify(drawn).includes('"#FFEBCB"')
    expect(group(was!, 1)).toMatchObject({ x: 40, y: 160, turn: 90, opacity: 0.35 })
    expect([colours(was!.slice(1, 2)), colours(would!.slice(2, 3))]).toEqual([false, true])
  })
})

describe('what a finger takes', () => {
  test('is a robot before a thing, and nothing where neither is', () => {
    const over = { ...scene, things: [{ pose: { ...bo.pose }, thing: crate }] }
    expect(grabbedAt(over, { x: 100, y: 120 })).toMatchObject({ kind: 'robot', id: 'bo' })
    expect(grabbedAt(scene, { x: 240, y: 100 })).toMatchObject({ kind: 'thing', id: 'crate' })
    expect(grabbedAt(scene, { x: 380, y: 10 })).toBeNull()
  })

  test('the handle of what is chosen comes before all', () => {
    const hit = roundHit(boRadius, 2)
    const chosen = { at: { x: 100, y: 120 }, turn: 0, hit, handle: { x: 100, y: 120 } }
    expect(grabbedAt({ ...scene, chosen }, { x: 100, y: 120 })).toEqual({ kind: 'turn' })
  })

  test('of a turned thing is its turned shape', () => {
    const [cos, sin] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)]
    // Along its long side, 58 of 60 px from the middle: up to the right on the screen.
    expect(grabbedAt(scene, { x: 240 + 58 * cos, y: 100 - 58 * sin })).not.toBeNull()
    expect(grabbedAt(scene, { x: 240 + 58 * cos, y: 100 + 58 * sin })).toBeNull()
  })

  test('is never smaller than a finger, whatever the scale', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 0.1, max: 8, noNaN: true }),
        fc.integer({ min: 1, max: 90 }),
        (scale, radius) => {
          const { width, height } = hitOf({ shape: { kind: 'circle', radius } }, scale)
          expect(Math.min(width, height)).toBeGreaterThanOrEqual(44)
        },
      ),
    )
  })
})
