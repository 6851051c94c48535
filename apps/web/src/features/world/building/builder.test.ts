import 'fake-indexeddb/auto'
import type { Area } from '@botgarten/simulation'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import type { LabUi } from '#lab/ui.svelte.ts'
import { BuildMode } from '../build-mode.svelte.ts'
import { Builder } from './builder.svelte.ts'

beforeEach(() => void screen())
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

/** A child builds in the world of the card Friendship. */
function building() {
  const { session } = sessionOf()
  const mode = new BuildMode(session, {} as LabUi, () => Promise.reject(new Error('not needed')))
  const builder = new Builder(mode)
  const before = session.lab.document.world
  const added = () => session.lab.document.world.obstacles.slice(before.obstacles.length)
  const tap = (x: number, y: number) => {
    builder.draw({ x, y }, 'start')
    builder.draw({ x, y }, 'end')
  }
  return { session, builder, before, added, tap }
}

const area: Area = {
  ...{ id: 'pond', shape: { kind: 'circle', radius: 20 }, pose: { x: 100, y: 100, heading: 0 } },
  colour: '#77E8FF',
}

describe('a wall', () => {
  test('is drawn by taps from point to point, the next one from where the last one ended', () => {
    const { builder, added, tap } = building()
    builder.pen('wall', false)
    tap(20, 30)
    expect(added()).toHaveLength(0)
    tap(120, 30)
    tap(120, 90)
    expect(added().map(({ pose: { x, y } }) => ({ x, y }))).toEqual([
      { x: 70, y: 30 },
      { x: 120, y: 60 },
    ])
    expect(builder.stroke).toEqual([{ x: 120, y: 90 }])
    tap(120, 91)
    expect(added()).toHaveLength(2)
    expect(builder.stroke).toEqual([])
  })

  test('that is drawn in one go is over where the hand lets go', () => {
    const { builder, added } = building()
    builder.pen('wall', false)
    builder.draw({ x: 20, y: 30 }, 'start')
    builder.draw({ x: 60, y: 30 }, 'move')
    builder.draw({ x: 120, y: 30 }, 'end')
    expect(added()).toHaveLength(1)
    expect(builder.stroke).toEqual([])
  })
})

test('an area that is moved is a step of the world, and a robot is placed by the session', () => {
  const { session, builder, before } = building()
  builder.add({ kind: 'areas', thing: area })
  const to = { x: 140, y: 60, heading: 90 }
  for (const phase of ['start', 'move', 'end'] as const) builder.place('pond', to, phase)
  expect(session.lab.document.world.areas.at(-1)).toEqual({ ...area, pose: to })
  const robot = before.robots[0]!.id
  builder.place(robot, to, 'end')
  expect(session.lab.document.world.robots[0]!.pose).toEqual(to)
})

test.each(['Delete', 'Backspace'])('%s removes what is selected, another key does not', (key) => {
  const { session, builder, before } = building()
  builder.add({ kind: 'areas', thing: area })
  const press = (one: string) => builder.key({ key: one, ctrlKey: false, metaKey: false } as KeyboardEvent)
  expect(press('x')).toBe(false)
  expect(session.lab.document.world.areas).toHaveLength(before.areas.length + 1)
  expect(press(key)).toBe(true)
  expect(session.lab.document.world.areas).toEqual(before.areas)
})
