import { payKinds, type Facts, type PayKind } from '@botgarten/learning/q-senses'
import { factsOf, sightOf, tileAt, touchesIn, type Sensing, type Sight } from './body.ts'

/** What the first robot has done since it was first looked at, tick by tick, as plain data. */
export interface Doings {
  ticks: number
  /** Ticks in which its body touched something. */
  touching: number
  /** Of the move that is under way. */
  held: number
  bumped: boolean
  before: Sight
  /** Everything that can be paid for, added up over the moves that are over. */
  readonly facts: { [kind in PayKind]: number }
  /** Squares of the floor where it has been. */
  readonly tiles: number[]
}

export function beginDoings(seen: Sensing): Doings {
  const before = sightOf(seen, 0)
  const facts = Object.fromEntries(payKinds.map((kind) => [kind, 0])) as Doings['facts']
  return { ticks: 0, touching: 0, held: 0, bumped: false, before, facts, tiles: [tileAt(before)] }
}

/** After a tick of a move of `hold` ticks. Returns what happened in the move that it ends; null: it goes on. */
export function noteTick(doings: Doings, seen: Sensing, hold: number): Facts | null {
  const touches = touchesIn(seen, 0)
  doings.ticks++
  doings.held++
  doings.touching += Number(touches)
  doings.bumped ||= touches
  return doings.held < hold ? null : endMove(doings, seen)
}

function endMove(doings: Doings, seen: Sensing): Facts {
  const now = sightOf(seen, 0)
  const isNew = !doings.tiles.includes(tileAt(now))
  const facts = factsOf(doings.before, now, doings.bumped, isNew)
  if (isNew) doings.tiles.push(tileAt(now))
  for (const kind of payKinds) doings.facts[kind] += facts[kind]
  Object.assign(doings, { before: now, held: 0, bumped: false })
  return facts
}

/** What a robot does with a frozen table. */
export interface Behaviour {
  /** Everything that can be paid for, added up, a minute. */
  readonly facts: Facts
  /** Squares of 40 cm where it has been, from one start in the mean. */
  readonly tiles: number
  /** Percent of the time in which the body touches something. */
  readonly touching: number
  /** From how many starts a bump ended the try, where bumps do. */
  readonly ended: number
}

/**
 * Drives of so many seconds together. What a bump ends brings and costs nothing more, as in a try.
 * @param ended how many drives a bump has ended
 */
export function behaviourOf(drives: readonly Doings[], seconds: number, ended = 0): Behaviour {
  const perMinute = 60 / (seconds * drives.length)
  const paid = (kind: PayKind) => sum(drives, ({ facts }) => facts[kind]) * perMinute
  return {
    facts: Object.fromEntries(payKinds.map((kind) => [kind, paid(kind)])) as Facts,
    tiles: sum(drives, ({ tiles }) => tiles.length) / drives.length,
    touching: (100 * sum(drives, ({ touching }) => touching)) / sum(drives, ({ ticks }) => ticks),
    ended,
  }
}

const sum = (drives: readonly Doings[], of: (one: Doings) => number) =>
  drives.reduce((total, one) => total + of(one), 0)
