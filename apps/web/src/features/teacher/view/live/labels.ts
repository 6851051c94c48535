import { m } from '#words/message.ts'
import { agoOf, minutesSince, type Live, type Need, type SeenTile } from '../../model/live.ts'

const needLabel = (need: Need, now: number): string => {
  if (need.kind === 'sameCheck') return m['teacher.stuck.sameCheck']({ times: need.times })
  return m[`teacher.stuck.${need.kind}`]({ minutes: minutesSince(need.since, now) })
}

/** "5 s ago": when something was changed last. */
function agoLabel(then: number, now: number): string {
  const { unit, count } = agoOf(then, now)
  return m[`teacher.ago.${unit}`]({ count })
}

const timeOf = (when: number, locale: string) =>
  new Date(when).toLocaleTimeString(locale, { hour: 'numeric', minute: '2-digit' })

/** The line below a tile: why it comes first, or when it moved last. */
export function stateLabel({ tile, need, here, done }: SeenTile, now: number, locale: string): string {
  const { live } = tile
  if (need) return needLabel(need, now)
  if (!live) return m['teacher.notHereYet']()
  if (!here) return m['teacher.notHereSince']({ time: timeOf(live.seenAt, locale) })
  const ago = agoLabel(live.changedAt, now)
  return done ? m['teacher.allDone']({ ago }) : ago
}

/** Where no card of the house is open: somebody works on a card or a project of their own, or on nothing yet. */
export const noCard = (live: Live | null): string =>
  live?.project ? m['teacher.ownWork']() : m['teacher.noWork']()
