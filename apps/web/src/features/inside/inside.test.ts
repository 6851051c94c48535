import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { level } from '#figures/network/level.svelte.ts'
import { closeSessions, screen, sessionOf } from '#lab/testing/session.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { friendship } from '#storage/testing/sample.ts'
import { Inside } from './inside.svelte.ts'
import { Field } from './model/field.svelte.ts'

let draw: ReturnType<typeof screen>
beforeEach(async () => {
  await freshDevice()
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  draw = screen()
})
afterEach(() => {
  closeSessions()
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/** Friendship with both knobs turned: each eye drives the wheel on its side. */
function opened() {
  const { session } = sessionOf()
  session.learnFirst = () => false
  for (const [eye, wheel] of [
    ['eyeLeft', 'wheelLeft'],
    ['eyeRight', 'wheelRight'],
  ] as const)
    // prettier-ignore
    session.weights.turn('net', eye, wheel, 0.8, 'whole')
  return { session, inside: new Inside(session) }
}
/** Draws frames until the result arrives. */
function drawUntil(isReady: () => boolean): void {
  for (let frame = 0; frame < 2000 && !isReady(); frame += 1) draw()
}
function follows({ drives }: Inside, output = 'wheelLeft') {
  const leave = drives.follow(output)
  const { own } = drives
  vi.advanceTimersByTime(200)
  drawUntil(() => drives.own !== own)
  return leave
}

test('a program without a network has nothing inside', () => {
  const { session } = sessionOf({ ...friendship, programs: {} })
  const inside = new Inside(session)
  expect([inside.net, inside.inputs, inside.outputs, inside.values]).toEqual([null, [], [], []])
})

test('inside the network are its inputs and outputs, and the page closes with the pale robot', () => {
  const { inside } = opened()
  expect(inside.inputs.map(({ id }) => id)).toEqual(['eyeLeft', 'eyeRight'])
  expect(inside.outputs.map(({ id }) => id)).toEqual(['wheelLeft', 'wheelRight'])
  inside.page = 'why'
  inside.drives.show({ without: 'eyeLeft' })
  inside.close()
  expect([inside.page, inside.drives.otherwise, inside.ghost]).toEqual([null, null, null])
})

describe('from the moment that is shown', () => {
  test('Bo would drive as it then drives, and no pale one does where nothing is left out', () => {
    const { session, inside } = opened()
    follows(inside)
    const { own, pale } = inside.drives
    expect([own!.poses.length, own!.poses[0], pale]).toEqual([241, session.lab.view.robots[0]!.pose, null])
    session.start()
    const stop = session.lab.run()
    while (session.lab.view.tick < 60) draw()
    stop()
    const { tick, robots } = session.lab.view
    expect(own!.poses[tick]).toEqual(robots[0]!.pose)
  })

  test('a pale one drives without an input, another way, and stands where it would be after four seconds', () => {
    const { inside } = opened()
    inside.drives.show({ without: 'eyeLeft' })
    follows(inside)
    const { own, pale, ghost } = inside.drives
    expect(pale!.poses[0]).toEqual(own!.poses[0])
    expect(pale!.poses.at(-1)).not.toEqual(own!.poses.at(-1))
    expect(ghost).toEqual(pale!.poses.at(-1))
    inside.drives.show(null)
    expect([inside.drives.pale, inside.ghost]).toEqual([null, null])
  })

  test('the smallest change that turns a decision round is found, and the pale one drives with it', () => {
    const { session, inside } = opened()
    // Both eyes see equally far: 0.8 of it is more than 0.4 of it, so that Bo turns right.
    session.weights.turn('net', 'eyeRight', 'wheelRight', 0.4, 'whole')
    inside.drives.show('change')
    follows(inside)
    const { turning, own, pale } = inside.drives
    expect(turning).toMatchObject({ asked: { kind: 'turn' }, was: 1 })
    expect(turning!.change).not.toBeNull()
    expect(pale!.poses.at(-1)).not.toEqual(own!.poses.at(-1))
  })

  test('the search depends on the range of the knobs: it reads that at once, so that another level starts it again', () => {
    const { inside } = opened()
    const range = vi.spyOn(level, 'scale', 'get')
    const leave = inside.drives.follow('wheelLeft')
    expect(range).toHaveBeenCalled()
    leave()
    range.mockRestore()
  })

  test('nothing is imagined while Bo drives, or once the page is left', () => {
    const { session, inside } = opened()
    const leave = inside.drives.follow('wheelLeft')
    leave()
    vi.advanceTimersByTime(200)
    for (let frame = 0; frame < 30; frame += 1) draw()
    expect(inside.drives.own).toBeNull()
    session.start()
    inside.drives.follow('wheelLeft')
    vi.advanceTimersByTime(200)
    for (let frame = 0; frame < 30; frame += 1) draw()
    expect(inside.drives.own).toBeNull()
  })
})

describe('what Bo would do all over the floor', () => {
  test('is read only once it is switched on, with the heading of Bo in steps of 5°', () => {
    const { session, inside } = opened()
    const { field } = inside
    session.apply({ kind: 'place', id: 'bo', after: { x: 440, y: 170, heading: 148 } })
    field.follow()
    for (let frame = 0; frame < 30; frame += 1) draw()
    expect(field.readings).toBeNull()
    field.on = true
    field.follow()
    drawUntil(() => field.readings !== null)
    const { poses, inputs } = field.readings!
    expect(new Set(poses.map(({ heading }) => heading))).toEqual(new Set([150]))
    expect(inputs).toHaveLength(poses.length)
    // Inside the square on the floor there is no room; elsewhere both eyes read cm.
    expect(inputs).toContain(null)
    for (const row of inputs) if (row) expect(row.every((cm) => cm >= 0 && cm <= 255)).toBe(true)
    const before = field.readings
    field.follow()
    for (let frame = 0; frame < 30; frame += 1) draw()
    expect(field.readings).toBe(before)
  })

  test('has the heading 0 in a moment of the past in which the robot did not exist', () => {
    const { session, inside } = opened()
    const { net, standpoint, view } = inside
    const past = { session, net, standpoint, view: { ...view, robots: [] } } as unknown as Inside
    const field = new Field(past)
    field.on = true
    field.follow()
    drawUntil(() => field.readings !== null)
    expect(field.readings!.poses[0]!.heading).toBe(0)
  })
})
