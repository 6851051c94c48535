import {
  meanOf,
  medianOf,
  study2020,
  sumOf,
  total,
  type Band,
  type Column,
  type StudyGroup,
  type Tally,
} from '@botgarten/answers'
import {
  moments,
  topics,
  type FormItem,
  type LoadedForm,
  type Topic,
} from '@botgarten/content/questionnaires'
import { columnsIn } from './forms.ts'
import type { Source } from './source.ts'

/** A scale item of a group: null where fewer than five answered. */
export interface ScaleRow {
  readonly item: FormItem & { readonly kind: 'scale' }
  readonly counts: readonly number[] | null
  readonly n: number
  readonly mean: number | null
  readonly median: number | null
  /** The printed mean of the study's group of the same grades. */
  readonly study: number | null
}

/** The group of the study of 2020 with the same grades; undefined where there is none, or several. */
export const studyOf = ({ bands }: Tally): StudyGroup | undefined =>
  bands.length === 1 ? study2020.find(({ band }) => band === bands[0]) : undefined

function studyMean(item: ScaleRow['item'], group: StudyGroup | undefined): number | null {
  if (!group || !item.topic || item.id !== `${item.scale}-${item.topic}`) return null
  if (item.scale === 'interest') return group.interest[item.topic]
  return item.scale === 'ease' ? group.ease[item.topic] : null
}

/** The counts of an item of a group, as far as they are shown. */
export function countsIn(tally: Tally, item: string): readonly number[] | null {
  const counts = tally.counts[item]
  return counts && sumOf(counts) > 0 ? counts : null
}

export interface ScaleBlock {
  readonly scale: string
  readonly rows: readonly ScaleRow[]
}

/** Items of the same scale together, in the order of the form. */
export function scaleBlocks({ form }: LoadedForm, tally: Tally): readonly ScaleBlock[] {
  const scales = form.items.filter((item) => item.kind === 'scale')
  const group = studyOf(tally)
  return [...new Set(scales.map(({ scale }) => scale))].map((scale) => ({
    scale,
    rows: scales
      .filter((item) => item.scale === scale)
      .map((item): ScaleRow => {
        const counts = countsIn(tally, item.id)
        return {
          ...{ item, counts, n: counts ? sumOf(counts) : 0, study: studyMean(item, group) },
          ...{ mean: counts && meanOf(counts), median: counts && medianOf(counts) },
        }
      }),
  }))
}

/** How many guessed right what Bo does: a line a topic, from form to form. */
export interface Slope {
  readonly topic: Topic
  readonly points: readonly { readonly at: number; readonly share: number; readonly n: number }[]
}

const isRight = ({ answer, options }: Column, counts: readonly number[]) =>
  (counts[options.indexOf(answer ?? '')] ?? 0) / sumOf(counts)

function shareOf(loaded: LoadedForm, topic: Topic, tally: Tally | null) {
  const items = loaded.form.items.filter((item) => item.kind === 'robot' && item.topic === topic)
  const columns = columnsIn(loaded).filter(({ id }) => items.some((item) => item.id === id))
  const shown = columns.flatMap((column) => {
    const counts = tally && countsIn(tally, column.id)
    return counts ? [{ share: isRight(column, counts), n: sumOf(counts) }] : []
  })
  if (shown.length === 0) return null
  const share = shown.reduce((sum, one) => sum + one.share, 0) / shown.length
  return { share, n: Math.min(...shown.map(({ n }) => n)) }
}

/** One form a moment: where there are several, the one that is looked at, else the first. */
export const formsInTime = (source: Source, looked: LoadedForm): readonly LoadedForm[] =>
  moments.flatMap((moment) => {
    if (looked.form.moment === moment) return [looked]
    return source.forms.find(({ form }) => form.moment === moment) ?? []
  })

export function slopesOf(source: Source, forms: readonly LoadedForm[]): readonly Slope[] {
  const tallies = forms.map((loaded) =>
    source.isOpen(loaded.form.id) ? null : total(source.tallies(loaded)),
  )
  return topics.flatMap((topic): Slope[] => {
    const points = forms.flatMap((loaded, at) => {
      const found = shareOf(loaded, topic, tallies[at]!)
      return found ? [{ at, ...found }] : []
    })
    return points.length > 0 ? [{ topic, points }] : []
  })
}

/** `5–6`, `3–6`: grades as they are said. */
export const gradesOf = (bands: readonly Band[]): string => {
  const [first, last] = [bands[0]!.split('-')[0]!, bands.at(-1)!.split('-')[1]!]
  return `${first}–${last}`
}
