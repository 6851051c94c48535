import type { Drive } from '@botgarten/learning/neural-network/examples'
import { mostOf } from '@botgarten/learning/neural-network/examples'
import { cardConfig } from '@botgarten/simulation'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { block, eye, forever, labWith, net, program, worldWith } from '../testing/scene.ts'
import type { Wheels } from '../inputs/input.ts'
import type { Lab } from '../types.ts'

const drive = (id: string, by: Drive['by'] = 'pad'): Drive => ({ id, by, seed: 1 })
const recording = (id = 'pad-1', by: Drive['by'] = 'pad', every = 6) => ({
  ...{ robot: 'bo', network: 'net', every },
  drive: drive(id, by),
})
const rowsOf = (lab: Lab) => lab.document().brains['net']?.examples?.rows ?? []
const shownRows = (lab: Lab) => lab.view().brains['net']?.examples?.rows ?? []
const ticksOf = (lab: Lab) => rowsOf(lab).map((row) => row[1])
const ahead: Wheels = { left: 40, right: 50 }

const thinks = () => labWith(program(forever(net())))

describe('a recording', () => {
  it('writes a row every 6th tick while a hand is on the pad: readings before the motors, the wheels it holds (14, 15)', () => {
    const lab = thinks()
    lab.place('bo', { x: 200, y: 180, heading: 90 })
    lab.record(recording())
    lab.start()
    lab.advance(12)
    expect(rowsOf(lab)).toEqual([])
    lab.drive(ahead)
    const left = lab.senses().ports.find(({ port }) => port === '2')!.values.distance
    lab.advance(1)
    expect(rowsOf(lab)).toHaveLength(1)
    expect(rowsOf(lab)[0]!.slice(0, 2)).toEqual([0, 12])
    expect(rowsOf(lab)[0]![6]).toBeCloseTo(Number(left), 2)
    expect(rowsOf(lab)[0]!.slice(8)).toEqual([40, 50])
    lab.advance(60)
    lab.drive(null)
    lab.advance(60)
    expect(ticksOf(lab).length).toBeGreaterThan(3)
    expect(ticksOf(lab).every((tick) => tick! % 6 === 0 && tick! < 73)).toBe(true)
    expect(lab.document().brains['net']!.examples!.drives).toEqual([drive('pad-1')])
  })

  it('takes the arrow keys as wheels too', () => {
    const lab = thinks()
    lab.record(recording('keys-1', 'keys'))
    lab.start()
    lab.press('up', true)
    lab.press('left', true)
    lab.advance(7)
    expect(rowsOf(lab)[0]!.slice(8)).toEqual([35, 85])
  })

  it('writes what a program does, whether the network runs or not', () => {
    const power = (id: string, value: number) => block(id, 'math_number', { fields: { NUM: String(value) } })
    const on = block('on', 'robActions_motorDiff_on', {
      fields: { DIRECTION: 'FOREWARD' },
      values: { POWER: power('p', 30) },
    })
    const main = program(
      on,
      forever(block('wait', 'robControls_wait_time', { values: { WAIT: power('ms', 50) } })),
    )
    const loose = { ...main, stacks: [...main.stacks, { x: 0, y: 0, blocks: [net()] }] }
    const lab = labWith(loose)
    lab.record(recording('program-1', 'program'))
    lab.start()
    lab.advance(31)
    expect(rowsOf(lab).map((row) => row.slice(8))).toContainEqual([30, 30])
  })

  it('leaves the run as it is, to the last bit, noise and all', () => {
    const world = worldWith()
    const noisy = {
      ...world,
      robots: world.robots.map((robot) => ({
        ...robot,
        pose: { x: 200, y: 200, heading: 80 },
        config: { ...cardConfig, noise: 10, delay: 3 },
      })),
    }
    const hashWith = (records: boolean) => {
      const lab = labWith(program(forever(net())), noisy)
      if (records) lab.record(recording('pad-1', 'pad', 1))
      lab.start()
      lab.advance(30)
      lab.drive({ left: 80, right: 20 })
      lab.advance(50)
      lab.drive(null)
      lab.advance(50)
      if (records) expect(rowsOf(lab).length).toBeGreaterThan(20)
      return lab.hash()
    }
    expect(hashWith(true)).toBe(hashWith(false))
  })

  it('goes back with time, and the rows of later ticks with the other future (17)', () => {
    const lab = thinks()
    lab.record(recording())
    lab.start()
    // A hand that holds still writes one row and no more.
    for (let left = 0; left < 100; left += 5) {
      lab.drive({ left, right: 50 })
      lab.advance(10)
    }
    const all = rowsOf(lab)
    expect(all.filter((row) => row[1]! < 90).length).toBeGreaterThan(3)
    expect(all.filter((row) => row[1]! >= 150).length).toBeGreaterThan(3)
    lab.goTo(90)
    expect(shownRows(lab)).toEqual(all.filter((row) => row[1]! < 90))
    expect(rowsOf(lab)).toEqual(all)
    lab.goTo(150)
    expect(shownRows(lab)).toEqual(all.filter((row) => row[1]! < 150))
    lab.branch()
    expect(rowsOf(lab)).toEqual(all.filter((row) => row[1]! < 150))
    lab.swap()
    expect(rowsOf(lab)).toEqual(all)
  })

  it('is written again bit for bit from the same inputs, and by going back and forth', () => {
    const wheels = fc.record({
      left: fc.integer({ min: -100, max: 100 }),
      right: fc.integer({ min: -100, max: 100 }),
    })
    const deed = fc.oneof(
      fc.record({ kind: fc.constant('drive' as const), wheels: fc.option(wheels) }),
      fc.record({ kind: fc.constant('remember' as const), wheels }),
      fc.record({ kind: fc.constant('record' as const), on: fc.boolean() }),
    )
    const moments = fc.array(fc.tuple(fc.integer({ min: 1, max: 40 }), deed), { minLength: 2, maxLength: 8 })
    const played = (deeds: typeof moments extends fc.Arbitrary<infer All> ? All : never) => {
      const lab = thinks()
      lab.record(recording())
      lab.start()
      deeds.forEach(([ticks, done], index) => {
        if (done.kind === 'drive') lab.drive(done.wheels)
        else if (done.kind === 'record') lab.record(done.on ? recording(`pad-${index}`) : null)
        else
          lab.remember({
            ...recording(),
            drive: drive(`hand-${index}`, 'hand'),
            wheels: done.wheels,
            others: {},
          })
        lab.advance(ticks)
      })
      return lab
    }
    fc.assert(
      fc.property(moments, fc.nat(), (deeds, at) => {
        const lab = played(deeds)
        const table = lab.document().brains['net']?.examples
        expect(played(deeds).document().brains['net']?.examples).toEqual(table)
        const { now } = lab.view().time
        lab.goTo(at % now)
        lab.goTo(0)
        lab.step('tick')
        while (lab.view().time.past) lab.step('tick')
        expect(lab.view().brains['net']?.examples).toEqual(table)
        lab.goTo(0)
        lab.goTo(now - 1)
        expect(shownRows(lab)).toEqual((table?.rows ?? []).filter((row) => row[1]! < now - 1))
      }),
      { seed: 7, numRuns: 25 },
    )
  })

  it('ends with the run, and stops where there is no room', () => {
    const lab = thinks()
    const rows = Array.from({ length: mostOf.rows - 1 }, (_, k) => [0, k, 0, 0, 0, 1, k % 100, 0, 0, 0])
    lab.setTraining('net', {
      examples: {
        ...{ version: 1, inputs: ['eyeLeft', 'eyeRight'], outputs: ['wheelLeft', 'wheelRight'] },
        ...{ drives: [drive('before')], rows },
      },
    })
    lab.record(recording())
    lab.start()
    lab.drive({ left: 90, right: -60 })
    lab.advance(60)
    expect(rowsOf(lab)).toHaveLength(mostOf.rows)
    expect(lab.view().recording).toEqual({ robot: 'bo', network: 'net', drive: 'pad-1', full: true })
    lab.stop()
    expect(lab.view().recording).toBeNull()
  })

  it('has gaps for a neuron that came later, and keeps the column of one that is gone', () => {
    const lab = thinks()
    const remember = (id: string) =>
      lab.remember({ ...recording(), drive: drive(id, 'hand'), wheels: ahead, others: {} })
    expect(remember('hand-1')).toBe(true)
    lab.edit({ main: program(forever(net('net', '', [eye('eyeRight', 3), eye('eyeThird', 2)]))) })
    expect(remember('hand-2')).toBe(true)
    const table = lab.document().brains['net']!.examples!
    expect(table.inputs).toEqual(['eyeLeft', 'eyeRight', 'eyeThird'])
    expect(table.rows.map((row) => row.slice(6, 9).map((value) => value === null))).toEqual([
      [false, false, true],
      [true, false, false],
    ])
  })
})

describe('one row that is remembered', () => {
  it('is written where Bo was put, without a run; the wheels come in whole percent (15, 18)', () => {
    const lab = thinks()
    lab.place('bo', { x: 200, y: 200, heading: 90 })
    const wheels = { left: 10, right: 60 }
    expect(lab.remember({ ...recording(), drive: drive('hand-1', 'hand'), wheels, others: {} })).toBe(true)
    const [row] = rowsOf(lab)
    expect(row!.slice(0, 6)).toEqual([0, 0, 200, 200, 90, 1])
    expect(row![6]).toBeLessThan(50)
    expect(row!.slice(8)).toEqual([10, 60])
  })
})

describe('a hand on the pad', () => {
  it('drives after the program, and lamps and words too (16)', () => {
    const lamp = (id: string, colour: string) =>
      block(id, 'ai_nn_output_node_led', { fields: { OUTPUTNODE: colour } })
    const list = (id: string, kind: string, items: ReturnType<typeof block>[]) =>
      block(id, 'ai_easy_list', {
        mutation: { attrs: { items: String(items.length), list_type: kind } },
        values: Object.fromEntries(items.map((item, k) => [`ADD${k}`, item])),
      })
    const lamps = block('net', 'ai_neural_network', {
      values: {
        INPUT_LAYER: list('in', 'InputNode', [eye('eyeLeft', 2)]),
        OUTPUT_LAYER: list('out', 'OutputNode', [lamp('green', '#00642E'), lamp('red', '#B30006')]),
      },
    })
    const lab = labWith(program(forever(lamps)))
    lab.record(recording())
    lab.start()
    lab.drive({ left: 0, right: 0 }, { red: 100 })
    lab.advance(7)
    expect(lab.view().robots[0]!.led).toBe('red')
    expect(rowsOf(lab).map((row) => row.slice(7))).toEqual([[-100, 100]])
    lab.drive(null)
    lab.advance(2)
    expect(lab.view().robots[0]!.led).toBeNull()
  })

  it('drives Bo without a run too', () => {
    const lab = thinks()
    lab.drive({ left: 50.4, right: 50.4 })
    lab.advance(30)
    const { pose } = lab.view().robots[0]!
    lab.drive(null)
    lab.advance(30)
    expect(pose.y).toBeGreaterThan(101)
    expect(lab.view().robots[0]!.pose).toEqual(pose)
  })
})
