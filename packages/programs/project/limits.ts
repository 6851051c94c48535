import { ProjectError } from './error.ts'

/** product.md 8 */
const mostBytes = 5_000_000
/** Levels of brackets in the file; a block inside a block takes two or three. */
const deepest = 600
/** Objects, lists and simple values together. */
const mostParts = 1_000_000
export const longestText = 20_000
export const longestId = 200

/** Names that reach into every object where they are used as a key. */
const reserved = new Set(['__proto__', 'constructor', 'prototype'])
export const isReserved = (name: string) => reserved.has(name)

export function refuseBigText(text: string): void {
  const tooBig = text.length > mostBytes || new TextEncoder().encode(text).length > mostBytes
  if (tooBig) throw new ProjectError('tooBig', 'A project has at most 5 MB.')
}

/** Looks through foreign data without recursion: size, depth, and keys that must not be. */
export function refuseOversize(root: unknown): void {
  const stack: { readonly value: unknown; readonly depth: number }[] = [{ value: root, depth: 0 }]
  let parts = 0
  let bytes = 0
  for (let top = stack.pop(); top; top = stack.pop()) {
    const { value, depth } = top
    bytes += typeof value === 'string' ? value.length : 0
    if (++parts > mostParts || bytes > mostBytes) throw new ProjectError('tooBig', 'The project is too big.')
    if (typeof value !== 'object' || value === null) continue
    if (depth >= deepest) throw new ProjectError('notAProject', 'The project is nested too deeply.')
    for (const [name, child] of Object.entries(value)) {
      refuseKey(name)
      stack.push({ value: child, depth: depth + 1 })
    }
  }
}

function refuseKey(name: string): void {
  if (isReserved(name)) throw new ProjectError('notAProject', `A key must not be called "${name}".`)
}

/** What one world holds at most: so much is still drawn and driven smoothly on a slow laptop. */
export const most = { robots: 4, obstacles: 100, areas: 100, lines: 100, points: 1000 }
