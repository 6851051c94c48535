import {
  limits,
  payKinds,
  unitOf,
  type Action,
  type Place,
  type Sensor,
  type Trial,
} from '@botgarten/learning/q-senses'
import type { Block } from '@botgarten/blocks'
import type { Program } from './types.ts'

/** What a program wants a robot to learn by trying, read from its blocks. */
export interface TryOutline {
  /** The block that learns, else the one that does the best: the table goes by its id. */
  readonly id: string
  readonly trial: Trial
  /** Simulated minutes, 0..60; 0: nothing learns. */
  readonly minutes: number
  /** Ids of the blocks of its sensors, in their order. */
  readonly senses: readonly string[]
}

const chips: { readonly [chip: string]: Action } = {
  AHEAD: { left: 50, right: 50 },
  LEFT: { left: -25, right: 25 },
  RIGHT: { left: 25, right: -25 },
  BACK: { left: -40, right: -40 },
  STOP: { left: 0, right: 0 },
}

/** A world is at most so wide, cm. */
const widest = 10_000

/** Null where no block learns or drives by trying. Blocks that are switched off do not count. */
export function tryingIn({ stacks }: Program): TryOutline | null {
  const begun = stacks.filter(({ blocks }) => blocks[0]?.type === 'robControls_start')
  const all = (begun.length > 0 ? begun : stacks).flatMap(({ blocks }) => blocks.flatMap(inside))
  const ofType = (type: string) => all.filter((block) => block.type === type)
  const [learn] = ofType('ai_try_learn')
  const [act] = ofType('ai_try_act')
  const id = learn?.id ?? act?.id
  if (id === undefined) return null
  const [can] = ofType('ai_try_actions')
  const senses = ofType('ai_try_senses')
  const trial: Trial = {
    sensors: senses.map(sensorIn),
    edges: senses.map(edgesIn),
    bump: true,
    actions: unlike([...(can ? actionsIn(can) : []), ...ofType('ai_try_chip').map(chipIn)]),
    hold: numberIn(can, 'HOLD', 15, 6, 60),
    pay: ofType('ai_try_pay').map(sentenceIn),
    bumpEnds: learn?.fields?.['ENDS'] === 'TRUE',
    alpha: numberIn(learn, 'ALPHA', 0.2, 0, 1),
    gamma: numberIn(learn, 'GAMMA', 0.9, 0, 1),
    rho: numberIn(learn, 'RHO', 0.2, 0, 1),
    seed: Math.round(numberIn(learn, 'SEED', 1, 0, 1_000_000)),
  }
  const starts = startsIn(learn)
  const tried = starts.length > 0 ? { ...trial, starts } : trial
  const minutes = learn ? numberIn(learn, 'MINUTES', 8, 0, limits.minutes) : 0
  return { id, trial: tried, minutes, senses: senses.map((block) => block.id) }
}

function inside(block: Block): readonly Block[] {
  if (block.disabled === true) return []
  return [block, ...Object.values(block.statements ?? {}).flatMap((rows) => rows.flatMap(inside))]
}

function numberIn(
  block: Block | undefined,
  name: string,
  preset: number,
  least: number,
  most: number,
): number {
  const text = block?.fields?.[name]
  const value = text === undefined || text.trim() === '' ? NaN : Number(text)
  return Number.isFinite(value) ? Math.min(most, Math.max(least, value)) : preset
}

const modes: { readonly [sense: string]: Sensor['mode'] } = {
  DISTANCE: 'distance',
  LIGHT: 'light',
  COLOUR: 'colour',
  TOUCH: 'touch',
}

function sensorIn({ fields }: Block): Sensor {
  const port = fields?.['SENSORPORT'] ?? ''
  return {
    port: port === '1' || port === '3' || port === '4' ? port : '2',
    mode: modes[fields?.['SENSE'] ?? ''] ?? 'distance',
  }
}

/** Numbers of colours and of a touch are buckets as they are. */
function edgesIn(block: Block): readonly number[] {
  const { mode } = sensorIn(block)
  if (mode === 'colour') return [1, 2, 3, 4, 5, 6, 7]
  if (mode === 'touch') return [1]
  const edges = [numberIn(block, 'LOW', 15, 0, 100), numberIn(block, 'HIGH', 40, 0, 100)]
  return [...new Set(edges)].sort((a, b) => a - b)
}

function actionsIn(block: Block): readonly Action[] {
  const names = ['CHIP1', 'CHIP2', 'CHIP3', 'CHIP4'].map((name) => block.fields?.[name] ?? '')
  return names.flatMap((name) => (Object.hasOwn(chips, name) ? [chips[name]!] : []))
}

const lamps: { readonly [lamp: string]: NonNullable<Action['lamp']> } = {
  ...{ GREEN: 'green', ORANGE: 'orange', RED: 'red', OFF: 'off' },
}

function chipIn(block: Block): Action {
  const lamp = block.fields?.['LAMP'] ?? ''
  return {
    left: numberIn(block, 'LEFT', 0, -100, 100),
    right: numberIn(block, 'RIGHT', 0, -100, 100),
    ...(Object.hasOwn(lamps, lamp) && { lamp: lamps[lamp]! }),
  }
}

/** The same chip twice is one. */
const unlike = (actions: readonly Action[]): readonly Action[] => {
  const signs = actions.map((action) => JSON.stringify(action))
  return actions.filter((_, at) => signs.indexOf(signs[at]!) === at)
}

/** Places as a block holds them, in cm: `110 190, 300 70`. What is none is left out. */
function startsIn(block: Block | undefined): readonly Place[] {
  const places = (block?.fields?.['STARTS'] ?? '').split(',').flatMap((text): Place[] => {
    const [x = NaN, y = NaN, ...more] = text.trim().split(/\s+/).map(Number)
    const fits = [x, y].every((value) => value >= 0 && value <= widest)
    return fits && more.length === 0 ? [{ x, y }] : []
  })
  return places.slice(0, limits.starts)
}

function sentenceIn(block: Block): Trial['pay'][number] {
  const name = (block.fields?.['WHAT'] ?? '').toLowerCase()
  const what = payKinds.find((kind) => kind === name) ?? 'bump'
  const coins = numberIn(block, 'COINS', 0, -20, 20)
  return { for: what, coins: coins / unitOf(what) }
}
