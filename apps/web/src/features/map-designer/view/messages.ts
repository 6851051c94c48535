import { writeNumber } from '@botgarten/messages'
import type { MapProblem } from '@botgarten/maps'
import type { RoadMap, MapRoad } from '@botgarten/programs'
import { language } from '#words/language.svelte.ts'
import { m, message } from '#words/message.ts'
import type { Tool } from '../model/designer.svelte.ts'

/** `Road 3 – 4`, or `Road 3 → 4` where it leads one way. */
export const roadName = ({ from, to, oneWay }: MapRoad): string =>
  oneWay ? m['design.oneWayRoad']({ from, to }) : m['design.road']({ from, to })

/** A reward with its sign. */
export const signed = (reward: number): string => writeNumber(reward, language.locale, { plus: true })

/** What to do with a tool. */
export const hintOf = (tool: Tool): string => m[`design.hint.${tool}`]()

/** Names of stations where they have some. */
export const stationName = ({ stations }: RoadMap, station: number): string => {
  const { name } = stations[station]!
  return name ? `${station} · ${name}` : m['design.station']({ station })
}

/** The same for screen readers: `Station 7, Fountain`. */
export const stationLabel = ({ stations }: RoadMap, station: number): string => {
  const { name } = stations[station]!
  return m['design.station']({ station }) + (name ? `, ${name}` : '')
}

/** All that is wrong with a drawing, a sentence each; of many the first ones. */
export function problemsSaid(problems: readonly MapProblem[]): string {
  const shown = problems.slice(0, 6).map(({ kind, facts }) => message(`design.problem.${kind}`, facts))
  const more = problems.length - shown.length
  return [...shown, ...(more > 0 ? [m['design.moreProblems']({ count: more })] : [])].join('\n')
}
