import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, expect, it } from 'vitest'
import { botgarten } from './testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-notebook-'))
afterAll(() => rmSync(folder, { recursive: true }))
const out = join(folder, 'number.ipynb')
const points = join(folder, 'points.csv')
writeFileSync(points, 'x,y\n1,2\n2,2\n9,8\n8,9\n5,5\n')

interface Report {
  readonly practised: number
  readonly q: { readonly [action: string]: number }
  readonly inertia: readonly number[]
}

/** The number that a notebook makes, as its data say it, and all of its texts. */
function written() {
  const { nbformat, cells } = JSON.parse(readFileSync(out, 'utf8')) as {
    nbformat: number
    cells: { cell_type: string; source: string[] }[]
  }
  expect(nbformat).toBe(4)
  const sources = (type: string) =>
    cells.filter(({ cell_type }) => cell_type === type).map(({ source }) => source.join(''))
  const [, shown] = /"shown": (.+)\n}/.exec(sources('code')[0]!)!
  return { shown: Number(shown), texts: sources('markdown') }
}

it('learn net writes a notebook of its error, in every language', async () => {
  const { json } = await botgarten<Report>(
    ...['learn', 'net', 'dodge', '--solution', '--rounds', '3', '--notebook', out, '--json'],
  )
  const { shown, texts } = written()
  expect(shown).toBeCloseTo(100 * Math.sqrt(json().practised), 12)
  expect(texts[0]).toContain(`Botgarten showed **${shown}**`)
  expect(texts[0]).toContain(`Botgarten hat **${shown}** gezeigt`)
  expect(texts.join()).not.toContain('notebook.')
})

it('learn q writes a notebook of what the best action at the start is worth', async () => {
  const { json } = await botgarten<Report>(
    ...['learn', 'q', '--map', 'railway', '--start', '0', '--goal', '5', '--episodes', '9'],
    ...['--notebook', out, '--json'],
  )
  const atStart = Object.entries(json().q).filter(([name]) => name.startsWith('0-'))
  expect(written().shown).toBe(Math.max(...atStart.map(([, value]) => value)))
})

it('learn kmeans writes a notebook of its inertia, from the start that was best', async () => {
  const { json } = await botgarten<Report>(
    ...['learn', 'kmeans', '--data', points, '--k', '2', '--notebook', out, '--json'],
  )
  expect(written().shown).toBe(json().inertia.at(-1))
})

it('says that several seeds make no notebook, and which file cannot be written', async () => {
  const seeds = await botgarten('learn', 'net', 'dodge', '--seeds', '2', '--notebook', out)
  expect(seeds.status).toBe(2)
  expect(seeds.stderr).toContain('--notebook writes one result')
  const nowhere = join(folder, 'no', 'number.ipynb')
  const { status, stderr } = await botgarten(
    ...['learn', 'kmeans', '--data', points, '--k', '2', '--notebook', nowhere],
  )
  expect([status, stderr.includes(nowhere)]).toEqual([1, true])
})
