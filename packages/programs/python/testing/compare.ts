import { nothing, type Block } from '@botgarten/blocks'
import { within } from '../../check/names.ts'
import { networks } from '../../networks.ts'
import type { NetworkOutline, Program } from '../../types.ts'
import type { Dialect } from '../types.ts'
import type { Interpreted } from './interpreted.ts'
import type { Command } from './tracing-robot.ts'
import type { Traced } from './worker.ts'

/** What no brick has; and Pybricks 4 has no voice. */
const elsewhere: { readonly [dialect in Dialect]: RegExp } = {
  // Its hub has three keys.
  spike: /htcolour|HTCOLOUR|robCommunication_(receive|wait)|sayText|key_getSample.*(UP|DOWN|ESCAPE|ANY)/,
  pybricks: /htcolour|HTCOLOUR|robCommunication_(receive|wait)|sayText/,
  ev3dev2: /htcolour|HTCOLOUR|robCommunication_(receive|wait)/,
}

const words = ({ type, fields = {} }: Block) => [type, ...Object.values(fields)].join(' ')

/** Does a program ask for what this robot does not have? There its readings are nothing: python.md, "What is missing". */
export const asksElsewhere = (program: Program, dialect: Dialect): boolean =>
  program.stacks.some(({ blocks }) =>
    blocks.flatMap(within).some((block) => elsewhere[dialect].test(words(block))),
  ) ||
  (dialect === 'spike' && networks(program).some(showsSeveral))

/** The hub of SPIKE Prime shows the highest of a network's words alone. */
const showsSeveral = ({ outputs }: NetworkOutline) =>
  outputs.filter(({ type }) => type === 'ai_nn_output_node_text').length > 1

/** A move as a turn of each motor, as Pybricks drives a curve; a wheel that stands is not told. */
function asTurns(command: Command): readonly Command[] {
  const [verb, left, right, degrees] = command as readonly [string, number, number, number]
  if (verb !== 'move') return [command]
  const faster = Math.max(Math.abs(left), Math.abs(right))
  const wheels = [
    ['C', left],
    ['B', right],
  ] as const
  return wheels.flatMap(([port, percent]) =>
    percent === 0 ? [] : [['turn', port, percent, (degrees * Math.abs(percent)) / faster] as const],
  )
}

/** MicroPython hands no larger whole number over. */
const isHuge = (command: Command) =>
  command.some((fact) => typeof fact === 'number' && Math.abs(fact) >= 2 ** 30)

function plain(log: readonly Command[], dialect: Dialect): readonly Command[] {
  const own = log.map(asLetters)
  const huge = own.findIndex(isHuge)
  const told = (huge < 0 ? own : own.slice(0, huge)).flatMap(asTurns)
  if (dialect === 'spike') return withoutRepeats(told.map(asOnSpike))
  return dialect === 'ev3dev2' ? told.map(asOnEv3dev) : told
}

/** The hub of SPIKE Prime shows one text, wherever on the display it would stand. */
const asOnSpike = (command: Command): Command =>
  command[0] === 'display' ? ['display', 0, 0, command[3]] : command

/** The same text does not go by again. */
function withoutRepeats(log: readonly Command[]): readonly Command[] {
  let shown: unknown = ''
  return log.filter(([verb, , , text]) => {
    if (verb !== 'display' && verb !== 'clear') return true
    const before = shown
    shown = verb === 'clear' ? '' : text
    return verb === 'clear' || text !== before
  })
}

/** python-ev3dev2 takes whole percents, and a tone of its has an end. */
function asOnEv3dev(command: Command): Command {
  const [verb, first] = command
  if (verb === 'tone' && (command[2] === null || command[2] === 0.1)) return [verb, first]
  return verb === 'volume' ? [verb, Math.trunc(Number(first))] : command
}

const close = (a: unknown, b: unknown): boolean =>
  typeof a === 'number' && typeof b === 'number'
    ? Math.abs(a - b) <= 1e-6 * Math.max(1, Math.abs(a), Math.abs(b))
    : JSON.stringify(a ?? null) === JSON.stringify(b ?? null)

const same = (a: Command, b: Command): boolean =>
  a.length === b.length && a.every((fact, k) => close(fact, b[k]))

/** The bricks' letters have no ∅. */
const asLetters = (command: Command): Command =>
  command.at(-1) === nothing ? ([...command.slice(0, -1), '-'] as unknown as Command) : command

/** On ev3dev a file stops its motors at its end. */
const isStop = ([verb, , percent]: Command) => verb === 'motor' && percent === 0

/** The first command that differs, in words; null where there is none. */
export function difference(ours: Interpreted, theirs: Traced | null, dialect: Dialect): string | null {
  const wanted = plain(ours.log, dialect)
  if (theirs === null) return wanted.length > 0 && ours.problem === null ? 'Python never waits' : null
  const told = plain(theirs.log, dialect)
  const length = Math.min(wanted.length, told.length)
  const at = wanted.slice(0, length).findIndex((command, k) => !same(command, told[k]!))
  if (at >= 0) return `command ${at}: ${JSON.stringify(wanted[at])}, Python ${JSON.stringify(told[at])}`
  const [missed, more] = [wanted.slice(length), told.slice(length)]
  const cut = ours.cut || theirs.cut || [...ours.log, ...theirs.log].some(isHuge)
  if (!cut && ours.problem === null && !more.every(isStop))
    return `Python goes on: ${JSON.stringify(more[0])}`
  // What the lab would have said before Start is raised where its statement begins.
  // Numbers without end are no places: python.md, "Numbers".
  const gap = /NotImplementedError|OverflowError/.test(theirs.error ?? '')
  if (!theirs.cut && !gap && missed.length > 0 && !cut)
    return `Python ends early (${theirs.error}), the blocks told ${JSON.stringify(missed[0])}`
  return null
}
