import { bandOf, fewest, sumOf, type PaperCounts } from '@botgarten/answers'
import type { LoadedForm } from '@botgarten/content/questionnaires'
import { columnsIn } from './forms.ts'

/** Most sheets of one class. */
const mostSheets = 200

/** Counts as a teacher types them in from sheets of paper. */
export class Typing {
  readonly #form: string
  readonly columns: ReturnType<typeof columnsIn>
  grade = $state(5)
  sheets = $state(0)
  /** By item and option. */
  counts = $state<{ [item: string]: number[] }>({})
  /** By item, a sentence a line. */
  lines = $state<{ [item: string]: string }>({})

  constructor(loaded: LoadedForm) {
    this.#form = loaded.form.id
    this.columns = columnsIn(loaded)
    for (const { id, kind, options } of this.columns)
      if (kind === 'text') this.lines[id] = ''
      else this.counts[id] = options.map(() => 0)
  }

  /** Items whose counts are together more than there are sheets. */
  get tooMany(): readonly string[] {
    return Object.entries(this.counts).flatMap(([item, counts]) =>
      sumOf(counts.map(wholeOf)) > wholeOf(this.sheets) ? [item] : [],
    )
  }

  get isEnough(): boolean {
    return wholeOf(this.sheets) >= fewest
  }

  get made(): PaperCounts | null {
    if (!this.isEnough || this.tooMany.length > 0) return null
    const whole = Object.entries(this.counts).map(([item, counts]) => [item, counts.map(wholeOf)] as const)
    const open = Object.entries(this.lines).map(([item, text]) => [item, sentencesIn(text)] as const)
    return {
      ...{ form: this.#form, bands: [bandOf(this.grade)], n: wholeOf(this.sheets) },
      ...{ counts: Object.fromEntries(whole), open: Object.fromEntries(open) },
    }
  }
}

/** An empty field is undefined to Svelte. */
const wholeOf = (typed: number | null | undefined): number =>
  Math.min(mostSheets, Math.max(0, Math.floor(Number(typed ?? 0)) || 0))

/** From A to Z: the order of the sheets says nothing of who wrote them. */
const sentencesIn = (text: string): readonly string[] =>
  text
    .split('\n')
    .map((line) => line.trim().slice(0, 500))
    .filter((line) => line !== '')
    .sort((a, b) => a.localeCompare(b))
