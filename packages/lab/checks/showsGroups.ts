import { cos, sin } from '@botgarten/numbers'
import { nameOf, numberOf, type Kind } from './kind.ts'
import { robotIn, type Moment } from './moment.ts'

/** By kind of area: what stood on the display there, with how many ticks. */
interface Memory {
  seen: { [kind: string]: { [text: string]: number } }
  done: boolean
}

/** Share of the time in which the display may still show what came before. */
const MOSTLY = 0.75

/**
 * While the colour sensor is over an area, the first row of the display shows the same text on every area of its kind (its
 * id up to the last `-`) and another one on every other kind, for at least `seconds` on each of `kinds` kinds; it stays
 * passed. `letters` 1: a text without a letter is none.
 */
export const showsGroups: Kind<Memory> = {
  needs: ['kinds', 'letters'],
  lacks: ['some'],
  begin: () => ({ seen: {}, done: false }),
  observe(check, moment, memory) {
    const kind = kindUnder(moment)
    const text = (robotIn(moment).display[0] ?? '').trim()
    const counts = numberOf(check, 'letters') === 1 ? /\p{L}/u.test(text) : text !== ''
    if (kind === null || !counts) return memory.done
    const texts = (memory.seen[kind] ??= {})
    texts[text] = (texts[text] ?? 0) + 1
    memory.done ||= tellsApart(memory, Number(nameOf(check, 'kinds')), check.seconds * 60)
    return memory.done
  },
  missing(check, { seen }) {
    const shown = Object.values(seen).flatMap((texts) => mostSeen(texts, check.seconds * 60) ?? [])
    const told = shown.filter((text) => shown.indexOf(text) === shown.lastIndexOf(text)).length
    return { what: 'some', facts: { told, kinds: numberOf(check, 'kinds') } }
  },
}

function tellsApart({ seen }: Memory, kinds: number, least: number): boolean {
  const shown = Object.values(seen).map((texts) => mostSeen(texts, least))
  return shown.length >= kinds && !shown.includes(null) && new Set(shown).size === shown.length
}

/** The text that stood there nearly always; null where there is none, or it was too short. */
function mostSeen(texts: { readonly [text: string]: number }, least: number): string | null {
  const [[text, most] = ['', 0]] = Object.entries(texts).sort((a, b) => b[1] - a[1])
  const all = Object.values(texts).reduce((sum, ticks) => sum + ticks, 0)
  return all >= least && most >= MOSTLY * all ? text : null
}

/** What kind of area lies under the colour sensor. */
function kindUnder(moment: Moment): string | null {
  const sensors = Object.values(moment.world.robots[0]!.config.sensors)
  const place = sensors.find(({ kind }) => kind === 'colour')
  if (!place) return null
  const { x, y, heading } = robotIn(moment)
  const [c, s] = [cos(heading), sin(heading)]
  const at = { x: x + c * place.x - s * place.y, y: y + s * place.x + c * place.y }
  const area = moment.world.areas.find(({ shape, pose }) => {
    if (shape.kind !== 'rectangle' || pose.heading !== 0) return false
    return Math.abs(at.x - pose.x) < shape.width / 2 && Math.abs(at.y - pose.y) < shape.height / 2
  })
  return area ? area.id.replace(/-[^-]*$/, '') : null
}
