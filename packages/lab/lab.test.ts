import type { Program } from '@botgarten/programs'
import { paintFloor } from '@botgarten/simulation'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { createLab, type Check, type Document } from './index.ts'
import { block, drive, eye, forever, net, program, turn, worldWith } from './testing/scene.ts'

const world = worldWith()
const floor = paintFloor(world)
const bothEyes = net()

const documentOf = (main: Program): Document => ({ programs: { main }, world, brains: {} })
function labWith(main: Program, checks: readonly Check[] = []) {
  const lab = createLab()
  lab.load(documentOf(main), floor, { seed: 1, checks })
  return lab
}
const robotIn = (lab: ReturnType<typeof createLab>) => lab.view().robots[0]!
/** Straight links, both wheels as fast as the eyes see far. */
function taught(lab: ReturnType<typeof createLab>) {
  lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.5)
  lab.setWeight('net', 'eyeRight', 'wheelRight', 0.5)
  return lab
}

describe('a lab', () => {
  it('stands still until it is started, and stops where it is', () => {
    const lab = labWith(program(drive('far', 50, 500)))
    lab.advance(60)
    expect(robotIn(lab).pose).toEqual({ x: 200, y: 100, heading: 90 })
    lab.start()
    lab.advance(60)
    const { pose } = robotIn(lab)
    expect(pose.y).toBeCloseTo(100 + 17.6, 0)
    lab.stop()
    lab.advance(60)
    expect(robotIn(lab).pose).toEqual(pose)
    expect(lab.view().phase).toBe('ready')
    lab.reset()
    expect(robotIn(lab).pose).toEqual({ x: 200, y: 100, heading: 90 })
  })

  it('rule 3: a program that ends stops the motors, and the clock once no check needs it any more', () => {
    const lab = labWith(program(drive('short', 100, 10)))
    lab.start()
    lab.advance(600)
    expect(lab.view()).toMatchObject({ phase: 'ended' })
    expect(lab.view().seconds).toBeLessThan(1)
    expect(robotIn(lab).motors).toMatchObject({ B: 0, C: 0 })
    const watched = labWith(program(drive('short', 100, 10)), [
      { id: 'stays', kind: 'stays', numbers: { obstacle: 'box', cm: 400, percent: 3 }, seconds: 5 },
    ])
    watched.start()
    watched.advance(600)
    expect(watched.view().checks).toMatchObject([{ id: 'stays', passed: true }])
  })

  it('shows what a net would give while it stands, and what it gave while it runs', () => {
    const lab = taught(labWith(program(forever(bothEyes))))
    const { terms, outputs } = lab.view().networks['net']!
    expect(terms).toHaveLength(4)
    expect(outputs['eyeLeft']).toBeGreaterThan(0)
    expect(outputs['wheelLeft']).toBeCloseTo(outputs['eyeLeft']! * 0.5, 12)
    lab.start()
    lab.advance(1)
    expect(lab.view().networks['net']!.outputs['wheelRight']).toBeCloseTo(robotIn(lab).motors['B']!, 12)
  })

  const wait = block('wait', 'robControls_wait_time', {
    values: { WAIT: block('ms', 'math_number', { fields: { NUM: '1000' } }) },
  })
  const weightIn = (lab: ReturnType<typeof createLab>, to: string) =>
    lab.view().networks['net']!.terms.find((term) => term.from === 'eyeLeft' && term.to === to)!.weight

  it('a knob that is turned in a pause makes no run that never was: it says what would be', () => {
    const lab = taught(labWith(program(forever(bothEyes))))
    expect(lab.view().networks['net']!.ran).toBe(false)
    lab.start()
    lab.advance(10)
    lab.pause()
    const ran = lab.view().networks['net']!
    expect(ran.ran).toBe(true)
    expect(ran.outputs['wheelLeft']).toBeCloseTo(robotIn(lab).motors['C']!, 12)
    lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.25)
    const would = lab.view().networks['net']!
    expect(would.ran).toBe(false)
    expect(would.outputs['eyeLeft']).toBe(ran.outputs['eyeLeft'])
    expect(would.outputs['wheelLeft']).toBeCloseTo(ran.outputs['eyeLeft']! * 0.25, 12)
    lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.5)
    expect(lab.view().networks['net']).toEqual(ran)
    lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.25)
    lab.resume()
    lab.advance(1)
    expect(lab.view().networks['net']).toMatchObject({ ran: true })
    expect(robotIn(lab).motors['C']).toBeCloseTo(lab.view().networks['net']!.outputs['wheelLeft']!, 12)
  })

  it('a network that runs once a second shows the weights of its own run until the next', () => {
    const lab = taught(labWith(program(forever(bothEyes, wait))))
    lab.start()
    lab.advance(10)
    lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.25)
    lab.advance(10)
    expect(weightIn(lab, 'wheelLeft')).toBe(0.5)
    lab.advance(60)
    expect(weightIn(lab, 'wheelLeft')).toBe(0.25)
    expect(lab.view().networks['net']!.ran).toBe(true)
    // Of a moment between the turn of the knob and the next run, the same is told.
    lab.goTo(20)
    expect(lab.view().networks['net']).toMatchObject({ ran: false })
    lab.goTo(5)
    expect(lab.view().networks['net']).toMatchObject({ ran: true })
  })

  it('a network that has not run since Start has no numbers', () => {
    const lab = taught(labWith(program(wait, forever(bothEyes))))
    lab.start()
    lab.advance(10)
    expect(lab.view().networks).toEqual({})
    lab.advance(60)
    expect(lab.view().networks['net']).toMatchObject({ ran: true })
  })

  it('one neuron without a sensor does not blind the others', () => {
    const lonely = net('net', '', [eye('eyeLeft', 2), eye('none', 4)])
    const { outputs } = labWith(program(forever(lonely))).view().networks['net']!
    expect(outputs['eyeLeft']).toBeGreaterThan(0)
    expect(outputs['none']).toBe(0)
  })

  it('a knob that is moved while it runs is another speed in the next tick', () => {
    const lab = taught(labWith(program(forever(bothEyes))))
    lab.start()
    lab.advance(10)
    lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0)
    lab.advance(1)
    expect(robotIn(lab).motors['C']).toBe(0)
    expect(robotIn(lab).motors['B']).toBeGreaterThan(0)
  })

  it('rule 10: steps by tick, by block and by net, and goes on from there', () => {
    const lab = labWith(program(forever(bothEyes, turn('turn', 50, 5))))
    lab.step('tick')
    expect(lab.view()).toMatchObject({ phase: 'paused', tick: 1 })
    const seen = [1, 2, 3, 4].map(() => {
      lab.step('block')
      return robotIn(lab).lit
    })
    expect(new Set(seen)).toEqual(new Set(['net', 'turn', 'forever'].filter((id) => seen.includes(id))))
    expect(seen).toContain('net')
    const before = lab.view().tick
    lab.step('network')
    expect(lab.view().tick).toBeGreaterThan(before)
    lab.resume()
    lab.advance(60)
    expect(lab.view().tick).toBeGreaterThan(before + 60)
  })

  it('rule 10: a run that was stepped block by block is the run that was not', () => {
    const main = program(forever(bothEyes, turn('turn', 50, 5), drive('bit', 30, 2)))
    const stepped = taught(labWith(main))
    for (let step = 0; step < 100; step++) stepped.step('block')
    const whole = taught(labWith(main))
    whole.start()
    whole.advance(stepped.view().tick)
    expect(whole.hash()).toBe(stepped.hash())
  })

  it('rule 9: blocks that are edited while it runs begin again where the robot stands', () => {
    const lab = labWith(program(forever(drive('a', 50, 1))))
    lab.start()
    lab.advance(120)
    const { y } = robotIn(lab).pose
    lab.edit({ main: program(forever(turn('b', 50, 1))) })
    lab.advance(60)
    expect(lab.view().phase).toBe('running')
    expect(robotIn(lab).pose.y).toBeCloseTo(y, 6)
    expect(robotIn(lab).pose.heading).not.toBeCloseTo(90, 0)
  })

  it('rule 9: on a card a robot whose blocks are edited while it runs begins again at its start', () => {
    const lab = labWith(program(forever(drive('a', 50, 1))))
    const start = robotIn(lab).pose
    lab.start()
    lab.advance(120)
    expect(robotIn(lab).pose).not.toEqual(start)
    lab.edit({ main: program(forever(turn('b', 50, 1))) }, true)
    expect(lab.view()).toMatchObject({ phase: 'running', tick: 0 })
    expect(robotIn(lab).pose).toEqual(start)
    lab.stop()
    lab.advance(1)
    lab.edit({ main: program(forever(drive('c', 50, 1))) }, true)
    expect(robotIn(lab).pose).toEqual(start)
  })

  it('blocks that are only laid out differently change nothing of the run', () => {
    const main = program(forever(bothEyes))
    const lab = taught(labWith(main))
    lab.start()
    lab.advance(30)
    lab.edit({ main: { ...main, stacks: main.stacks.map((stack) => ({ ...stack, x: 300 })) } })
    expect(lab.view().tick).toBe(30)
  })

  it('arrow keys drive it with and without a program', () => {
    const lab = labWith(program(forever(turn('turn', 30, 5))))
    lab.press('up', true)
    lab.advance(60)
    lab.press('up', false)
    expect(robotIn(lab).pose.y).toBeGreaterThan(110)
    const { pose } = robotIn(lab)
    lab.advance(60)
    expect(robotIn(lab).pose).toEqual(pose)
    lab.start()
    lab.press('up', true)
    lab.advance(30)
    expect(robotIn(lab).pose.heading).toBeCloseTo(90, 6)
    lab.press('up', false)
    lab.advance(30)
    expect(robotIn(lab).pose.heading).not.toBeCloseTo(90, 0)
  })

  describe('rule 9: after a program has ended', () => {
    const ended = () => {
      const lab = labWith(program(drive('far', 60, 30)))
      lab.start()
      lab.advance(600)
      expect(lab.view().phase).toBe('ended')
      return lab
    }

    it('Start begins where it began, the pushed box too: the same program does the same', () => {
      const start = robotIn(labWith(program())).pose
      const lab = labWith(program(drive('far', 60, 170)))
      const box = lab.view().obstacles[0]!.pose
      lab.start()
      lab.advance(900)
      expect(lab.view().phase).toBe('ended')
      const [end, hash] = [lab.view().obstacles[0]!.pose, lab.hash()]
      expect(end).not.toEqual(box)
      lab.start()
      expect(robotIn(lab).pose).toEqual(start)
      expect(lab.view().obstacles[0]!.pose).toEqual(box)
      lab.advance(900)
      expect(lab.hash()).toBe(hash)
    })

    it('a step begins it there too', () => {
      const lab = ended()
      lab.step('tick')
      expect(robotIn(lab).pose.y).toBeLessThan(102)
    })

    it('a robot that a hand has set down or driven since starts from there', () => {
      const placed = ended()
      const came = placed.place('bo', { x: 60, y: 60, heading: 0 })
      placed.start()
      expect(robotIn(placed).pose).toEqual(came)
      const driven = ended()
      const end = robotIn(driven).pose
      driven.press('up', true)
      driven.advance(30)
      driven.press('up', false)
      driven.advance(5)
      const { pose } = robotIn(driven)
      expect(pose.y).toBeGreaterThan(end.y + 2)
      driven.start()
      expect(robotIn(driven).pose).toEqual(pose)
      driven.advance(600)
      driven.start()
      expect(robotIn(driven).pose.y).toBe(100)
    })

    it('a program that was stopped goes on from where everything stands', () => {
      const lab = labWith(program(drive('far', 60, 30)))
      lab.start()
      lab.advance(20)
      lab.stop()
      const { pose } = robotIn(lab)
      lab.start()
      expect(robotIn(lab).pose).toEqual(pose)
    })

    it('where goals count, a program that was stopped begins at its start, unless a hand has moved or driven the robot', () => {
      const goal = {
        id: 'stays',
        kind: 'stays',
        numbers: { obstacle: 'box', cm: 400, percent: 3 },
        seconds: 5,
      }
      const lab = labWith(program(drive('far', 60, 30)), [goal])
      const stopped = () => {
        lab.start()
        lab.advance(20)
        lab.stop()
        return robotIn(lab).pose
      }
      expect(stopped().y).toBeGreaterThan(101)
      lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.5)
      lab.start()
      expect(robotIn(lab).pose).toEqual({ x: 200, y: 100, heading: 90 })
      stopped()
      const came = lab.place('bo', { x: 60, y: 60, heading: 0 })
      lab.start()
      expect(robotIn(lab).pose).toEqual(came)
      stopped()
      lab.press('up', true)
      lab.advance(30)
      lab.press('up', false)
      lab.advance(5)
      const driven = robotIn(lab).pose
      lab.start()
      expect(robotIn(lab).pose).toEqual(driven)
    })
  })

  it('a robot that was set down by hand starts from there, one that was moved while it ran does not', () => {
    const lab = labWith(program(forever(bothEyes)))
    const came = lab.place('bo', { x: 60, y: 60, heading: 0 })
    lab.reset()
    expect(robotIn(lab).pose).toEqual(came)
    lab.start()
    lab.place('bo', { x: 300, y: 100, heading: 0 })
    expect(robotIn(lab).pose).toMatchObject({ x: 300, y: 100 })
    lab.reset()
    expect(robotIn(lab).pose).toEqual(came)
  })
})

describe('rules 2, 7, 8: the same start state, seed and inputs are the same run', () => {
  /** What a hand does in between, by tick. */
  type Hand = { readonly at: number; readonly weight: number; readonly x: number; readonly key: boolean }
  const hands: fc.Arbitrary<Hand[]> = fc.array(
    fc.record({
      at: fc.nat(900),
      weight: fc.double({ min: 0, max: 1, noNaN: true }),
      x: fc.double({ min: 30, max: 370, noNaN: true }),
      key: fc.boolean(),
    }),
    { maxLength: 12 },
  )

  function play(lab: ReturnType<typeof createLab>, given: readonly Hand[], ticks: number) {
    lab.start()
    for (let tick = 0; tick < ticks; tick++) {
      for (const { at, weight, x, key } of given) {
        if (at !== tick) continue
        lab.setWeight('net', 'eyeLeft', 'wheelRight', weight)
        lab.place('box', { x, y: 200, heading: 0 })
        lab.press('left', key)
      }
      lab.advance(1)
    }
    return lab
  }

  it('played twice it has one hash, and going back to any tick and on again has it too', () => {
    fc.assert(
      fc.property(hands, fc.nat(999), (given, back) => {
        const main = program(forever(bothEyes))
        const once = play(taught(labWith(main)), given, 1000)
        const end = once.hash()
        expect(play(taught(labWith(main)), given, 1000).hash()).toBe(end)
        const there = play(taught(labWith(main)), given, back)
        once.goTo(back)
        expect(once.view().tick).toBe(back)
        expect(once.hash()).toBe(there.hash())
        expect(once.state()).toEqual(there.state())
        once.goTo(1000)
        expect(once.hash()).toBe(end)
      }),
      { numRuns: 15 },
    )
  })

  it('being looked at changes nothing', () => {
    const quiet = taught(labWith(program(forever(bothEyes))))
    const watched = taught(labWith(program(forever(bothEyes))))
    for (const lab of [quiet, watched]) lab.start()
    for (let tick = 0; tick < 700; tick++) {
      for (const lab of [quiet, watched]) lab.advance(1)
      watched.view()
      watched.state()
    }
    expect(watched.hash()).toBe(quiet.hash())
  })
})
