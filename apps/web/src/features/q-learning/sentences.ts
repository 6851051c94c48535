import type { Plan } from '@botgarten/learning/q-learning'
import { m } from '#words/say.ts'
import { number } from './numbers.ts'
import type { Learning } from './learning.svelte.ts'
import type { Shown } from './shown.ts'

/** The stations of a circle, or of a walk: `4 → 6 → 4`. */
const walk = (stations: readonly number[]) => stations.join(' → ')

/** Why there is no best way yet: what has not been learned; where moves are by chance, what the plan is worth. */
export function reasonOf({ shown, shortest }: Pick<Learning, 'shown' | 'shortest'>): string {
  if (!shown || shown.way.stations) return ''
  const { way, plan, firstOfEqual } = shown
  if (shortest === null) return m['q.noWay']()
  if (shown.t === 0) return m['q.nothingYet']()
  if (way.reason === 'neverReached') return m['q.neverReached']()
  if (plan) return planSentence(plan)
  const reason = whyNot(way.reason, way.walked)
  return firstOfEqual ? `${reason} ${m['q.firstOfEqual']({ way: walk(firstOfEqual) })}` : reason
}

function whyNot(reason: Shown['way']['reason'], walked: readonly number[]): string {
  const station = walked.at(-1)!
  switch (reason) {
    case 'circle':
      return m['q.circle']({ station, circle: walk(walked.slice(walked.indexOf(station))) })
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

function planSentence({ doubt, expected, best, reaches }: Plan): string {
  const worth = (value: number | null) => (value === null ? '–' : number(value, 3))
  const facts = { value: worth(expected), best: worth(best), rides: number(100 * reaches) }
  const sure = doubt === null ? '' : ` ${m['q.chanceDoubt']({ station: doubt })}`
  return m['q.chance'](facts) + sure
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
  const { stations } = shown.way
  if (!stations && shown.plan?.doubt === null) return by
  if (!stations) return `${by} ${m['q.notYet']()}`
  return learning.isShortest(stations) ? `${by} ${m['q.isShortest']()}` : `${by} ${m['q.isLonger']()}`
}

/** A move as a sentence, for whoever does not see it. */
export function moveSentence({ shown }: Learning): string {
  const trace = shown?.trace
  if (!shown || !trace) return ''
  if (trace.decision === null) return m['q.said.stuck']({ from: trace.from })
  const how = trace.decision === 'explore' ? m['q.said.explored']() : m['q.said.exploited']()
  const facts = { move: number(trace.t), from: trace.from, to: trace.to, how, stars: shown.stars.after }
  const jump = trace.teleported ? `${m['q.said.teleported']({ from: trace.from })} ` : ''
  const goal = trace.ends === 'goal' ? ` ${m['q.said.goal']()}` : ''
  return jump + m['q.said.move'](facts) + goal
}
