import type { PythonAt } from '@botgarten/blocks'
import type { PayKind, TableBrain } from '@botgarten/learning/q-senses'
import { tryingIn } from '../trying.ts'
import type { Draft } from './draft.ts'
import { doLines, milliseconds, nameOf, noticed, readingsOf, tableFor, touched } from './trying.ts'
import type { Writer } from './writer.ts'

const ticksPerMinute = 3600
/** Over so many minutes the robot explores less and less, down to 0.3 of its beginning. */
const fallMinutes = 8

/** The robot goes on learning by trying for as long as the block says: packages/learning/q-senses/model.md. */
export function tryOn(writer: Writer, at: PythonAt): void {
  const { draft, usage } = writer
  const table = tableFor(writer)
  const minutes = tryingIn(usage.program)?.minutes ?? 0
  if (draft.input.learner !== true || !table || minutes === 0) return
  const row = noticed(draft, at, table)
  settingLines(draft, at, table)
  const measures = measuresIn(draft, at, table)
  const name = (wanted: string) => nameOf(draft, wanted)
  for (const { what, code, isBefore } of measures) if (isBefore) draft.line(`${name(what)} = ${code}`)
  draft.line(`${name('row')} = ${row}`)
  draft.line(`for ${name('move')} in range(${Math.ceil((minutes * ticksPerMinute) / table.hold)}):`)
  writer.inner(() => moveLines(writer, at, table, measures))
  draft.line(at.robot.stop())
  draft.line(`print(${name('TABLE')})`)
}

function settingLines(draft: Draft, at: PythonAt, { alpha, gamma, rho, hold }: TableBrain): void {
  const constant = (code: string) => draft.constants.push({ code, depth: 0, blocks: [at.block.id] })
  constant(`# ${draft.say('python.learner.settings')}`)
  constant(`${nameOf(draft, 'LEARNING_RATE')} = ${alpha}`)
  constant(`${nameOf(draft, 'DISCOUNT')} = ${gamma}`)
  constant(`${nameOf(draft, 'EXPLORING')} = ${rho}`)
  constant(`${nameOf(draft, 'FALL')} = ${Math.ceil((fallMinutes * ticksPerMinute) / hold)}`)
}

/** One move: it is chosen, done, paid and learned from. */
function moveLines(writer: Writer, at: PythonAt, table: TableBrain, measures: readonly Measure[]): void {
  const { draft } = writer
  const name = (wanted: string) => nameOf(draft, wanted)
  const [action, values, row] = [name('action'), name('TABLE'), name('row')]
  for (const { what, isBefore } of measures)
    if (isBefore) draft.line(`${name(`${what}_before`)} = ${name(what)}`)
  draft.line(
    `${name('curious')} = ${name('EXPLORING')} * (1 - 0.7 * min(1, ${name('move')} / ${name('FALL')}))`,
  )
  const random = `${at.from('random', 'random')}()`
  draft.line(`if ${random} < ${name('curious')}:`)
  writer.inner(() => draft.line(`${action} = int(${random} * len(${name('ACTIONS')}))`))
  draft.line('else:')
  writer.inner(() => draft.line(`${action} = ${at.call('best_action', `${values}[${row}]`)}`))
  doLines(writer, at, table, action)
  draft.line(at.robot.wait(String(milliseconds(table.hold))))
  for (const { what, code } of measures) draft.line(`${name(what)} = ${code}`)
  payLines(draft, at, table)
  learnLines(draft, at, table)
}

function learnLines(draft: Draft, at: PythonAt, table: TableBrain): void {
  const name = (wanted: string) => nameOf(draft, wanted)
  const [row, following, rate] = [name('row'), name('following'), name('LEARNING_RATE')]
  const cell = `${name('TABLE')}[${row}][${name('action')}]`
  const best = `max(${name('TABLE')}[${following}])`
  const ends = table.bumpEnds && touched(draft, at) !== ''
  draft.line(`${following} = ${noticed(draft, at, table)}`)
  draft.line(`${name('ahead')} = ${ends ? `0 if ${name('touched')} else ${best}` : best}`)
  draft.line(`${name('aim')} = ${name('reward')} + ${name('DISCOUNT')} * ${name('ahead')}`)
  draft.line(`${cell} = (1 - ${rate}) * ${cell} + ${rate} * ${name('aim')}`)
  draft.line(`${row} = ${following}`)
}

type What = 'turned' | 'seen' | 'nearest' | 'light' | 'touched'

/** Something that pay asks for, as it is read; `isBefore`: its value before the move counts, too. */
interface Measure {
  readonly what: What
  readonly code: string
  readonly isBefore: boolean
}

const asks: { readonly [kind in PayKind]?: readonly What[] } = {
  ...{ bump: ['touched'], ahead: ['turned'], way: ['turned'], wheels: ['turned'], farther: ['seen'] },
  ...{ open: ['seen'], near: ['nearest', 'touched'], black: ['light'], line: ['light'], free: ['touched'] },
}
const asksBefore: readonly PayKind[] = ['ahead', 'way', 'wheels', 'farther', 'line', 'free']

function measuresIn(draft: Draft, at: PythonAt, { pay, bumpEnds }: TableBrain): readonly Measure[] {
  const wanted = (what: What) => pay.filter(({ for: kind }) => asks[kind]?.includes(what))
  const all = ['turned', 'seen', 'nearest', 'light', 'touched'] as const
  const used = all.filter((what) => wanted(what).length > 0 || (what === 'touched' && bumpEnds))
  return used.flatMap((what) => {
    const code = readingOf(draft, at, what)
    const isBefore = wanted(what).some(({ for: kind }) => asksBefore.includes(kind))
    return code === '' ? [] : [{ what, code, isBefore }]
  })
}

/** '' where the robot has nothing that says so. */
function readingOf(draft: Draft, at: PythonAt, what: What): string {
  if (what === 'touched') return touched(draft, at)
  if (what === 'light') return readingsOf(draft, at, 'colour', 'light')[0] ?? ''
  if (what === 'turned') {
    const { left, right } = draft.input.config.drive
    return `(${at.robot.encoder(left).code} + ${at.robot.encoder(right).code}) / 2`
  }
  const eyes = readingsOf(draft, at, 'ultrasonic', 'distance')
  if (eyes.length === 0) return ''
  return what === 'seen' ? eyes.map((eye) => `min(100, ${eye})`).join(' + ') : `min(100, ${eyes.join(', ')})`
}

/** What each sentence pays for the move, added up in their order. */
function payLines(draft: Draft, at: PythonAt, { pay }: TableBrain): void {
  const reward = nameOf(draft, 'reward')
  const terms = pay.flatMap(({ for: kind, coins }) => termOf(draft, at, kind, coins))
  draft.line(`${reward} = ${terms[0] ?? '0'}`)
  for (const term of terms.slice(1)) draft.line(`${reward} += ${term}`)
}

/** None where the robot cannot know; that is said in the file and at the block. */
function termOf(draft: Draft, at: PythonAt, kind: PayKind, coins: number): readonly string[] {
  const lacks = (asks[kind] ?? []).filter((what) => what !== 'turned' && readingOf(draft, at, what) === '')
  const cannot = kind === 'tile' || lacks.some((what) => what !== 'touched') || isTouch(kind, lacks)
  if (!cannot) return [termFor(draft, kind, coins)]
  draft.comment(draft.note(at.block.id, 'python.missing.pay'))
  return []
}

const isTouch = (kind: PayKind, lacks: readonly What[]) =>
  lacks.includes('touched') && (kind === 'bump' || kind === 'free')

function termFor(draft: Draft, kind: PayKind, coins: number): string {
  const name = (what: string) => nameOf(draft, what)
  const more = (what: What) => `${name(what)} - ${name(`${what}_before`)}`
  const where = (truth: string) => `${coins} if ${truth} else 0`
  const { config } = draft.input
  const eyes = Object.values(config.sensors).filter(({ kind: one }) => one === 'ultrasonic').length
  const feels = Object.values(config.sensors).some(({ kind: one }) => one === 'touch')
  const cm = `* ${((Math.PI * config.wheelDiameter) / 360).toPrecision(6)}`
  const terms: { readonly [kind in PayKind]: string } = {
    bump: where(name('touched')),
    moment: String(coins),
    ahead: `${coins} * (${more('turned')}) ${cm}`,
    way: `${coins} * abs(${more('turned')}) ${cm}`,
    wheels: `${coins} * max(0, ${more('turned')}) / 90`,
    farther: `${coins} * max(0, ${more('seen')}) / 20`,
    open: `${coins} * (${name('seen')} / ${100 * eyes})`,
    near: where(`${feels ? `not ${name('touched')} and ` : ''}5 < ${name('nearest')} < 30`),
    tile: '0',
    black: where(`${name('light')} < 30`),
    line: where(`${name('light')} < 30 and ${name('light_before')} >= 70`),
    free: where(`${name('touched_before')} and not ${name('touched')}`),
  }
  return terms[kind]
}
