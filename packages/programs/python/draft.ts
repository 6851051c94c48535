import type { Facts } from '@botgarten/blocks'
import { Names } from './names.ts'
import type { Line, PythonInput, PythonNote, Say } from './types.ts'

/** A device of the head of the file: it is made once, and lit with every block that uses it. */
export interface Device {
  readonly order: number
  readonly name: string
  readonly code: readonly string[]
  readonly blocks: Set<string>
  /** What has to be plugged in for it, in words. */
  readonly plug?: string
}

/** A file while it is written. */
export class Draft {
  readonly input: PythonInput
  readonly say: Say
  readonly names = new Names()
  readonly imports = new Map<string, Set<string>>()
  readonly constants: Line[] = []
  readonly devices = new Map<string, Device>()
  readonly helpers = new Map<
    string,
    { readonly rows: readonly string[]; readonly blocks: readonly string[] }
  >()
  readonly notes: PythonNote[] = []
  /** Where lines go. */
  lines: Line[] = []
  depth = 0
  /** Value blocks of the statement that is written, and comments that come before it. */
  pending = new Set<string>()
  before: string[] = []

  constructor(input: PythonInput, say: Say) {
    this.input = input
    this.say = say
  }

  import(module: string, name: string): string {
    const known = this.imports.get(module)
    if (known) known.add(name)
    else this.imports.set(module, new Set([name]))
    return name
  }

  /** Device by what it is; made when it is asked for first. */
  device(key: string, make: () => Omit<Device, 'blocks'>): string {
    const known: Device = this.devices.get(key) ?? { ...make(), blocks: new Set() }
    this.devices.set(key, known)
    for (const block of this.pending) known.blocks.add(block)
    return known.name
  }

  /** Gives back what takes all of the head away again that was added since. */
  mark(): () => void {
    const [imports, devices, helpers] = [copied(this.imports), new Map(this.devices), new Map(this.helpers)]
    const [lines, constants, depth] = [this.lines.length, this.constants.length, this.depth]
    return () => {
      restore(this.imports, imports)
      restore(this.devices, devices)
      restore(this.helpers, helpers)
      this.lines.length = lines
      this.constants.length = constants
      this.depth = depth
    }
  }

  /** Gives back what makes as if nothing had been written since. */
  tryOut(): () => void {
    const takeBack = this.mark()
    const [notes, pending, before] = [this.notes.length, new Set(this.pending), [...this.before]]
    return () => {
      takeBack()
      this.notes.length = notes
      this.pending = pending
      this.before = before
    }
  }

  line(code: string): void {
    for (const text of new Set(this.before.splice(0))) this.comment(text)
    this.lines.push({ code, depth: this.depth, blocks: [...this.pending] })
  }

  comment(text: string): void {
    for (const row of commentRows(text, 88 - 4 * this.depth - 2))
      this.lines.push({ code: row === '' ? '#' : `# ${row}`, depth: this.depth, blocks: [...this.pending] })
  }

  /** A comment; where the same one stands just above, that is of these blocks too. */
  commentOnce(text: string): void {
    const { depth } = this
    const from = this.#last.text === text && this.#last.depth === depth ? this.#last.from : this.lines.length
    if (from === this.lines.length || this.lines.length !== this.#last.end) {
      this.#last = { text, depth, from: this.lines.length, end: 0 }
      this.comment(text)
    }
    this.#last.end = this.lines.length
    for (let k = this.#last.from; k < this.#last.end; k++)
      this.lines[k] = { ...this.lines[k]!, blocks: [...new Set([...this.lines[k]!.blocks, ...this.pending])] }
  }
  #last = { text: '', depth: 0, from: 0, end: 0 }

  note(block: string, key: string, facts?: Facts): string {
    return this.#noted(block, this.say(key, facts), false)
  }

  gap(block: string, problem: string, facts?: Facts): string {
    return this.#noted(block, this.say(`${problem}.title`, facts), true)
  }

  #noted(block: string, text: string, gap: boolean): string {
    this.notes.push({ block, text, gap })
    return text
  }
}

/** Rows of a comment, none longer than a line may be where it has spaces. */
function commentRows(text: string, width: number): readonly string[] {
  return text
    .replace(/[\p{Cc}\u2028\u2029]+/gu, '\n')
    .split('\n')
    .flatMap((row) => wrapped(row.trim(), width))
}

function wrapped(row: string, width: number): readonly string[] {
  if (row.length <= width) return [row]
  const space = row.lastIndexOf(' ', width)
  if (space <= 0) return [row]
  return [row.slice(0, space), ...wrapped(row.slice(space + 1), width)]
}

const copied = (imports: Draft['imports']) =>
  new Map([...imports].map(([module, names]) => [module, new Set(names)]))

function restore<Key, Value>(map: Map<Key, Value>, before: ReadonlyMap<Key, Value>): void {
  map.clear()
  for (const [key, value] of before) map.set(key, value)
}
