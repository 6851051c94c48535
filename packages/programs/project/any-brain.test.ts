import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { parseProject, refusalOf, salvageProject, writeProject, writeProjectFile } from '../index.ts'
import { project } from '../testing/every-part.ts'

/** Written by Botgarten 0.1: tables lay in a part of their own. */
const old = readFileSync(new URL('../testing/old/tables.json', import.meta.url), 'utf8')
const opened = parseProject(old)
const written = JSON.parse(writeProject(opened)) as typeof project & {
  readonly brains: { readonly [id: string]: { readonly kind: string; readonly q: readonly number[] } }
}

describe('a table that was learned by trying', () => {
  it('is read from a file in which it lay beside the brains, with all its values', () => {
    const { tables } = JSON.parse(old) as typeof opened
    expect(opened.tables).toEqual(tables)
    expect(opened.brains).toEqual({})
    expect(opened.tables!['try']).toMatchObject({ kind: 'table', moves: 1920 })
  })

  it('is written as a brain among the brains, and comes back the same', () => {
    expect(written).not.toHaveProperty('tables')
    expect(written.brains['try']).toEqual(opened.tables!['try'])
    expect(written.botgarten).toBe(4)
    for (const text of [writeProject(opened), writeProjectFile(opened)])
      expect(parseProject(text)).toEqual(opened)
    expect(refusalOf(opened)).toBeNull()
  })

  it('keeps the minutes in which it was learned, so that their curves can be drawn again', () => {
    const curve = Array.from({ length: 60 }, (_, k) => ({ pay: 10.25 * k - 5, bumps: 60 - k }))
    const table = { ...opened.tables!['try']!, curve }
    expect(parseProject(writeProject({ ...opened, tables: { try: table } })).tables).toEqual({ try: table })
  })

  it('lies beside networks', () => {
    const both = { ...project, tables: opened.tables! }
    const read = parseProject(writeProject(both))
    expect(read).toEqual({ ...both, botgarten: 4 })
    expect(parseProject(writeProject({ ...read, tables: {} })).botgarten).toBe(project.botgarten)
  })

  it('is refused as a brain where it is none', () => {
    const { try: table } = opened.tables!
    const states = {
      edges: [Array.from({ length: 1000 }, (_, k) => k), Array.from({ length: 1000 }, (_, k) => k)],
    }
    const odd = [
      { ...table, q: table!.q.slice(1) },
      { ...table, q: table!.q.map(() => 1e300) },
      { ...table, ...states, q: Array(3_000_000).fill(0), tries: Array(3_000_000).fill(0) },
      { ...table, hold: 1e6 },
      { ...table, curve: Array.from({ length: 61 }, () => ({ pay: 0, bumps: 0 })) },
      { ...table, curve: [{ pay: 0, bumps: -1 }] },
      { ...table, curve: [{ pay: 1e300, bumps: 0 }] },
      { kind: 'table' },
      { ...table, kind: 'network' },
    ]
    for (const brain of odd)
      expect(() => parseProject({ ...written, brains: { try: brain } })).toThrow(
        expect.objectContaining({ name: 'ProjectError' }),
      )
    const proto = writeProject(opened).replace('"try":{"', '"__proto__":{"')
    expect(() => parseProject(proto)).toThrow(expect.objectContaining({ name: 'ProjectError' }))
  })

  it('that is damaged is left out where the rest is saved', () => {
    const damaged = { ...written, brains: { ...written.brains, other: { kind: 'table', q: [] } } }
    const { project: rest, lost } = salvageProject(damaged, project)!
    expect(lost).toBe(true)
    expect(rest.tables).toEqual(opened.tables)
  })
})
