import { worldAt } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { tryOut, type Tried } from '@botgarten/experiments/trying'
import { limits, payKinds, problemOf, type Sentence, type Trial } from '@botgarten/learning/q-senses'
import { tryingIn, type Project, type TryOutline } from '@botgarten/programs'
import type { World } from '@botgarten/simulation'
import type { Command } from '../commands.ts'
import { CallError, FileError } from '../errors.ts'
import { write } from '../files.ts'
import { note } from '../notes.ts'
import { projectOf, type Source } from '../net/source.ts'
import { numberIn, options, wholeNumberIn } from '../options.ts'
import { message } from '../words.ts'
import { zooRows } from './zoo.ts'

const known = {
  solution: { type: 'boolean' },
  minutes: { type: 'string' },
  pay: { type: 'string' },
  alpha: { type: 'string' },
  gamma: { type: 'string' },
  rho: { type: 'string' },
  seed: { type: 'string' },
  seeds: { type: 'string' },
  csv: { type: 'string' },
  zoo: { type: 'string' },
  json: { type: 'boolean' },
} as const

type Values = { readonly [name in Exclude<keyof typeof known, 'json' | 'solution'>]?: string } & {
  readonly json?: boolean
  readonly solution?: boolean
}

const mostSeeds = 1000

/** `botgarten learn try CARD|FILE …`: a robot learns by trying with its own sensors. */
export const learnTry: Command = {
  options: known,
  execute(args) {
    const { values, positionals } = options(args, known)
    const [what, ...more] = positionals
    if (values.zoo !== undefined) return zooRows(values.zoo, positionals, values)
    if (!what || more.length > 0) throw new CallError('call.tryWhat')
    const { project, card } = projectOf(what, values.solution)
    const { outline, minutes, trial } = trialOf(outlineIn(project), values)
    const worlds = worldsOf(project, card)
    const run = (seed: number) => tryOut(worlds, content.floorOf(project.world), { ...trial, seed }, minutes)
    if (values.seeds !== undefined) return several(run, outline.trial.seed, minutes, values)
    const tried = run(trial.seed)
    if (tried.stuck > 0) note(message('trying.stuck', { count: tried.stuck }))
    if (values.csv !== undefined) write(values.csv, curveOf(tried))
    const report = reportOf(tried, minutes)
    return values.json ? JSON.stringify(report) : sentenceOf(report)
  },
}

function outlineIn({ programs }: Project): TryOutline {
  for (const program of Object.values(programs)) {
    const outline = tryingIn(program)
    if (outline) return outline
  }
  throw new FileError('trying.none')
}

/** What the blocks say, where the call says nothing else. */
function trialOf(outline: TryOutline, values: Values) {
  const share = (name: 'alpha' | 'gamma' | 'rho') => numberIn(name, values[name], outline.trial[name], 0, 1)
  const trial: Trial = {
    ...outline.trial,
    ...{ alpha: share('alpha'), gamma: share('gamma'), rho: share('rho') },
    pay: values.pay === undefined ? outline.trial.pay : payOf(values.pay),
    seed: wholeNumberIn('seed', values.seed, outline.trial.seed, 0, 1_000_000),
  }
  const minutes = numberIn('minutes', values.minutes, outline.minutes || 8, 1, 60)
  const problem = problemOf(trial)
  if (problem) throw new FileError(`trying.${problem}`)
  return { outline: { ...outline, trial }, minutes, trial }
}

/** `bump=-5,ahead=.25`: coins for each of what is paid for, ahead for each cm. */
function payOf(text: string): readonly Sentence[] {
  return text.split(',').map((part) => {
    const [name = '', coins = ''] = part.split('=').map((one) => one.trim())
    const kind = payKinds.find((one) => one === name)
    const value = Number(coins)
    if (!kind || coins === '' || !(Math.abs(value) <= limits.coins))
      throw new CallError('call.pay', { text: part, kinds: payKinds.join(', ') })
    return { for: kind, coins: value }
  })
}

/** The world with the robot on each of the card's starts; without a card, as it is. */
function worldsOf({ world }: Project, card: Source['card']): readonly World[] {
  return card ? card.card.starts.map((_, start) => worldAt(card.world, card.card, start)) : [world]
}

const sum = (values: readonly number[]) => values.reduce((total, value) => total + value, 0)

function reportOf({ table, curve, first, last }: Tried, minutes: number) {
  return {
    ...{ minutes, seed: table.seed, decisions: table.moves },
    bumps: sum(curve.map(({ bumps }) => bumps)),
    pay: sum(curve.map(({ pay }) => pay)),
    ...{ q: table.q, tries: table.tries },
    passes: { first, last },
    curve,
  }
}

const sentenceOf = ({ minutes, decisions, bumps, passes }: ReturnType<typeof reportOf>): string =>
  message(passes.first === null ? 'trying.notYet' : 'trying.passes', {
    ...{ minutes, decisions, bumps },
    first: passes.first ?? 0,
  })

const curveOf = ({ curve }: Tried): string =>
  ['minute,pay,bumps', ...curve.map(({ pay, bumps }, k) => `${k + 1},${pay},${bumps}`)].join('\n') + '\n'

function several(run: (seed: number) => Tried, first: number, minutes: number, values: Values): string {
  const count = wholeNumberIn('seeds', values.seeds, 1, 1, mostSeeds)
  const seeds = Array.from({ length: count }, (_, k) => {
    const { q: _q, tries: _tries, curve: _curve, ...row } = reportOf(run(first + k), minutes)
    return row
  })
  if (values.csv !== undefined) write(values.csv, rowsOf(seeds))
  if (values.json) return JSON.stringify({ seeds })
  const passed = seeds.filter(({ passes }) => passes.first !== null).length
  return message('trying.seeds', { count, passed })
}

type Row = Omit<ReturnType<typeof reportOf>, 'q' | 'tries' | 'curve'>

const rowsOf = (rows: readonly Row[]): string =>
  [
    'seed,decisions,bumps,pay,first,last',
    ...rows.map(({ seed, decisions, bumps, pay, passes }) =>
      [seed, decisions, bumps, pay, passes.first ?? '', Number(passes.last)].join(','),
    ),
  ].join('\n') + '\n'
