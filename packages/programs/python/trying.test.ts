import { addBlocks, stacksOf } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { stateOf, statesOf, type TableBrain, type Trial } from '@botgarten/learning/q-senses'
import { draw, stream } from '@botgarten/numbers'
import { cardConfig, COLOURS, defaultConfig, type RobotConfig } from '@botgarten/simulation'
import { beforeAll, describe, expect, it } from 'vitest'
import { programOf } from '../testing/build.ts'
import { tryingIn } from '../trying.ts'
import { dialects, pythonFrom, type Dialect, type PythonInput } from './index.ts'
import { runPython, tracingRobot } from './testing/micropython.ts'

beforeAll(() => addBlocks(learning))

const dice = stream(7, 'test')
const any = (most: number) => Math.floor(draw(dice) * most)
const tableFor = (trial: Trial): TableBrain => {
  const values = statesOf(trial) * trial.actions.length
  const tries = Array.from({ length: values }, () => 1)
  return { ...trial, kind: 'table', q: tries.map(() => draw(dice) * 20 - 10), tries, moves: values }
}

const exampleOf = (type: 'ai_try_act' | 'ai_try_chip') => programOf(stacksOf(learning[type].example)[0]!)
const program = exampleOf('ai_try_act')
const { id, trial } = tryingIn(program)!

const file = (dialect: Dialect, config: RobotConfig, more: Partial<PythonInput> = {}) =>
  pythonFrom({ ...{ name: 'test', program, config, brains: {}, dialect }, ...more }, (key) => key)

/** Sensors of every kind, lamps, and a bump that a touch sensor feels. */
const rich: Trial = {
  ...trial,
  sensors: [
    { port: '4', mode: 'distance' },
    { port: '3', mode: 'colour' },
    { port: '3', mode: 'light' },
  ],
  edges: [
    [15, 40],
    [1, 2, 3, 4, 5, 6, 7],
    [30, 70],
  ],
  actions: [
    { left: 50, right: 50, lamp: 'green' },
    { left: -25, right: 25, lamp: 'off' },
    { left: 60, right: 30, lamp: 'red' },
    { left: 0, right: -40 },
  ],
}
const colours = Object.values(COLOURS)
const moments = Array.from({ length: 30 }, () => ({
  ...{ distance: any(120), colour: any(8), light: any(101), pressed: any(5) === 0 },
}))

/** What a robot did in each of these moments. */
async function done(text: string) {
  const { robot: bare } = tracingRobot()
  let ticks = 0
  const now = () => moments[Math.floor(ticks / rich.hold)]!
  const present = { left: 0, right: 0, lamp: null as string | null }
  const all: (typeof present)[] = []
  const set = (side: 'left' | 'right', percent: number) => void (present[side] = Math.round(percent))
  const { drive } = defaultConfig
  const robot: typeof bare = {
    ...bare,
    read(_port, mode) {
      const { distance, colour, light, pressed } = now()
      return { distance, light, touch: pressed, colour: colours[colour]! }[mode as 'light'] ?? null
    },
    motor: (port, percent) => set(port === drive.left ? 'left' : 'right', percent),
    move: ({ left, right }) => (set('left', left), set('right', right)),
    led: (colour) => void (present.lamp = colour),
  }
  const tick = () => {
    if (ticks % rich.hold === 0) all.push({ ...present })
    if (++ticks === moments.length * rich.hold) throw new Error('time is up')
  }
  const { error } = await runPython(text, robot, { tick, random: () => 0 }, defaultConfig)
  expect(error).toMatch(/time is up/)
  return all
}

describe.each(dialects)('a table that was learned by trying, as Python for %s', (dialect) => {
  it('does in each case what is worth most, as long as it is held', async () => {
    const table = tableFor(rich)
    const { text } = file(dialect, defaultConfig, { tables: { [id]: table } })
    let lamp: string | null = null
    const wanted = moments.map(({ distance, colour, light, pressed }) => {
      const row = 4 * stateOf(rich, [distance, colour, light], pressed)
      const values = table.q.slice(row, row + 4)
      const { left, right, lamp: shines } = rich.actions[values.indexOf(Math.max(...values))]!
      if (shines) lamp = shines === 'off' ? null : shines
      return { left, right, lamp }
    })
    expect(await done(text)).toEqual(wanted)
  })

  it('says that without a touch sensor no bump is noticed', () => {
    const { text, notes } = file(dialect, cardConfig, { tables: { [id]: tableFor(trial) } })
    expect(notes).toEqual([{ block: 'ai_try_act', text: 'python.missing.bump', gap: false }])
    expect(text).toContain('# python.missing.bump')
    expect(text).toContain('# python.tryTable')
  })

  it('says where nothing is learned yet', () => {
    const { text, notes } = file(dialect, cardConfig)
    expect(notes.map((note) => note.text)).toEqual(['python.missing.trying'])
    expect(text).not.toContain('TABLE')
  })
})

it('a robot that learns pays its move, writes it down where it was, and feels bumps', async () => {
  const block = (id: string, type: string, fields: Record<string, string>) => ({ id, type, fields })
  const blocks = [
    block('start', 'robControls_start', {}),
    block('sense', 'ai_try_senses', { SENSE: 'DISTANCE', SENSORPORT: '4', LOW: '15', HIGH: '40' }),
    block('can', 'ai_try_actions', {
      CHIP1: 'AHEAD',
      CHIP2: 'STOP',
      CHIP3: 'NONE',
      CHIP4: 'NONE',
      HOLD: '15',
    }),
    block('moment', 'ai_try_pay', { WHAT: 'MOMENT', COINS: '2' }),
    block('bump', 'ai_try_pay', { WHAT: 'BUMP', COINS: '-5' }),
    // 15 of 3,600 ticks a minute: one move.
    block('learn', 'ai_try_learn', { MINUTES: String(15 / 3600), ALPHA: '0.5', GAMMA: '0', RHO: '0' }),
  ]
  const one = { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
  const { text } = pythonFrom(
    {
      ...{ name: 'test', program: one, config: defaultConfig, brains: {}, dialect: 'pybricks' },
      learner: true,
    },
    (key) => key,
  )
  const { robot: bare } = tracingRobot()
  const robot: typeof bare = { ...bare, read: (_port, mode) => (mode === 'touch') as never }
  const { error, printed } = await runPython(text, robot, { tick: () => {}, random: () => 0 }, defaultConfig)
  expect(error).toBeNull()
  // Buckets of the distance, then the row of a bump; half of 2 − 5 coins for the first action.
  expect(JSON.parse(printed.at(-1)!)).toEqual([[0, 0], [0, 0], [0, 0], [-1.5, 0]]) // prettier-ignore
})

it('a chip of one’s own is one of the actions', () => {
  const own = tryingIn(exampleOf('ai_try_chip'))!.trial
  expect(own.actions.at(-1)).toEqual({ left: 60, right: 30 })
})
