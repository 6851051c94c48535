import { ProjectError } from './error.ts'

/** product.md 8 */
export const mostBytes = 5_000_000
/** Levels of brackets in the file; a block inside a block takes two or three. */
export const deepest = 600
/** Objects, lists and simple values together. */
export const mostParts = 1_000_000
export const longestText = 20_000
/** Ids of blocks. */
export const longestId = 200
/** Names used as keys: some are ids with more behind them, such as a hidden neuron's `block#k`. */
export const longestKey = 220

/** Names that reach into every object where they are used as a key. */
const reserved = new Set(['__proto__', 'constructor', 'prototype'])
export const isReserved = (name: string) => reserved.has(name)

/** Most bytes that UTF-8 takes for one unit of a text. */
const widest = 3

export function refuseBigText(text: string): void {
  if (text.length * widest <= mostBytes) return
  if (text.length > mostBytes || bytesIn(text) > mostBytes) throw tooBig()
}

export const bytesIn = (text: string): number => new TextEncoder().encode(text).length

export const tooBig = () =>
  new ProjectError('tooBig', 'A project has at most 5 MB.', {}, { kind: 'size', most: mostBytes })

/**
 * Looks through foreign data without recursion: size, depth, and keys that must not be. Returns how many parts it has. Two
 * stacks of plain values: a pair for each of thousands of parts would be most of what a save leaves to the collector.
 */
export function refuseOversize(root: unknown): number {
  const values = [root]
  const depths = [0]
  let parts = 0
  let bytes = 0
  while (values.length > 0) {
    const [value, depth] = [values.pop(), depths.pop()!]
    bytes += typeof value === 'string' ? value.length : 0
    if (++parts > mostParts || bytes > mostBytes) throw tooBig()
    if (typeof value !== 'object' || value === null) continue
    if (depth >= deepest) throw tooDeep()
    for (const child of childrenOf(value)) {
      values.push(child)
      depths.push(depth + 1)
    }
  }
  return parts
}

function childrenOf(value: object): readonly unknown[] {
  if (Array.isArray(value)) return value
  Object.keys(value).forEach(refuseKey)
  return Object.values(value)
}

const tooDeep = () =>
  new ProjectError('notAProject', 'The project is nested too deeply.', {}, { kind: 'depth', most: deepest })

function refuseKey(name: string): void {
  if (isReserved(name)) throw new ProjectError('notAProject', `A key must not be called "${name}".`)
}

/** What one world holds at most: so much is still drawn and driven smoothly on a slow laptop. */
export const most = { robots: 4, obstacles: 100, areas: 100, lines: 100, points: 1000 }
