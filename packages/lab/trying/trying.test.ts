import { addBlocks, type Block } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { tryingIn } from '@botgarten/programs'
import { paintFloor } from '@botgarten/simulation'
import { beforeAll, describe, expect, it } from 'vitest'
import { createLab } from '../index.ts'
import { block, drive, forever, program, worldWith } from '../testing/scene.ts'
import { beginNight, learnedOf, rideBy, ticksOf } from './index.ts'

beforeAll(() => addBlocks(learning))

const notice = (port: string) =>
  block(`see${port}`, 'ai_try_senses', {
    fields: { SENSE: 'DISTANCE', SENSORPORT: port, LOW: '15', HIGH: '40' },
  })
const can = block('can', 'ai_try_actions', {
  fields: { CHIP1: 'AHEAD', CHIP2: 'LEFT', CHIP3: 'RIGHT', CHIP4: 'NONE' },
})
const pay = (what: string, coins: number) =>
  block(`pay${what}`, 'ai_try_pay', { fields: { WHAT: what, COINS: String(coins) } })
const tryFor = (minutes: number, more = {}) =>
  block('try', 'ai_try_learn', { fields: { MINUTES: String(minutes), ...more } })
const act = block('act', 'ai_try_act')

const blocks = (
  minutes: number,
  more = {},
  sentences: readonly Block[] = [pay('AHEAD', 1), pay('BUMP', -5)],
) => program(notice('2'), notice('3'), can, ...sentences, tryFor(minutes, more), forever(act))

const world = worldWith()
const floor = paintFloor(world)

function started(
  main = blocks(1),
  checks: Parameters<ReturnType<typeof createLab>['load']>[2]['checks'] = [],
) {
  const lab = createLab()
  lab.load({ programs: { main }, world, brains: {} }, floor, { seed: 1, checks })
  lab.start()
  return lab
}

const trialOf = (main = blocks(1)) => tryingIn(main)!.trial

function overnight(minutes: number, slice: number, trial = trialOf()) {
  const night = beginNight(world, floor, trial)
  const all = ticksOf(minutes)
  while (night.state.total < all) night.advance(Math.min(slice, all - night.state.total))
  return learnedOf(night.state)
}

describe('learning by trying', () => {
  it('learns the same in the lab, tick by tick, as overnight in slices of any length', () => {
    const lab = started()
    lab.advance(3610)
    const table = lab.document().tables!['try']!
    expect(table.moves).toBe(240)
    expect(overnight(1, 3600)).toEqual(table)
    expect(overnight(1, 7)).toEqual(table)
    expect(overnight(1, 3600, { ...trialOf(), seed: 2 })).not.toEqual({ ...table, seed: 2 })
  })

  it('is learned again from the seed and the moves of a table that was saved, to the same bits', () => {
    const saved = JSON.parse(JSON.stringify(overnight(1, 60))) as ReturnType<typeof overnight>
    const { kind: _kind, q: _q, tries: _tries, moves, curve: _curve, ...trial } = saved
    const night = beginNight(world, floor, trial)
    while (night.state.table.moves < moves) night.advance(1)
    expect(learnedOf(night.state)).toEqual(saved)
  })

  it('is the same after going back in time, whatever was looked at in between', () => {
    const [lab, other] = [started(), started()]
    lab.advance(2000)
    lab.goTo(700)
    lab.advance(1)
    lab.goTo(1900)
    lab.goTo(2000)
    lab.resume()
    lab.advance(1610)
    other.advance(3610)
    expect(lab.hash()).toBe(other.hash())
    expect(lab.document().tables).toEqual(other.document().tables)
  })

  it('drives at once by a table that the same blocks have learned, and learns again for another pay', () => {
    const tables = { try: overnight(1, 60) }
    const lab = createLab()
    lab.load({ programs: { main: blocks(1) }, world, brains: {}, tables }, floor, { seed: 1, checks: [] })
    lab.start()
    lab.advance(600)
    const way = lab.view().robots[0]!.trail
    lab.load({ programs: { main: blocks(1) }, world, brains: {}, tables }, floor, { seed: 1, checks: [] })
    lab.start()
    lab.advance(600)
    expect(lab.view().robots[0]!.trail).toEqual(way)
    expect(lab.document().tables).toBe(tables)
    const dear = { main: blocks(1, {}, [pay('AHEAD', 1), pay('BUMP', -10)]) }
    lab.load({ programs: dear, world, brains: {}, tables }, floor, { seed: 1, checks: [] })
    lab.start()
    lab.advance(3610)
    expect(lab.document().tables!['try']!.pay[1]).toEqual({ for: 'bump', coins: -10 })
  })

  it('does not explore when it drives by its table: the same ride as in a world of its own', () => {
    const table = overnight(1, 60)
    const lab = createLab()
    const tables = { try: table }
    lab.load({ programs: { main: blocks(1) }, world, brains: {}, tables }, floor, { seed: 1, checks: [] })
    lab.start()
    lab.advance(600)
    let way = 0
    const trail = lab.view().robots[0]!.trail
    trail.forEach(({ x, y }, k) => {
      const before = trail[k - 1]
      if (before) way += Math.hypot(x - before.x, y - before.y)
    })
    expect(rideBy(table, world, floor, 10).cm / 6).toBeCloseTo(way, -1)
  })

  it('rides for exactly its seconds: at 50 percent 5.6 π cm in each', () => {
    const free = { ...world, obstacles: [], size: { width: 4000, height: 4000 } }
    const trial = { ...trialOf(), actions: [{ left: 50, right: 50 }] }
    const ahead = { ...overnight(1, 3600), ...trial, q: Array(10).fill(0), tries: Array(10).fill(0) }
    for (const seconds of [1, 2]) {
      const { cm, bumps } = rideBy(ahead, free, paintFloor(free), seconds)
      expect(cm).toBeCloseTo(60 * 5.6 * Math.PI, 6)
      expect(bumps).toBe(0)
    }
  })

  it('is paid for a new square of the floor once in a try', () => {
    const free = { ...world, obstacles: [], size: { width: 4000, height: 4000 } }
    const starts = [{ x: 2000, y: 2000 }]
    const ahead = { ...trialOf(), starts, actions: [{ left: 50, right: 50 }] }
    const night = beginNight(free, paintFloor(free), { ...ahead, pay: [{ for: 'tile', coins: 1 }] })
    night.advance(3600)
    // A minute at 5.6 π cm/s is 1056 cm: across squares of 40 cm at least 18 along their diagonals, and at most 27 columns
    // and 27 rows. It decides 240 times.
    const paid = night.state.curve[0]!.pay
    expect(paid).toBeGreaterThanOrEqual(18)
    expect(paid).toBeLessThanOrEqual(54)
  })

  it('ends a try at a bump where that is set: the next one begins at the start', () => {
    const ended = trialOf(blocks(1, { ENDS: 'TRUE' }))
    expect(ended.bumpEnds).toBe(true)
    const night = beginNight(world, floor, ended)
    night.advance(3600)
    const bumps = night.state.curve[0]!.bumps
    expect(night.state.attempts).toBeGreaterThan(1)
    expect(night.state.attempts - 2).toBeLessThanOrEqual(bumps)
  })

  it('ends a try after a minute where nothing stands in the way, and begins the next at the start', () => {
    const free = { ...world, obstacles: [], size: { width: 4000, height: 4000 } }
    const night = beginNight(free, paintFloor(free), { ...trialOf(), bumpEnds: true })
    night.advance(2 * 3600 + 30)
    expect(night.state).toMatchObject({ attempts: 3, stuck: 0 })
    expect(night.state.curve.map(({ bumps }) => bumps)).toEqual([0, 0])
  })

  it('counts the tries in which it is wedged in and cannot get away', () => {
    const wall = (id: string, x: number, y: number) => ({
      ...{ id, fixed: true, colour: '#000000', pose: { x, y, heading: 0 } },
      shape: { kind: 'rectangle' as const, width: 30, height: 30 },
    })
    const around = [
      [174, 100],
      [226, 100],
      [200, 74],
      [200, 126],
      [174, 74],
      [226, 74],
      [174, 126],
      [226, 126],
    ] as const
    const tight = { ...world, obstacles: around.map(([x, y], k) => wall(`w${k}`, x, y)) }
    const night = beginNight(tight, paintFloor(tight), trialOf())
    night.advance(3 * 3600)
    expect(night.state).toMatchObject({ stuck: 2 })
    expect(night.state.table.moves).toBeGreaterThan(700)
  })

  it('begins its tries at one of several starts by chance, each about equally often', () => {
    const more = { STARTS: '60 60, 200 100, 300 150, x 1, 5, 1 2 3', ENDS: 'TRUE' }
    const several = trialOf(blocks(1, more, [pay('AHEAD', 1)]))
    expect(several.starts).toEqual([
      { x: 60, y: 60 },
      { x: 200, y: 100 },
      { x: 300, y: 150 },
    ])
    const night = beginNight(world, floor, { ...several, hold: 60 })
    const begun: string[] = []
    while (night.state.attempts < 60) {
      const { attempts } = night.state
      night.advance(1)
      const { x, y } = night.state.before!
      if (night.state.attempts > attempts) begun.push(`${x} ${y}`)
    }
    for (const place of ['60 60', '200 100', '300 150'])
      expect(begun.filter((one) => one === place).length).toBeGreaterThan(8)
    expect(new Set(begun).size).toBe(3)
  })

  it('may do what a chip of its own says, with the lamp that belongs to it', () => {
    const chip = (id: string, LEFT: string, RIGHT: string, LAMP: string) =>
      block(id, 'ai_try_chip', { fields: { LEFT, RIGHT, LAMP } })
    const own = [
      chip('a', '60', '30', 'GREEN'),
      chip('b', '-200', 'much', 'OFF'),
      chip('c', '60', '30', 'GREEN'),
    ]
    const main = program(notice('2'), can, ...own, pay('AHEAD', 1), tryFor(1), forever(act))
    expect(trialOf(main).actions.slice(3)).toEqual([
      { left: 60, right: 30, lamp: 'green' },
      { left: -100, right: 0, lamp: 'off' },
    ])
    const lab = started(main)
    const seen = new Set<string>()
    for (let tick = 0; tick < 1200; tick++) {
      lab.advance(1)
      const { led, motors } = lab.view().robots[0]!
      seen.add(`${motors['C']} ${motors['B']} ${led}`)
    }
    expect(seen).toContain('60 30 green')
    expect([...seen].filter((one) => one.startsWith('-100 0'))).toEqual(['-100 0 null'])
  })

  it.each([
    ['tryNoPay', blocks(1, {}, [])],
    ['tryNoPay', blocks(1, {}, [pay('BUMP', 0)])],
    ['tryNoSenses', program(can, pay('BUMP', -5), tryFor(1), forever(act))],
    ['tryNoActions', program(notice('2'), pay('BUMP', -5), tryFor(1), forever(act))],
    ['tryNotLearned', program(notice('2'), can, pay('BUMP', -5), forever(act))],
  ])('says %s at the block, before anything moves', (name, main) => {
    const lab = started(main)
    lab.advance(10)
    expect(lab.view().problem).toMatchObject({ problem: `problem.${name}` })
    expect(lab.view().robots[0]!.pose).toMatchObject({ x: 200, y: 100 })
  })

  it('pay beyond 20 coins counts as 20, and what is no number as none', () => {
    const { pay: sentences } = trialOf(
      blocks(1, {}, [pay('BUMP', -1e6), { ...pay('MOMENT', 0), fields: { WHAT: 'MOMENT', COINS: 'much' } }]),
    )
    expect(sentences).toEqual([
      { for: 'bump', coins: -20 },
      { for: 'moment', coins: 0 },
    ])
  })

  it('cruising begins when trying is over', () => {
    const checks = [{ id: 'c', kind: 'cruises', numbers: { cm: 0, bumps: 99 }, seconds: 5 }]
    const lab = started(blocks(1), checks)
    lab.advance(3800)
    expect(lab.view().checks[0]!.passed).toBe(false)
    lab.advance(200)
    expect(lab.view().checks[0]!.passed).toBe(true)
  })
})

describe('the trick of an animal', () => {
  const animal = (cheats: string) => [
    { id: 'c', kind: 'neverCheats', numbers: { animal: 'gazer', cheats }, seconds: 5 },
  ]
  const missing = (cheats: string, seconds: number, main = blocks(1)) => {
    const lab = started(main, animal(cheats))
    lab.advance(seconds * 60)
    return lab.view().checks[0]!.passed || lab.missing()[0]!.what
  }

  it('is looked for when it drives by its table, not while it learns, for so many seconds', () => {
    expect(missing('cm 0 3000', 59)).toBe('untried')
    expect(missing('cm 0 3000', 63)).toBe('short')
    expect(missing('cm 0 3000', 66)).toBe('trick')
    expect(missing('cm 0 3000, bumps 240 240', 66)).toBe(true)
    expect(missing('tiles 99 100', 66)).toBe(true)
  })

  it('is not looked for where no table drives', () => {
    expect(missing('tiles 99 100', 6, program(forever(drive('go', 20, 10))))).toBe('untried')
  })

  it('is looked for again where it was done, and never again where it was not', () => {
    const lab = started(blocks(1), animal('cm 0 3000'))
    lab.advance(66 * 60)
    expect(lab.missing()[0]).toMatchObject({ what: 'trick', facts: { animal: 'gazer' } })
    lab.advance(6 * 60)
    expect(lab.missing()[0]!.what).toBe('trick')
    const honest = started(blocks(1), animal('tiles 99 100'))
    honest.advance(120 * 60)
    expect(honest.view().checks[0]).toMatchObject({ passed: true, at: expect.closeTo(65, 0) as number })
  })
})

describe('what is shown of it', () => {
  const sees = (port: string) =>
    block(`colour${port}`, 'ai_try_senses', { fields: { SENSE: 'COLOUR', SENSORPORT: port } })
  const shown = (lab: ReturnType<typeof createLab>) => lab.trying()!

  it('is nothing where no block tries, and an empty table of 10 states before a start', () => {
    const lab = createLab()
    lab.load({ programs: { main: program() }, world, brains: {} }, floor, { seed: 1, checks: [] })
    expect(lab.trying()).toBeNull()
    lab.edit({ main: blocks(1) })
    expect(shown(lab)).toMatchObject({ stage: 'fresh', problem: null, action: null, last: null })
    expect(shown(lab).table.q).toEqual(Array(30).fill(0))
  })

  it('is the row in which Bo stands, what it does and by which of the two, and is left alone by the run', () => {
    const lab = started()
    lab.advance(31)
    const { stage, last, state, action, table } = shown(lab)
    expect({ stage, t: last!.t, state }).toEqual({ stage: 'trying', t: 2, state: last!.to })
    expect(['explore', 'exploit']).toContain(action!.decision)
    const [q, moves] = [[...table.q], table.moves]
    lab.advance(600)
    expect(table).toMatchObject({ q, moves })
    expect(shown(lab).table.moves).toBe(42)
  })

  it('is the table of then in a moment of the past', () => {
    const lab = started()
    lab.advance(1000)
    const then = shown(lab)
    lab.advance(1000)
    lab.goTo(1000)
    expect(shown(lab)).toEqual(then)
  })

  it('is learned when it drives by its table, and of other blocks when they have been changed since', () => {
    const lab = started()
    lab.advance(3700)
    expect(shown(lab)).toMatchObject({ stage: 'learned', action: { decision: 'exploit' } })
    const { curve } = shown(lab)
    expect(curve).toHaveLength(1)
    const again = createLab()
    const saved = JSON.parse(JSON.stringify(lab.document())) as ReturnType<typeof lab.document>
    again.load(saved, floor, { seed: 1, checks: [] })
    expect(shown(again).curve).toEqual(curve)
    lab.edit({ main: blocks(1, { ALPHA: '0.1' }) })
    expect(shown(lab)).toMatchObject({ stage: 'other', table: { alpha: 0.2 } })
  })

  it('tries for exactly its minute of 3,600 ticks', () => {
    const lab = started()
    lab.advance(3600)
    expect(shown(lab)).toMatchObject({ stage: 'trying', total: 3599 })
    lab.advance(1)
    expect(shown(lab).stage).toBe('learned')
  })

  it('is the case for which an action was chosen, as long as that is held', () => {
    const lab = started()
    lab.advance(3610)
    const changes: number[] = []
    let last = shown(lab).state
    for (let tick = 1; tick <= 1200; tick++) {
      lab.advance(1)
      const { state } = shown(lab)
      if (state !== last) changes.push(tick)
      last = state
    }
    expect(changes.length).toBeGreaterThan(5)
    expect(new Set(changes.map((tick) => tick % 15)).size).toBe(1)
  })

  it.each([
    ['tryNoSenses', program(can, pay('BUMP', -5), tryFor(1))],
    ['tryManySenses', program(...['1', '2', '3', '4'].map(notice), can, pay('BUMP', -5), tryFor(1))],
    ['tryManyStates', program(...['1', '2', '3'].map(sees), can, pay('BUMP', -5), tryFor(1))],
    ['tryNoActions', program(notice('2'), pay('BUMP', -5), tryFor(1))],
    ['tryNoPay', program(notice('2'), can, pay('BUMP', 0), tryFor(1))],
  ])('says why nothing can be learned: %s', (problem, main) => {
    const lab = createLab()
    lab.load({ programs: { main }, world, brains: {} }, floor, { seed: 1, checks: [] })
    expect(shown(lab).problem).toBe(problem)
  })
})
