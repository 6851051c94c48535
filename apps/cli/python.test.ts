import { readFileSync, writeFileSync, mkdtempSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { PositionEncoding, Workspace } from '@astral-sh/ruff-wasm-nodejs'
import { cardDocument } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { writeProjectFile, type Project } from '@botgarten/programs'
import { describe, expect, it } from 'vitest'
import { botgarten } from './testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-python-'))
const given = join(import.meta.dirname, '../../packages/programs/testing/open-roberta')

/** A card's solution as a project's file. */
function solution(id: string): string {
  const { card, world } = content.card(id)!
  const document = cardDocument(world, card, content.program(id, 'solution')!, 0)
  const path = join(folder, `${id}.json`)
  writeFileSync(path, writeProjectFile({ botgarten: 1, name: id, assets: {}, ...document }))
  return path
}

/** Files as a person reads them; `vitest -u` writes them again. */
const goldens: readonly (readonly [name: string, from: string, ...options: string[]])[] = [
  ['friendship-pybricks-en', solution('friendship')],
  ['friendship-ev3dev2-de', solution('friendship'), '--dialect', 'ev3dev2', '--lang', 'de'],
  ['square-pybricks-de', solution('square'), '--lang', 'de'],
  ['chameleon-ev3dev2-en', solution('chameleon'), '--dialect', 'ev3dev2'],
  ['tidy-up-pybricks-en', solution('tidy-up')],
  ['railway-pybricks-de', solution('railway'), '--lang', 'de'],
  ['railway-learner-pybricks-en', solution('railway'), '--learner'],
  ['either-or-pybricks-en', solution('either-or')],
  ['functions-pybricks-en', join(given, 'programs/composed__common__functionsBasic.xml')],
  [
    'lists-ev3dev2-de',
    join(given, 'programs/composed__common__listOperations.xml'),
    '--dialect',
    'ev3dev2',
    '--lang',
    'de',
  ],
  ['friendship-spike-de', solution('friendship'), '--dialect', 'spike', '--lang', 'de'],
  ['interest-spike-en', solution('interest'), '--dialect', 'spike'],
  ['action-pybricks-de', join(given, 'programs/upstream__xNN__action.xml'), '--lang', 'de'],
]

/** Ruff's classic rules and the order of imports; what a child never uses again is the child's own business (F841). */
const ruff = new Workspace(
  {
    'target-version': 'py37',
    lint: { select: ['E4', 'E7', 'E9', 'F', 'I'], ignore: ['F841'] },
  },
  PositionEncoding.Utf16,
)

describe('botgarten convert FILE out.py', () => {
  it.each(goldens)('%s: the bytes that a person has read', async (name, from, ...options) => {
    const out = join(folder, `${name}.py`)
    const { status, stderr } = await botgarten('convert', from, out, ...options)
    expect({ status, stderr }).toEqual({ status: 0, stderr: '' })
    await expect(readFileSync(out, 'utf8')).toMatchFileSnapshot(`goldens/${name}.py`)
  })

  it.each(goldens)('%s: ruff finds nothing and would write it so', async (name, from, ...options) => {
    const out = join(folder, `${name}.py`)
    await botgarten('convert', from, out, ...options)
    const text = readFileSync(out, 'utf8')
    const found = (ruff.check(text) as { code: string; message: string }[]).map(
      ({ code, message }) => `${code} ${message}`,
    )
    expect(found).toEqual([])
    expect(ruff.format(text)).toBe(text)
  })

  it('leaves errors for gaps out where they are not wanted', async () => {
    const project = JSON.parse(readFileSync(solution('square'), 'utf8')) as Project
    const [stack] = project.programs['main']!.stacks
    const gap = { ...stack!.blocks[0]!, ...{ id: 'gap', type: 'robControls_wait_time' } }
    const program = { ...project.programs['main']!, stacks: [{ ...stack!, blocks: [...stack!.blocks, gap] }] }
    const from = join(folder, 'gap.json')
    writeFileSync(from, writeProjectFile({ ...project, programs: { main: program } }))
    const made = async (...options: string[]) => {
      const out = join(folder, 'gap.py')
      await botgarten('convert', from, out, ...options)
      return readFileSync(out, 'utf8')
    }
    expect(await made()).toContain('raise NotImplementedError(')
    expect(await made('--no-errors')).not.toContain('raise')
  })

  it('knows three robots, and no other', async () => {
    const out = join(folder, 'other.py')
    expect((await botgarten('convert', solution('square'), out, '--dialect', 'nxt')).stderr).toMatch(
      /pybricks, ev3dev2 or spike|pybricks or ev3dev2 or spike/,
    )
  })

  it('reads no Python back', async () => {
    const { status, stderr } = await botgarten('convert', join(folder, 'x.py'), join(folder, 'x.json'))
    expect(status).toBe(2)
    expect(stderr).toContain('not read back')
  })
})
