import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { Block } from '@botgarten/blocks'
import { project } from '../testing/every-part.ts'
import { pathsIn, replaced } from '../testing/paths.ts'
import { randomPrograms } from '../testing/random-programs.ts'
import { parseProject, ProjectError, refusalOf, writeProject, type Limit, type Project } from '../index.ts'

const program = (...blocks: readonly Block[]) => ({
  stacks: [{ x: 0, y: 0, blocks }],
  config: { stacks: [] },
})
const withMain = (...blocks: readonly Block[]): Project => ({
  ...project,
  programs: { main: program(...blocks) },
})

const loops = (depth: number): Block => {
  const inside = depth === 1 ? [{ id: 'innermost', type: 'robActions_motorDiff_stop' }] : [loops(depth - 1)]
  return { id: `loop${depth}`, type: 'robControls_loopForever', statements: { DO: inside } }
}
const values = (depth: number): Block =>
  depth === 1
    ? { id: 'v1', type: 'math_number', fields: { NUM: '1' } }
    : { id: `v${depth}`, type: 'math_arithmetic', values: { A: values(depth - 1) } }
const text = (letters: number): Block => ({ id: 'text', type: 'text', fields: { TEXT: 'x'.repeat(letters) } })
const hash = '1'.repeat(64)
const withPicture = (base64: string): Project => ({
  ...project,
  assets: { [hash]: { type: 'image/png', base64 } },
})

/** Does reading refuse the file that would be written? If not, it has the same content. */
function readingRefuses(written: Project, sameContent = true): ProjectError | null {
  try {
    const read = parseProject(writeProject(written))
    if (sameContent) expect(read).toEqual(JSON.parse(JSON.stringify(written)))
    return null
  } catch (error) {
    if (error instanceof ProjectError) return error
    throw error
  }
}

describe('what is written passes the limits that reading applies', () => {
  it.each<[string, Project, Limit | null]>([
    ['a project of every part', project, null],
    ['a text of 20,000 letters', withMain(text(20_000)), null],
    ['a text of 20,001 letters', withMain(text(20_001)), { kind: 'text', most: 20_000, block: 'text' }],
    ['a text of 21,600 letters in a loop', withMain({ ...loops(1), statements: { DO: [text(21_600)] } }), { kind: 'text', most: 20_000, block: 'text' }],
    ['197 loops in each other', withMain(loops(197)), null],
    ['198 loops in each other', withMain(loops(198)), { kind: 'depth', most: 600 }],
    ['295 values in each other', withMain(values(295)), null],
    ['300 values in each other', withMain(values(300)), { kind: 'depth', most: 600 }],
    ['1,000 loops in each other', withMain(loops(1000)), { kind: 'depth', most: 600 }],
    ['a name of 20,001 letters', { ...project, name: 'n'.repeat(20_001) }, { kind: 'text', most: 20_000 }],
    ['weights named by 221 letters', { ...project, brains: { ['b'.repeat(221)]: project.brains['net']! } }, { kind: 'name', most: 220 }],
    ['a block named by 201 letters', withMain({ id: 'b'.repeat(201), type: 'text' }), { kind: 'name', most: 200, block: 'b'.repeat(201) }],
    ['a picture of 5 MB', withPicture('A'.repeat(5_000_000)), { kind: 'size', most: 5_000_000 }],
    ['101 things', { ...project, world: { ...project.world, obstacles: Array.from({ length: 101 }, (_, k) => ({ ...project.world.obstacles[0]!, id: `t${k}` })) } }, { kind: 'count', most: 100 }],
  ])('%s', (_what, one, limit) => {
    const refusal = refusalOf(one)
    expect(refusal?.limit ?? null).toEqual(limit)
    expect(readingRefuses(one)?.limit ?? null).toEqual(limit)
    // What has been looked at once gets the same answer.
    expect(refusalOf(one)?.limit ?? null).toEqual(limit)
  }) // prettier-ignore

  it('the last letter that fits is the same on both sides, with umlauts and escapes, known parts or new ones', () => {
    const base = writeProject({ ...project, name: '' }).length
    const assets = { [hash]: { type: 'image/png', base64: '' } } as const
    const own = JSON.stringify(assets).length - 2
    for (const name of ['', 'Ä"\\\n€'])
      for (const more of [0, 1]) {
        const before = writeProject({ ...project, name })
        const bytes = new TextEncoder().encode(before).length
        const comma = 1
        const base64 = 'A'.repeat(5_000_000 - bytes - own - comma + more)
        const whole = { ...project, name, assets: { ...project.assets, [hash]: { type: 'image/png', base64 } } } as const
        expect(new TextEncoder().encode(writeProject(whole)).length).toBe(5_000_000 + more)
        expect(refusalOf(whole) === null).toBe(more === 0)
        expect(readingRefuses(whole) === null).toBe(more === 0)
        expect(refusalOf(whole) === null).toBe(more === 0)
      }
    expect(base).toBeGreaterThan(0)
  }) // prettier-ignore

  it('pictures and programs that passed are known, and everything around them is still looked at', () => {
    expect(refusalOf(project)).toBeNull()
    expect(refusalOf({ ...project, name: 'n'.repeat(20_001) })?.limit?.kind).toBe('text')
    expect(refusalOf({ ...project, programs: { ['p'.repeat(221)]: project.programs['main']! } })?.limit?.kind).toBe('name')
    expect(refusalOf({ ...project, programs: {} })?.reason).toBe('notAProject')
    const known = parseProject(withPicture('A'.repeat(4_000_000)))
    const two = { ...known.assets, ['2'.repeat(64)]: { type: 'image/png', base64: 'A'.repeat(2_000_000) } } as const
    expect(refusalOf({ ...known, assets: two })?.reason).toBe('tooBig')
    expect(refusalOf({ ...known, assets: { notAHash: known.assets[hash]! } })).not.toBeNull()
  }) // prettier-ignore

  const part = fc.oneof(
    fc.jsonValue({ maxDepth: 3 }),
    fc.constantFrom<unknown>(-1, 1e308, NaN, Infinity, {}, [], '', 'a'.repeat(201), 'a'.repeat(221)),
    fc.constantFrom<unknown>('t'.repeat(20_001), 't'.repeat(200_001), [loops(230)], { a: values(310) }),
  )

  it('whatever the program is, both sides say the same and the content is equal', () => {
    fc.assert(
      fc.property(randomPrograms, fc.string(), (main, name) => {
        const one = { ...project, name, programs: { main } }
        expect(readingRefuses(one) === null).toBe(refusalOf(one) === null)
      }),
      { numRuns: 200 },
    )
  })

  it('whatever a part is, what writing lets through reading opens, and what reading refuses writing refuses', () => {
    const paths = pathsIn(project).filter((path) => path.length > 0)
    fc.assert(
      fc.property(fc.constantFrom(...paths), part, (path, value) => {
        const one = replaced(project, path, value) as Project
        // `sorting` may hold anything that is JSON: what is none becomes null in a file.
        if (path[0] === 'sorting' && /NaN|Infinity/.test(String(value))) return
        const odd = typeof one.assets !== 'object' || typeof one.programs !== 'object' || !one.assets || !one.programs
        if (odd) return
        expect(readingRefuses(one, false) === null).toBe(refusalOf(one) === null)
      }),
      { numRuns: 3000 },
    )
  }) // prettier-ignore
})
