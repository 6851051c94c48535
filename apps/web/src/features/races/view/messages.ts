import type { LaneResult, WayThen } from '@botgarten/experiments/race'
import { shortestPath } from '@botgarten/learning/q-learning'
import { writeNumber } from '@botgarten/messages'
import { language } from '#words/language.svelte.ts'
import { m, message } from '#words/message.ts'
import { choices, type Setting } from '../model/lanes.ts'
import { isSide } from '../model/room.ts'
import type { Run, Runner } from '../model/race.svelte.ts'
import type { Learned, WalkModel } from '../model/walk.svelte.ts'
import { movesOf, type Tried } from '../model/walked.ts'

/** A number in the current language, with a minus sign. */
export const number = (value: number, places = 0): string =>
  writeNumber(value, language.locale, { most: places })

const walk = (stations: readonly number[]) => stations.join(' → ')

export const racerName = ({ racer }: Pick<Runner, 'racer'>): string => m[`race.racer.${racer}`]()

/** Where a door leads, for screen readers: to a side of a grid's room, otherwise to the number of a room. */
export const doorName = (side: string | null, to: number): string =>
  isSide(side) ? m[`race.sides.${side}`]() : String(to)

/** What a value of a setting is called; a number where no word is for it. */
export function wordOf(setting: Setting, value: number): string {
  const known = choices[setting].find((one) => one.value === value)
  return known ? message(`race.choice.${known.word}`) : number(value, 3)
}

/** What a lane is set to, in a line. */
export function settingOf(runner: Runner): string {
  if (runner.racer === 'me') return m['race.triesOfMine']({ count: runner.tries.length })
  if (runner.racer === 'random') return m['race.always']()
  if (runner.racer === 'best') return m['race.never']()
  return m['race.uses']({ often: wordOf('rho', runner.rho) })
}

/** Names of lanes; two of one kind get their numbers. */
export function namesOf(runners: readonly Runner[]): readonly string[] {
  const names = runners.map(racerName)
  return names.map((name, lane) =>
    names.filter((other) => other === name).length > 1 ? `${name} ${lane + 1}` : name,
  )
}

/** Who won, and by how much. */
export function winnerSaid({ winners, criterion, results, runners }: Run): string {
  const [winner] = winners
  if (winner === undefined) return m['race.noWinner']()
  if (winners.length === runners.length) return m['race.allAlike']()
  const names = namesOf(runners)
  const list = new Intl.ListFormat(language.locale, { type: 'conjunction' })
  const name = list.format(winners.map((lane) => names[lane]!))
  const { first, stars, falls } = results[winner]!.bill
  const count = number({ way: first ?? 0, stars, falls }[criterion], 1)
  return m[`race.won.${criterion}`]({ name, count })
}

const reasonOf = (way: WayThen) => ('states' in way ? '' : way.reason)

/** The ways of a lane at a moment: how long, in how many races, and what the others do. */
export function waysSaid({ ways, runs }: LaneResult, at: number): string {
  const then = ways[Math.min(at, ways.length - 1)]!
  const lengths = new Map<number, number>()
  for (const way of then)
    if ('states' in way)
      lengths.set(way.states.length - 1, (lengths.get(way.states.length - 1) ?? 0) + way.runs)
  const found = [...lengths]
    .toSorted(([a], [b]) => a - b)
    .map(([moves, count]) => m['race.wayIn']({ moves, count, runs }))
  const circles = sumOf(then.filter((way) => reasonOf(way) === 'circle'))
  const others = sumOf(then.filter((way) => !['', 'circle', 'chance'].includes(reasonOf(way))))
  return [
    ...found,
    ...(circles > 0 ? [m['race.circlesIn']({ count: circles, runs })] : []),
    ...(others > 0 ? [m['race.notYetIn']({ count: others, runs })] : []),
  ].join(' · ')
}

const sumOf = (ways: readonly { readonly runs: number }[]) => ways.reduce((sum, { runs }) => sum + runs, 0)

/** The child's last try is over, and in how many moves. */
export const tryEnd = ({ tries }: Pick<WalkModel, 'tries'>): string =>
  m['race.tryEnd']({
    number: tries.length,
    moves: m['race.moves']({ count: number(movesOf(tries.at(-1)!)) }),
  })

/** The way of the child: whether there is a shorter one. */
export function mineSaid({ track: { world } }: WalkModel, { states, atGoal }: Tried): string {
  if (!atGoal) return m['race.notThere']()
  const way = walk(states)
  return states.length === shortestPath(world) ? m['race.mineBest']({ way }) : m['race.mine']({ way })
}

/** The way that Bo's table shows, or where it tells none yet. */
export function boSaid({ way }: Learned): string {
  if (way.states) return m['race.boWay']({ way: walk(way.states) })
  if (way.reason === 'neverReached') return m['race.boNever']()
  const room = way.walked.at(-1)!
  return way.reason === 'circle' ? m['race.boCircle']({ room }) : m['race.boNotYet']({ room })
}
