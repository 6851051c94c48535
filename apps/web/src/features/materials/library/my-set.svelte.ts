import { timesIn, whoGets, type Item, type PackLine } from '@botgarten/content/items'
import { readSetting, writeSetting } from '#storage/settings.ts'
import { targetItem, targetOf } from '../library.ts'

/** What somebody puts together to print it: kept on this device. */
interface KeptSet {
  readonly name: string
  readonly children: number
  readonly lines: readonly PackLine[]
  readonly paper: 'a4' | 'a5'
  readonly grey: boolean
  /** All of it so many times. */
  readonly sets: number
  /** In these languages; none: in the one that the page speaks. */
  readonly languages: readonly string[]
}

const empty: KeptSet = {
  ...{ name: '', children: 24, lines: [], paper: 'a4', grey: false },
  ...{ sets: 1, languages: [] },
}

/** The set of this device. */
class MySet {
  // An older version kept less of it.
  #kept = $state.raw<KeptSet>({ ...empty, ...readSetting<Partial<KeptSet>>('my-set', empty) })

  get kept(): KeptSet {
    return this.#kept
  }

  /** Lines of what is still there: another version may have named something else. */
  readonly lines = $derived(this.#kept.lines.filter(({ of }) => targetItem(of)))

  change(part: Partial<KeptSet>): void {
    this.#kept = { ...this.#kept, ...part }
    writeSetting('my-set', this.#kept)
  }

  has(item: Item): boolean {
    const of = targetOf(item)
    return this.lines.some((line) => line.of === of)
  }

  /** Puts an item in, or takes it out. */
  toggle(item: Item): void {
    const of = targetOf(item)
    if (this.has(item)) this.change({ lines: this.lines.filter((line) => line.of !== of) })
    else this.add([{ of, for: whoGets(item) }])
  }

  /** Adds what is not in it yet. */
  add(lines: readonly PackLine[]): void {
    const fresh = lines.filter(({ of }) => this.lines.every((line) => line.of !== of))
    this.change({ lines: [...this.lines, ...fresh] })
  }

  /** Prints a line so many times from now on; 0 takes it out. */
  print(of: string, times: number): void {
    const lines =
      times === 0
        ? this.lines.filter((line) => line.of !== of)
        : this.lines.map((line) => (line.of === of ? { ...line, times } : line))
    this.change({ lines })
  }

  /** How many children there are: lines that somebody counted by hand are counted by children again. */
  count(children: number): void {
    const lines = this.lines.map(({ of, for: who }) => ({ of, for: who }))
    this.change({ children, lines })
  }

  timesOf(line: PackLine): number {
    return timesIn(line, this.#kept.children)
  }
}

export const mySet = new MySet()
