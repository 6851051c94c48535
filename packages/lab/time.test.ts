import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { Lab } from './index.ts'
import { afresh, begin, execute, until, type Act, type Course } from './testing/course.ts'
import { drive, forever, labWith, net, program, turn } from './testing/scene.ts'

const minute = 3600

/** All that is to be seen of a moment but the line of time itself, and its hash. */
const seen = (lab: Lab) => {
  const { time, robots, ...rest } = lab.view()
  void time
  return {
    hash: lab.hash(),
    ...rest,
    phase: null,
    robots: robots.map(({ trail, tones, ...one }) => (void [trail, tones], one)),
  }
}
const running = (main = program(forever(net()))) => {
  const lab = labWith(main)
  lab.start()
  return lab
}

describe('rule 9: the timeline', () => {
  it('starts at each Start', () => {
    const lab = running()
    lab.advance(500)
    expect(lab.view().time).toMatchObject({ first: 0, now: 500, past: false })
    lab.start()
    lab.advance(20)
    expect(lab.view().time).toMatchObject({ first: 0, now: 20 })
  })

  it('keeps the last ten simulated minutes and says where it begins', () => {
    const lab = running()
    lab.advance(12 * minute)
    const { first, now } = lab.view().time
    expect(now).toBe(12 * minute)
    expect(now - first).toBeGreaterThanOrEqual(10 * minute)
    expect(now - first).toBeLessThan(10 * minute + 300)
    lab.goTo(0)
    expect(lab.view().tick).toBe(first)
    lab.goTo(Infinity)
    expect(lab.view()).toMatchObject({ tick: now, time: { past: false } })
  })

  it('shows the weights and the things of then, and keeps those of now in the document', () => {
    const lab = running()
    const { pose } = lab.view().obstacles[0]!
    lab.advance(100)
    lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.9)
    lab.place('box', { x: 60, y: 300, heading: 0 })
    lab.advance(100)
    lab.goTo(90)
    expect(lab.view().brains['net']!.weights['eyeLeft']).toEqual({ wheelLeft: 0.5 })
    expect(lab.view().obstacles[0]!.pose).toEqual(pose)
    expect(lab.document().brains['net']!.weights['eyeLeft']).toEqual({ wheelLeft: 0.9 })
    expect(lab.document().world.obstacles[0]!.pose).toMatchObject({ x: 60, y: 300 })
    expect(lab.view().time).toMatchObject({ past: true, now: 200 })
    expect(lab.view().time.present[0]).toMatchObject({ id: 'bo' })
    lab.goTo(200)
    expect(lab.view().brains['net']!.weights['eyeLeft']).toEqual({ wheelLeft: 0.9 })
  })

  it('going on from there makes them the present; the other future comes back once, and can be left again', () => {
    const lab = running()
    lab.advance(100)
    lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.9)
    lab.place('box', { x: 60, y: 300, heading: 0 })
    lab.advance(100)
    const there = seen(lab)
    lab.goTo(90)
    lab.resume()
    expect(lab.view()).toMatchObject({ phase: 'running', time: { past: false, now: 90 } })
    expect(lab.document().brains['net']!.weights['eyeLeft']).toEqual({ wheelLeft: 0.5 })
    expect(lab.document().world.obstacles[0]!.pose).toMatchObject({ x: 200, y: 260 })
    expect(lab.view().time.other).toBe(true)
    lab.advance(10)
    const here = seen(lab)
    expect(lab.swap()).toBe(true)
    expect(seen(lab)).toEqual(there)
    expect(lab.document().brains['net']!.weights['eyeLeft']).toEqual({ wheelLeft: 0.9 })
    expect(lab.document().world.obstacles[0]!.pose).toMatchObject({ x: 60, y: 300 })
    lab.swap()
    expect(seen(lab)).toEqual(here)
    expect(lab.document().brains['net']!.weights['eyeLeft']).toEqual({ wheelLeft: 0.5 })
    expect(lab.document().world.obstacles[0]!.pose).toMatchObject({ x: 200, y: 260 })
  })

  it('a hand that changes something in the past goes on from there', () => {
    const lab = running()
    lab.advance(200)
    lab.goTo(50)
    lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.1)
    expect(lab.view()).toMatchObject({ phase: 'paused', tick: 50, time: { past: false, now: 50 } })
    lab.swap()
    expect(lab.view().tick).toBe(200)
    expect(lab.document().brains['net']!.weights['eyeLeft']).toEqual({ wheelLeft: 0.5 })
  })

  it.each([
    ['Start', (lab: Lab) => lab.start()],
    ['edited blocks', (lab: Lab) => lab.edit({ main: program(drive('a', 50, 1)) })],
    ['a world built again', (lab: Lab) => lab.rebuild(lab.document())],
  ])('%s: ends the other future', (_, end) => {
    const lab = running()
    lab.advance(100)
    lab.goTo(50)
    lab.branch()
    end(lab)
    expect(lab.swap()).toBe(false)
  })

  it('editing a block ends the timeline, in the present', () => {
    const lab = running()
    lab.advance(100)
    const { pose } = lab.view().robots[0]!
    lab.goTo(50)
    lab.edit({ main: program(forever(turn('a', 50, 1))) })
    expect(lab.view()).toMatchObject({ tick: 0, time: { first: 0, now: 0, past: false } })
    expect(lab.view().robots[0]!.pose).toEqual(pose)
  })

  it('Stop ends the run where it is now, not where one looks', () => {
    const lab = running()
    lab.advance(100)
    const { pose } = lab.view().robots[0]!
    lab.goTo(50)
    lab.stop()
    expect(lab.view()).toMatchObject({ phase: 'ready', tick: 100 })
    expect(lab.view().robots[0]!.pose).toEqual(pose)
    lab.goTo(30)
    expect(lab.view()).toMatchObject({ phase: 'paused', tick: 30 })
    lab.goTo(100)
    expect(lab.view()).toMatchObject({ phase: 'ready', tick: 100 })
  })

  it('what a hand moves after Stop is there again when one comes back from the past', () => {
    const lab = running()
    lab.advance(100)
    lab.stop()
    const came = lab.place('bo', { x: 60, y: 60, heading: 0 })
    lab.goTo(30)
    expect(lab.view().robots[0]!.pose).not.toEqual(came)
    lab.goTo(100)
    expect(lab.view().robots[0]!.pose).toEqual(came)
  })

  it('a key that is let go of in the past is up in the present', () => {
    const lab = running()
    lab.advance(60)
    lab.press('up', true)
    lab.advance(60)
    lab.goTo(30)
    lab.press('up', false)
    lab.goTo(120)
    expect(lab.state().keys).toEqual([])
    lab.resume()
    lab.goTo(100)
    expect(lab.state().keys).toEqual(['up'])
    lab.branch()
    expect(lab.state().keys).toEqual([])
  })

  it('says when a hand has changed something', () => {
    const lab = running()
    lab.advance(100)
    for (let pull = 0; pull < 5; pull++) {
      lab.setWeight('net', 'eyeLeft', 'wheelLeft', pull / 10)
      lab.advance(4)
    }
    lab.advance(200)
    lab.place('box', { x: 60, y: 300, heading: 0 })
    expect(lab.view().time.marks).toEqual([
      { kind: 'weight', from: 100, to: 116 },
      { kind: 'place', from: 320, to: 320 },
    ])
    expect(lab.view().time.marks).toBe(lab.view().time.marks)
    lab.goTo(110)
    lab.branch()
    expect(lab.view().time.marks).toEqual([{ kind: 'weight', from: 100, to: 110 }])
  })
})

describe('rule 10: steps in the past', () => {
  it('show what was, up to the present', () => {
    const lab = running(program(forever(net(), turn('turn', 50, 5))))
    lab.advance(100)
    const end = lab.hash()
    lab.goTo(96)
    const lit = [1, 2, 3].map(() => {
      lab.step('block')
      return lab.view().robots[0]!.lit
    })
    expect(lit).toContain('net')
    const { tick } = lab.view()
    lab.goTo(50)
    lab.step('network')
    expect(lab.view().tick).toBeGreaterThan(50)
    expect(tick).toBeLessThanOrEqual(100)
    lab.goTo(99)
    lab.step('tick')
    expect(lab.view()).toMatchObject({ tick: 100, time: { past: false, now: 100 } })
    expect(lab.hash()).toBe(end)
  })
})

describe('rules 2, 8, 9: any moment is the moment that was', () => {
  const body = fc.array(
    fc.oneof(
      fc.constant(net()),
      fc
        .record({ power: fc.integer({ min: -100, max: 100 }), way: fc.integer({ min: 1, max: 30 }) })
        .map(({ power, way }) => drive('drive', power, way)),
      fc.integer({ min: 1, max: 120 }).map((degrees) => turn('turn', 60, degrees)),
    ),
    { minLength: 1, maxLength: 3 },
  )
  const act: fc.Arbitrary<Act> = fc.oneof(
    {
      weight: 4,
      arbitrary: fc.record({ act: fc.constant('advance' as const), ticks: fc.integer({ min: 1, max: 150 }) }),
    },
    fc.record({ act: fc.constant('block' as const) }),
    fc.record({ act: fc.constant('weight' as const), weight: fc.double({ min: -1, max: 1, noNaN: true }) }),
    fc.record({
      act: fc.constant('place' as const),
      id: fc.constantFrom('box', 'bo'),
      x: fc.double({ min: 0, max: 400, noNaN: true }),
      y: fc.double({ min: 0, max: 400, noNaN: true }),
    }),
    fc.record({
      act: fc.constant('key' as const),
      key: fc.constantFrom('up' as const, 'left' as const),
      down: fc.boolean(),
    }),
  )
  const jump = fc.record({
    back: fc.double({ min: 0, max: 1, noNaN: true }),
    goesOn: fc.boolean(),
    redo: fc.boolean(),
  })
  const story = fc.array(fc.record({ acts: fc.array(act, { maxLength: 6 }), jump }), {
    minLength: 1,
    maxLength: 4,
  })

  it('with random programs, hands, jumps, branches and other futures', () => {
    fc.assert(
      fc.property(body, fc.integer({ min: 1, max: 2 }), story, (blocks, robots, chapters) => {
        const unique = [...new Map(blocks.map((one) => [one.id, one])).values()]
        const main = program(forever(...unique))
        const lab = begin(main, robots)
        const expectCourse = (course: Course) => expect(seen(lab)).toEqual(seen(afresh(main, robots, course)))
        let course: Course = []
        let other: Course | null = null
        for (const { acts, jump: to } of chapters) {
          for (const one of acts) course = [...course, execute(lab, one)]
          const end = lab.view().tick
          const tick = Math.floor(end * to.back)
          lab.goTo(tick)
          if (tick < end) expectCourse(until(course, tick))
          if (to.goesOn && tick < end) {
            // Keys that are down in the present stay down: the hand is still there.
            for (const key of ['up', 'left'] as const) lab.press(key, false)
            lab.branch()
            other = course
            course = until(course, tick)
            for (const key of ['up', 'left'] as const)
              if (afresh(main, robots, course).state().keys.includes(key))
                course = [...course, { act: { act: 'key', key, down: false }, from: tick, to: tick }]
          } else lab.goTo(end)
          if (to.redo && other) {
            lab.swap()
            ;[course, other] = [other, course]
            for (const key of ['up', 'left'] as const) {
              const down = afresh(main, robots, course).state().keys.includes(key)
              const tickNow = lab.view().tick
              if (down)
                course = [...course, { act: { act: 'key', key, down: false }, from: tickNow, to: tickNow }]
            }
          }
        }
        expectCourse(course)
      }),
      { numRuns: 20, seed: 9 },
    )
  })
})
