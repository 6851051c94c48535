import { contrast, laidOver } from './contrast.ts'
import { strangers } from './strangers.ts'
import type { Box, SeenPaper, SeenPart, SeenText } from './seen.ts'

export const kinds = ['overlap', 'cut', 'empty', 'language', 'pale', 'small', 'file'] as const
type Kind = (typeof kinds)[number]

/** Something on a page that a reader would stumble over. */
export interface Finding {
  readonly kind: Kind
  readonly what: string
}

/** The least size of letters, in pt. */
export interface Least {
  readonly text: number
  readonly drawn: number
}

/** What letters paint of their line: hardly ever its upper and lower edge. */
function core({ left, top, right, bottom }: Box): Box {
  const edge = (bottom - top) * 0.22
  return { left: left + 1, top: top + edge, right: right - 1, bottom: bottom - edge }
}

const meets = (a: Box, b: Box, by = 0) =>
  Math.min(a.right, b.right) - Math.max(a.left, b.left) > by &&
  Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > by

const holds = (outer: Box, inner: Box) =>
  inner.left >= outer.left - 1.5 &&
  inner.top >= outer.top - 1.5 &&
  inner.right <= outer.right + 1.5 &&
  inner.bottom <= outer.bottom + 1.5

/** Each two of them, once. */
const pairs = <One>(all: readonly One[]) =>
  all.flatMap((a, index) => all.slice(index + 1).map((b) => [a, b] as const))

const short = (text: string) => (text.length > 40 ? `${text.slice(0, 38)} …` : text)
const quoted = (text: string) => `“${short(text)}”`

function overlapping({ texts, parts }: SeenPaper): Finding[] {
  const lines = pairs(texts)
    .filter(([a, b]) => a.home === b.home && a.of !== b.of && meets(core(a.box), core(b.box), 1))
    .map(([a, b]) => `${quoted(a.text)} and ${quoted(b.text)}`)
  const covered = texts.flatMap(({ text, coveredBy }) =>
    coveredBy === null ? [] : [`${quoted(text)} below ${coveredBy}`],
  )
  const boxes = pairs(parts.map((part, number) => ({ ...part, number })))
    .filter(([a, b]) => a.home === b.home && meets(a.box, b.box, 4))
    .filter(([a, b]) => !a.inside.includes(b.number) && !b.inside.includes(a.number))
    .map(([a, b]) => `${quoted(a.name)} and ${quoted(b.name)}`)
  return [...lines, ...covered, ...boxes].map((what) => ({ kind: 'overlap', what }))
}

const cut = ({ texts, parts }: SeenPaper): Finding[] =>
  [
    ...texts
      .filter(({ box, within }) => within.some((outer) => !holds(outer, core(box))))
      .map(({ text }) => text),
    ...parts.filter(({ box, within }) => within.some((outer) => !holds(outer, box))).map(({ name }) => name),
  ].map((name) => ({ kind: 'cut', what: quoted(name) }))

const isEmpty = ({ box, marks }: SeenPart) =>
  marks === 0 || box.right - box.left < 4 || box.bottom - box.top < 4

const empty = ({ parts }: SeenPaper): Finding[] =>
  parts.filter(isEmpty).map(({ name }) => ({ kind: 'empty', what: quoted(name) }))

const inOtherLanguage = ({ texts, names }: SeenPaper): Finding[] =>
  [...texts.filter(({ of }, index) => texts[index - 1]?.of !== of), ...names].flatMap(
    ({ text, language }) => {
      const words = strangers(text, language)
      return words.length > 0
        ? [{ kind: 'language' as const, what: `${words.join(', ')} in ${quoted(text)}` }]
        : []
    },
  )

/** WCAG's figures, which hold in grey as well: they are ratios of luminance alone. */
const wanted = ({ points, bold }: SeenText) => (points >= 18 || (points >= 14 && bold) ? 3 : 4.5)

const pale = ({ texts }: SeenPaper): Finding[] =>
  texts.flatMap((seen) => {
    const ratios = seen.below.flatMap((layers) => {
      if (layers === null) return []
      const ground = laidOver(layers)
      return [contrast(laidOver([seen.colour, [...ground, 1]]), ground)]
    })
    const least = Math.min(...ratios)
    return least < wanted(seen) - 0.05
      ? [{ kind: 'pale', what: `${quoted(seen.text)} ${least.toFixed(1)} : 1` }]
      : []
  })

const small = ({ texts }: SeenPaper, least: Least): Finding[] =>
  texts
    .filter(({ points, drawn }) => points < (drawn ? least.drawn : least.text) - 0.05)
    .map(({ text, points }) => ({ kind: 'small', what: `${quoted(text)} ${points.toFixed(1)} pt` }))

/** All that is wrong on a paper, each once. */
export function findingsOn(paper: SeenPaper, least: Least): readonly Finding[] {
  const all = [
    ...overlapping(paper),
    ...cut(paper),
    ...empty(paper),
    ...inOtherLanguage(paper),
    ...pale(paper),
    ...small(paper, least),
  ]
  return all.filter(
    ({ kind, what }, index) => all.findIndex((one) => one.kind === kind && one.what === what) === index,
  )
}
