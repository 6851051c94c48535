import { paintFloor, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { addBlocks, type Block } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { beginNight, tableOf, ticksOf } from '@botgarten/lab/trying'
import { tryingIn } from '@botgarten/programs'
import { noExamples, withDrive } from '@botgarten/learning/neural-network/examples'
import { billOf, csvOf, finish, race, summariesOf, type Course, type Ground, type Racer } from './index.ts'

addBlocks(learning)

const world: World = {
  size: { width: 300, height: 200 },
  floor: { colour: '#FFFFFF' },
  ...{ areas: [], lines: [] },
  obstacles: [
    {
      id: 'square',
      shape: { kind: 'rectangle', width: 40, height: 40 },
      pose: { x: 250, y: 100, heading: 0 },
      ...{ fixed: true, colour: '#1F67B3' },
    },
  ],
  robots: [
    {
      id: 'bo',
      pose: { x: 60, y: 100, heading: 0 },
      ...{ program: 'main', brain: '' },
      config: {
        ...{ wheelDiameter: 5.6, trackWidth: 18, drive: { left: 'C', right: 'B' } },
        sensors: {
          '2': { kind: 'ultrasonic', x: 10, y: 4, angle: 20 },
          '3': { kind: 'ultrasonic', x: 10, y: -4, angle: -20 },
        },
      },
    },
  ],
}
const course: Course = {
  ...{ id: 'small', world: 'small', shown: 1, seconds: 4, measure: { kind: 'way' } },
  starts: [
    { x: 60, y: 100, heading: 0 },
    { x: 60, y: 60, heading: 90 },
  ],
}
const groundOf = (change: Partial<Course> = {}): Ground => ({
  course: { ...course, ...change },
  world,
  floor: paintFloor(world),
})

let ids = 0
const block = (type: string, more: Partial<Block> = {}): Block => ({ id: `b${++ids}`, type, ...more })
const number = (value: number) => block('math_number', { fields: { NUM: String(value) } })
const wheel = (port: string, power: number) =>
  block('robActions_motor_on', { fields: { MOTORPORT: port }, values: { POWER: number(power) } })
const near = (port: string) =>
  block('logic_compare', {
    fields: { OP: 'LT' },
    values: {
      A: block('robSensors_ultrasonic_getSample', {
        fields: { MODE: 'DISTANCE', SENSORPORT: port, SLOT: '' },
        mutation: { attrs: { mode: 'DISTANCE' } },
      }),
      B: number(20),
    },
  })

function racer(...rows: Block[]): Racer {
  const forever = block('robControls_loopForever', { statements: { DO: rows } })
  const blocks = [block('robControls_start', { fields: { DEBUG: 'FALSE' } }), forever]
  return { programs: { main: { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } } }, brains: {} }
}

const ahead = racer(wheel('C', 50), wheel('B', 50))
const stands = racer(wheel('C', 0), wheel('B', 0))
const careful = racer(
  block('robControls_ifElse', {
    mutation: { attrs: { else: '1' } },
    values: { IF0: near('2') },
    statements: { DO0: [wheel('C', 0), wheel('B', 0)], ELSE: [wheel('C', 50), wheel('B', 50)] },
  }),
)

const resultOf = (one: Racer | null, change?: Partial<Course>) =>
  finish(race(groundOf(change), [{ kind: 'ifThen', racer: one }], 7))[0]!

describe('a race of brains', () => {
  it('is the same race with the same seed, lane by lane and bit for bit', () => {
    const lanes = [
      { kind: 'ifThen', racer: careful },
      { kind: 'hand', racer: ahead },
    ] as const
    const first = finish(race(groundOf(), lanes, 7))
    expect(finish(race(groundOf(), lanes, 7))).toEqual(first)
    // Who drives in the other lanes changes nothing: each is alone.
    expect(finish(race(groundOf(), [lanes[1]], 7))[0]).toEqual(first[1])
  })

  it('measures the way in a minute and the bumps: 50 percent are a turn of both wheels a second', () => {
    const [fromLeft, up] = resultOf(ahead).runs!
    // 5.6 cm wheels, 1 turn a second, until the square is 250 − 20 cm from the wall, Bo 10 cm long before its axle.
    expect(fromLeft!.cm).toBeGreaterThan(0.9 * Math.PI * 5.6 * 60)
    expect(fromLeft!.cm).toBeLessThan(Math.PI * 5.6 * 60)
    expect(fromLeft!.bumps).toBe(0)
    expect(fromLeft!.score).toBe(fromLeft!.cm)
    expect(fromLeft!.trail).toHaveLength(41)
    expect(up!.from).toEqual(course.starts[1])
    expect(resultOf(ahead, { seconds: 15 }).runs![0]!.bumps).toBe(1)
  })

  it('counts a start at which nobody moved as 0, and as all of the time where time is measured', () => {
    expect(resultOf(stands).runs!.map(({ score }) => score)).toEqual([0, 0])
    const measure = { kind: 'time', obstacle: 'square', cm: 30 } as const
    expect(resultOf(stands, { measure }).runs!.map(({ score }) => score)).toEqual([4, 4])
  })

  it('measures the time to a thing, and parts of laps', () => {
    const measure = { kind: 'time', obstacle: 'square', cm: 30 } as const
    const [there, never] = resultOf(ahead, { measure, seconds: 12 }).runs!
    expect(there!.score).toBeGreaterThan(6)
    expect(there!.score).toBeLessThan(9)
    expect(never!.score).toBe(12)
    const gates = [
      { x: 60, y: 100 },
      { x: 100, y: 100 },
      { x: 110, y: 100 },
      { x: 250, y: 20 },
    ]
    const laps = { kind: 'laps', gates, cm: 5 } as const
    expect(resultOf(ahead, { measure: laps }).runs![0]!.score).toBe(0.5)
  })

  it('counts decisions: a condition each tick, and none where none is asked', () => {
    expect(resultOf(careful).runs![0]!.decisions).toBeCloseTo(240, -1)
    expect(resultOf(ahead).runs![0]!.decisions).toBe(0)
  })

  it('puts a start that lies in a wall at the nearest free place, and says so', () => {
    const starts = [course.starts[0]!, { x: 250, y: 100, heading: 0 }]
    const [free, moved] = resultOf(ahead, { starts }).runs!
    expect(free!.moved).toBe(false)
    expect(moved!.moved).toBe(true)
    expect(moved!.from).not.toEqual(starts[1])
  })

  it('lets a table race that has tried as long as its blocks say, and no other one', () => {
    const tries = block('ai_try_learn', { id: 'try', fields: { MINUTES: '1' } })
    const can = block('ai_try_actions', { fields: { CHIP1: 'AHEAD', CHIP2: 'LEFT' } })
    const { programs, brains } = racer(block('ai_try_act'))
    const [stack] = programs['main']!.stacks
    const [start, forever] = stack!.blocks
    const notice = block('ai_try_senses', { fields: { SENSE: 'DISTANCE', SENSORPORT: '2' } })
    const pay = block('ai_try_pay', { fields: { WHAT: 'AHEAD', COINS: '1' } })
    const blocks = [start!, notice, can, pay, tries, forever!]
    const program = { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
    const { id, trial, minutes } = tryingIn(program)!
    const night = beginNight(world, paintFloor(world), trial)
    night.advance(ticksOf(minutes))
    const table = tableOf(night.state)
    const ready = { programs: { main: program }, brains, tables: { [id]: table } }
    expect(resultOf({ ...ready, tables: {} }).problem).toBe('learns')
    expect(resultOf(ready).runs![0]!.decisions).toBe(16)
    expect(billOf('trying', ready)).toEqual({
      ...{ parts: table.tries.filter((count) => count > 0).length, examples: null, practised: null },
      ...{ tried: { decisions: 240, minutes: 1 }, effort: null },
    })
  })

  it('lets no brain race that is missing, cannot run, or would still learn', () => {
    const learner = racer(block('ai_nn_forget', { fields: { WHAT: 'EXAMPLES' } }))
    const broken = racer(block('robActions_motor_on', { fields: { MOTORPORT: 'C' } }))
    expect(resultOf(null)).toEqual({ kind: 'ifThen', problem: 'missing', runs: null })
    expect(resultOf({ programs: {}, brains: {} }).problem).toBe('missing')
    expect(resultOf(broken).problem).toBe('cannotRun')
    const beginningWith = (top: Block) => {
      const stacks = [{ x: 0, y: 0, blocks: [top, wheel('C', 30)] }]
      return resultOf({ programs: { main: { stacks, config: { stacks: [] } } }, brains: {} }).problem
    }
    expect(beginningWith(wheel('B', 30))).toBe('missing')
    expect(beginningWith(block('robControls_start', { disabled: true }))).toBe('missing')
    expect(beginningWith(block('robControls_start'))).toBeNull()
    expect(resultOf(learner).problem).toBe('learns')
  })
})

describe('the bill', () => {
  const layer = (...ids: string[]) => ids.map((id) => ({ id, activation: 'identity' as const, bias: 0 }))
  const net = (more: object = {}) => ({
    net: {
      ...{ kind: 'network' as const, layers: [layer('a', 'b'), layer('c', 'd')], sets: {} },
      weights: { a: { c: 0.5, d: 0 }, b: { c: -1 }, '#bias': { d: 3 } },
      ...more,
    },
  })

  it('counts links and biases that are not 0', () => {
    expect(billOf('hand', { ...ahead, brains: net() })).toEqual({
      ...{ parts: 3, examples: null, practised: null, tried: null, effort: null },
    })
  })

  it('says what the lab has counted while a brain came about', () => {
    const effort = { knobs: 14, starts: 3, bumps: 5, hand: 360, computer: 0 }
    expect(billOf('hand', { ...ahead, brains: net(), effort }).effort).toEqual(effort)
  })

  it('counts blocks in the loop, without those that are switched off', () => {
    expect(billOf('ifThen', careful).parts).toBe(12)
    expect(billOf('ifThen', racer(wheel('C', 50), { ...wheel('B', 50), disabled: true })).parts).toBe(2)
  })

  it('counts examples that are on and set aside, and seconds of driving', () => {
    const none = noExamples(['a', 'b'], ['c', 'd'])
    const rows = [0, 60, 120].map((tick) => ({
      ...{ tick, pose: { x: 0, y: 0, heading: 0 } },
      ...{ inputs: [tick, 1], outputs: [1, 1] },
    }))
    const { examples } = withDrive(none, { id: 'keys-1', by: 'keys', seed: 1 }, rows)
    const aside = { ...examples, rows: [examples.rows[0]!.with(5, 0), ...examples.rows.slice(1)] }
    const bill = billOf('examples', { ...ahead, brains: net({ examples: aside }) })
    expect(bill.examples).toEqual({ on: 2, aside: 1, seconds: 2 })
    expect(bill.practised).toEqual({ rounds: 0, examples: 2 })
  })
})

it('a race is a table: a row a lane and start, and a sum a lane', () => {
  const lanes = [
    { kind: 'hand', racer: null },
    { kind: 'ifThen', racer: careful },
  ] as const
  const results = finish(race(groundOf(), lanes, 7))
  const [none, summary] = summariesOf(results, lanes)
  expect(none).toBeNull()
  expect(summary!.cm).toBeCloseTo((results[1]!.runs![0]!.cm + results[1]!.runs![1]!.cm) / 2, 9)
  const rows = csvOf(course, results).trim().split('\n')
  expect(rows.map((row) => row.split(',').slice(0, 3).join())).toEqual([
    'lane,start,sealed',
    'ifThen,1,0',
    'ifThen,2,1',
  ])
})
