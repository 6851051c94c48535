import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { afterAll, expect, it } from 'vitest'
import { botgarten } from '../testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-record-'))
afterAll(() => rmSync(folder, { recursive: true }))
const schema = new Ajv2020({ allowUnionTypes: true }).compile(
  JSON.parse(readFileSync(join(import.meta.dirname, '../schemas/record.json'), 'utf8')) as object,
)
const record = (...args: string[]) =>
  botgarten<{ readonly rows: number; readonly hash: string }>('record', ...args)

it('botgarten record copies a solution into examples, and the run is what it is without', async () => {
  const csv = join(folder, 'rows.csv')
  const { json, stdout } = await record('friendship', '--solution', '--seconds', '20', '--csv', csv, '--json')
  schema(json())
  expect(schema.errors).toBeNull()
  const lines = readFileSync(csv, 'utf8').trim().split(/\r?\n/)
  expect(lines).toHaveLength(json().rows + 1)
  expect(json().rows).toBeGreaterThan(30)
  expect((await record('friendship', '--solution', '--seconds', '20', '--json')).stdout).toBe(stdout)
  const run = await botgarten<{ hash: string }>(
    'run',
    'friendship',
    '--solution',
    '--seconds',
    '20',
    '--json',
  )
  expect(run.json().hash).toBe(json().hash)
  const learned = await botgarten<{ starts: object }>(
    'learn',
    'net',
    'friendship',
    '--examples',
    csv,
    '--json',
  )
  expect(learned.json().starts).toEqual({ passed: 3, of: 3 })
})

it('botgarten record writes what an if-then program does beside the network, which does not run', async () => {
  const project = join(folder, 'copy.json')
  const { json } = await record(
    'friendship',
    '--program',
    ifThen(),
    '--seconds',
    '10',
    '--out',
    project,
    '--json',
  )
  expect(json().rows).toBeGreaterThan(5)
  const table = await botgarten<{ rows: number }>('examples', project, '--json')
  expect(table.json().rows).toBe(json().rows)
})

it.each([
  [[], '"record" takes one card or one project file.'],
  [['friendship', '--solution', '--program', 'x.json'], 'Either --solution or --program, not both.'],
  [['friendship', '--rate', '90'], '--rate takes a number from 1 to 60, not "90".'],
])('botgarten record %j is refused', async (args, message) => {
  const { stderr, status } = await record(...args)
  expect(stderr).toContain(message)
  expect(status).toBe(2)
})

/** A program without a network that solves the same in blocks, as a project. */
function ifThen(): string {
  const { card, world } = content.card('if-then')!
  const path = join(folder, 'if-then.json')
  const project = cardProject(world, card, content.program('if-then', 'solution')!, 'if-then')
  writeFileSync(path, JSON.stringify(project))
  return path
}
