import { driveSeconds, wayFault, type MapFile } from '@botgarten/maps'
import type { Plan, QWorld } from '@botgarten/learning/q-learning'
import type { LearnedRun, Project } from '@botgarten/programs'
import { writeNumber } from '@botgarten/messages'
import { language } from '#words/language.svelte.ts'
import { levelWord, settings, type Setting } from '#figures/map/levels.ts'
import { mapName } from '#figures/map/names.ts'
import { m } from '#words/message.ts'
import type { Level } from '../model/choices.svelte.ts'
import type { Comparison } from '../model/guess.ts'
import type { Learning } from '../model/learning.svelte.ts'
import type { Shown } from '../model/shown.ts'

/** A number in the current language, with its groups of thousands. */
export const number = (value: number, places = 0): string =>
  writeNumber(value, language.locale, { most: places })

/** Decimal places of a value: the same in the table, in the lens and in its sum. Where the goal pays little all is less than 1. */
export function placesOf(level: Level, { task: { goalReward = 50 } }: Pick<QWorld, 'task'>): number {
  const pays = Math.abs(goalReward)
  return (level === 'expert' ? 1 : 0) + (pays > 0 && pays < 10 ? 2 : 0)
}
export const rounded = (value: number, places: number): number =>
  Math.round(value * 10 ** places) / 10 ** places

/** Stars in halves: `½`, `4½`. */
export const starText = (stars: number): string =>
  `${stars >= 1 || stars === 0 ? Math.floor(stars) : ''}${stars % 1 > 0 ? '½' : ''}`

/** The stations of a circle, or of a walk: `4 → 6 → 4`. */
export const walk = (stations: readonly number[]) => stations.join(' → ')

/** Why there is no best way yet: what has not been learned; where moves are by chance, what the plan is worth. */
export function reasonOf(
  { shown, shortest }: Pick<Learning, 'shown' | 'shortest'>,
  level: Level = 'explorer',
): string {
  if (!shown || shown.way.states) return ''
  const { way, plan, firstOfEqual, isCircleBest } = shown
  if (shortest === null) return m['q.noWay']()
  if (shown.t === 0) return m['q.nothingYet']()
  if (way.reason === 'neverReached') return m['q.neverReached']()
  if (plan) return planSentence(plan, level)
  if (isCircleBest) return m['q.circlePays']({ circle: circleOf(way.walked) })
  const reason = whyNot(way.reason, way.walked)
  return firstOfEqual ? `${reason} ${m['q.firstOfEqual']({ way: walk(firstOfEqual) })}` : reason
}

/** The circle in a walk: from the first visit of its last station to its end. */
const circleOf = (walked: readonly number[]) => walk(walked.slice(walked.indexOf(walked.at(-1)!)))

function whyNot(reason: Shown['way']['reason'], walked: readonly number[]): string {
  const station = walked.at(-1)!
  switch (reason) {
    case 'circle':
      return m['q.circle']({ station, circle: circleOf(walked) })
    case 'alike':
      return m['q.alike']({ station })
    case 'unpaid':
      return m['q.unpaid']({ station })
    case 'untried':
      return m['q.untried']({ station })
    case 'deadEnd':
      return m['q.deadEnd']({ station })
    default:
      return m['q.unknown']({ station })
  }
}

function planSentence({ doubt, expected, best, reaches }: Plan, level: Level): string {
  const worth = (value: number | null) => (value === null ? '–' : number(value, 3))
  const values =
    level === 'starter' ? '' : ` ${m['q.chanceWorth']({ value: worth(expected), best: worth(best) })}`
  const sure = doubt === null ? '' : ` ${m['q.chanceDoubt']({ station: doubt })}`
  return m['q.chance']({ rides: number(100 * reaches) }) + values + sure
}

/** `Station 7`, or `Station 7, Fountain` where the map names it. */
export function stationName({ stations }: Pick<MapFile, 'stations'>, station: number): string {
  const name = stations[station]?.name
  return m['q.station']({ station }) + (name ? `, ${name}` : '')
}

/** Several moves of the way are worth the same; '' if none are. */
export function tieOf({ shown }: Pick<Learning, 'shown'>): string {
  const tie = shown?.tie
  if (!tie) return ''
  const stations = new Intl.ListFormat(language.locale).format(tie.to.map(String))
  return ` · ${m['q.tie']({ station: tie.station, stations })}`
}

/** The rides that are watched, and how many have arrived. */
export function watchedOf({ watch }: Pick<Learning, 'watch'>): string {
  const { ride, count, arrived, done } = watch
  return done ? m['q.watch.done']({ count, arrived }) : m['q.watch.now']({ ride: ride + 1, count, arrived })
}

/** Which limit stopped it and what came of it; '' while it goes on. */
export function endOf(learning: Learning): string {
  const { shown, state, outline } = learning
  if (!shown || !outline || (state !== 'over' && state !== 'stopped')) return ''
  const by =
    state === 'stopped'
      ? m['q.byHand']()
      : shown.over === 'episodes'
        ? m['q.byEpisodes']({ count: outline.episodes })
        : m['q.byTime']({ count: outline.moves })
  const { states: stations } = shown.way
  if (!stations && shown.plan?.doubt === null) return by
  if (!stations) return `${by} ${shown.isCircleBest ? m['q.circleEnd']() : m['q.notYet']()}`
  const fault = learning.stage && wayFault(learning.stage.map, stations)
  if (fault?.kind === 'turn') return `${by} ${m['q.tightTurn']({ station: fault.station })}`
  if (fault?.kind === 'crosses') return `${by} ${m['q.wayCrosses']()}`
  const counts = outline.pay?.length ? 'Length' : ''
  return `${by} ${m[`q.${learning.isShortest(stations) ? 'isShortest' : 'isLonger'}${counts}`]()}`
}

/** The note while Bo drives. `takes`: seconds of the drive at the current speed, 0 without a way. */
export function driveOf(learning: Learning) {
  const { stage, shown, session } = learning
  const way = shown?.way.states ?? []
  const seconds = stage && way.length > 1 ? driveSeconds(stage.map, way) : 0
  const { speed } = session.lab
  const takes = Number.isFinite(speed) && speed > 0 ? seconds / speed : 0
  const inFives = number(Math.max(5, Math.round(takes / 5) * 5))
  const text = takes > 0 ? `${endOf(learning)} ${m['q.takes']({ seconds: inFives })}` : endOf(learning)
  // Only the shortest way gets a tick.
  return { best: way.length > 1 && learning.isShortest(way), takes, text }
}

/** A move as a sentence, for whoever does not see it. */
function moveSentence({ shown }: Learning): string {
  const trace = shown?.trace
  if (!shown || !trace) return ''
  if (trace.decision === null) return m['q.said.stuck']({ from: trace.from })
  const how = trace.decision === 'explore' ? m['q.said.explored']() : m['q.said.exploited']()
  const facts = {
    move: number(trace.t),
    from: trace.from,
    to: trace.to,
    how,
    stars: starText(shown.stars.after),
  }
  const jump = trace.teleported ? `${m['q.said.teleported']({ from: trace.from })} ` : ''
  const goal = trace.ends === 'goal' ? ` ${m['q.said.goal']()}` : ''
  return jump + m['q.said.move'](facts) + goal
}

/** Tells each move that is played at ×1 or stepped, and how it ended. What a hand only scrubs over is not told. */
export function liveSentence(learning: Learning): string {
  const { state, shown } = learning
  const { speed } = learning.player
  const ended = state === 'over' || state === 'stopped'
  if (!ended || shown?.t !== shown?.made)
    return state === 'playing' && speed > 1 ? '' : moveSentence(learning)
  const stations = shown?.way.states
  const best = stations ? `${m['q.bestWay']()} ${stations.join(', ')}` : ''
  return [endOf(learning), reasonOf(learning), best].filter((sentence) => sentence !== '').join(' ')
}

// ---- the table of trials ----

export { settings }

/** A setting as its block says it; a number where no block says it so. */
export function wordOf(name: Setting, value: number): string {
  return levelWord(name, value) ?? number(value, 4)
}

/** The same; for experts always the number. */
export const settingOf = (run: LearnedRun, name: Setting, level: Level): string =>
  level === 'expert' ? number(run[name], 4) : wordOf(name, run[name])

/** Closed roads, each once: `2–3` in both directions, `16→15` in one. */
export function closedOf(roads: readonly (readonly [number, number])[]): readonly string[] {
  const has = (from: number, to: number) => roads.some(([a, b]) => a === from && b === to)
  const texts = roads.map(([a, b]) => (has(b, a) ? `${Math.min(a, b)}–${Math.max(a, b)}` : `${a}→${b}`))
  return [...new Set(texts)]
}

/** `2 or 5`, in the language of now. */
export const listed = (stations: readonly number[]): string =>
  new Intl.ListFormat(language.locale, { type: 'disjunction' }).format(stations.map(String))

/** What a guess is worth beside the way that came out. */
export function comparisonOf({ more, parting }: Comparison): string {
  if (parting === null) return m['q.compare.same']()
  if (more > 0) return m['q.compare.shorter']({ count: more })
  return more < 0 ? m['q.compare.longer']({ count: -more }) : m['q.compare.alike']()
}

export const wayOf = (text: string) => text.replaceAll('-', ' → ')

/** What was guessed, with a tick where it was right; '' where nothing was. */
export const guessOf = ({ guess, way }: LearnedRun) =>
  way !== '' && guess.match(/\d+/g)?.join('-') === way ? `${guess} ✓` : guess

/** Start and goal, on which map where it has a name. */
export const taskOf = (run: LearnedRun, own: Project['maps'] = {}): string =>
  `${mapName(run.map, own)}: ${m['q.task'](run)}`
