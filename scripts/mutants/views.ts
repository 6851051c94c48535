import { createHash } from 'node:crypto'
import { globSync, readFileSync } from 'node:fs'
import { join } from 'node:path'

type Kind = 'handler' | 'condition' | 'property' | 'value'

/** A component with one small fault. */
export interface ViewFault {
  readonly file: string
  /** Counted from 1. */
  readonly line: number
  readonly kind: Kind
  readonly change: string
  /** The whole file with the fault. */
  readonly text: string
}

interface Edit {
  readonly kind: Kind
  readonly from: number
  readonly to: number
  readonly by: string
}

const kinds: readonly Kind[] = ['handler', 'condition', 'property', 'value']

/** Where the brace that opens at `open` is closed; -1 where it is not. */
function closeOf(source: string, open: number): number {
  let depth = 0
  for (let at = open; at < source.length; at += 1) {
    if (source[at] === '{') depth += 1
    else if (source[at] === '}' && --depth === 0) return at
  }
  return -1
}

/** The markup, with scripts, styles and comments blanked out, so that positions stay the same. */
const markupOf = (source: string) =>
  source.replace(/<(script|style)\b[^]*?<\/\1>|<!--[^]*?-->/g, (part) => ' '.repeat(part.length))

/** `{#if a}` and `{:else if a}` with their conditions. */
function conditionsIn(markup: string): Edit[] {
  return [...markup.matchAll(/\{(?:#if|:else if) /g)].flatMap(({ index, 0: head }) => {
    const [from, to] = [index + head.length, closeOf(markup, index)]
    return to < 0 ? [] : [{ kind: 'condition' as const, from, to, by: `!(${markup.slice(from, to)})` }]
  })
}

/** Literals and looks change no behaviour. */
const isLook = (name: string, value: string) =>
  /^(class|style)/.test(name) || /^\{(-?[\d.]+|true|false|'[^']*')\}$/.test(value)

/** `onclick={…}` and other properties that have an expression. */
function propertiesIn(markup: string): Edit[] {
  return [...markup.matchAll(/(?<=\s)([a-z][\w-]*)=\{/gi)].flatMap(({ index, 0: head, 1: name = '' }) => {
    const end = closeOf(markup, index + head.length - 1)
    const value = markup.slice(index + head.length - 1, end + 1)
    if (end < 0 || isLook(name, value)) return []
    const kind: Kind = /^on[a-z]/.test(name) ? 'handler' : 'property'
    return [{ kind, from: index, to: end + 1, by: '' }]
  })
}

/** `a ? b : c` in one line, whose values change places. */
function choicesIn(markup: string): Edit[] {
  return [...markup.matchAll(/ \? ([^?:{}\n]+) : ([^?:{}\n,]+?)(?=[}),])/g)].map(
    ({ index, 0: whole, 1: yes = '', 2: no = '' }) => ({
      ...{ kind: 'value' as const, from: index, to: index + whole.length },
      by: ` ? ${no} : ${yes}`,
    }),
  )
}

/** All faults that can be made in a component's markup, in their order. */
export function faultsOf(file: string, source: string): ViewFault[] {
  const markup = markupOf(source)
  const edits = [...conditionsIn(markup), ...propertiesIn(markup), ...choicesIn(markup)]
  return edits
    .toSorted((a, b) => a.from - b.from)
    .map(({ kind, from, to, by }) => ({
      ...{ file, kind, line: source.slice(0, from).split('\n').length },
      change: `${short(source.slice(from, to))} → ${by === '' ? 'nothing' : short(by)}`,
      text: source.slice(0, from) + by + source.slice(to),
    }))
}

const short = (text: string) => text.trim().replace(/\s+/g, ' ').slice(0, 80)

const orderOf = (seed: number, ...parts: readonly string[]): string =>
  createHash('sha256')
    .update([seed, ...parts].join('\n'))
    .digest('hex')

const byOrder = <Thing>(all: readonly Thing[], order: (one: Thing) => string): readonly Thing[] =>
  all
    .map((one) => ({ one, at: order(one) }))
    .toSorted((a, b) => (a.at < b.at ? -1 : 1))
    .map(({ one }) => one)

/** The draw: one fault in each of `count` features, or `count` faults in one feature. */
interface Draw {
  readonly count: number
  readonly seed: number
  readonly feature?: string | undefined
}

/** Draws faults in views by a seed, with kinds in rotation. */
export function drawFaults(house: string, { count, seed, feature }: Draw): ViewFault[] {
  const features = faultsByFeature(house)
  const inOrder = (faults: readonly ViewFault[]) =>
    byOrder(faults, ({ file, line, change }) => orderOf(seed, file, `${line}`, change))
  if (feature !== undefined) return inOrder(features.get(feature) ?? []).slice(0, count)
  return byOrder([...features], ([name]) => orderOf(seed, name))
    .slice(0, count)
    .flatMap(([, faults], turn) => {
      const ordered = inOrder(faults)
      return ordered.find(({ kind }) => kind === kinds[turn % kinds.length]) ?? ordered[0] ?? []
    })
}

function faultsByFeature(house: string): Map<string, readonly ViewFault[]> {
  const folder = join(house, 'apps/web/src/features')
  const features = new Map<string, readonly ViewFault[]>()
  for (const path of globSync('*/**/*.svelte', { cwd: folder }).map((one) => one.replaceAll('\\', '/'))) {
    const file = `apps/web/src/features/${path}`
    const [feature = ''] = path.split('/')
    const faults = faultsOf(file, readFileSync(join(house, file), 'utf8'))
    features.set(feature, [...(features.get(feature) ?? []), ...faults])
  }
  return features
}
