import { m } from '#lib/words/generated/messages.js'
import { number } from './numbers.ts'
import type { Learning } from './learning.svelte.ts'

/** The stations of a circle, or of a walk: `4 → 6 → 4`. */
const walk = (stations: readonly number[]) => stations.join(' → ')

/** Why there is no best way yet: what has not been learned. */
export function reasonOf({ shown, shortest }: Learning): string {
  if (!shown || shown.way.stations) return ''
  const { way } = shown
  if (shortest === null) return m['q.noWay']()
  if (shown.t === 0) return m['q.nothingYet']()
  if (way.reason === 'neverReached') return m['q.neverReached']()
  const last = way.walked.at(-1)!
  if (way.reason === 'circle')
    return m['q.circle']({ station: last, circle: walk(way.walked.slice(way.walked.indexOf(last))) })
  return way.reason === 'deadEnd' ? m['q.deadEnd']({ station: last }) : m['q.unknown']({ station: last })
}

/** Which limit stopped it and what came of it; '' while it goes on. */
export function endOf(learning: Learning): string {
  const { shown, state, outline } = learning
  if (!shown || !outline || (state !== 'over' && state !== 'stopped')) return ''
  const by =
    state === 'stopped'
      ? m['q.byHand']()
      : shown.over === 'episodes'
        ? m['q.byEpisodes']({ count: number(outline.episodes) })
        : m['q.byTime']({ count: number(outline.moves) })
  const { stations } = shown.way
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
