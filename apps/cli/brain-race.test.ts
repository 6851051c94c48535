import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { content } from '@botgarten/content/files'
import { afterAll, expect, it } from 'vitest'
import { botgarten } from './testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-race-'))
afterAll(() => rmSync(folder, { recursive: true }))

interface Report {
  readonly lanes: readonly {
    readonly kind: string
    readonly problem: string | null
    readonly cm: number
    readonly bumps: number
    readonly starts: readonly { readonly moved: boolean; readonly sealed: boolean }[]
  }[]
}
const race = (...args: string[]) => botgarten<Report>('race', 'four-brains', '--seed', '7', ...args)

it('races four brains in one line that fits its schema, the same one twice, and writes its table', async () => {
  const csv = join(folder, 'race.csv')
  const { stdout, status, json } = await race('--course', 'garden', '--csv', csv, '--json')
  expect(status).toBe(0)
  expect(stdout.trim()).not.toContain('\n')
  const schema = readFileSync(join(import.meta.dirname, 'schemas/race-four-brains.json'), 'utf8')
  const fits = new Ajv2020({ allowUnionTypes: true }).compile(JSON.parse(schema) as object)
  fits(json())
  expect(fits.errors).toBeNull()
  expect((await race('--course', 'garden', '--json')).stdout).toBe(stdout)

  const { lanes } = json()
  expect(lanes.map(({ kind }) => kind)).toEqual(['hand', 'examples', 'trying', 'ifThen'])
  for (const { problem, cm, starts } of lanes) {
    expect([problem, cm > 400]).toEqual([null, true])
    expect(starts.map(({ sealed, moved }) => [sealed, moved])).toEqual(
      [false, false, true, true, true].map((sealed) => [sealed, false]),
    )
  }
  // What the sketch of this race came to, with the same two brains.
  const [hand, , trying, ifThen] = lanes
  expect([Math.round(hand!.cm), hand!.bumps]).toEqual([862, 9])
  expect([Math.round(ifThen!.cm), ifThen!.bumps]).toEqual([896, 0])
  expect([trying!.bumps, trying!.cm > 875]).toEqual([0, true])
  const rows = readFileSync(csv, 'utf8').trim().split('\n')
  expect(rows).toHaveLength(1 + 5 * 4)
}, 60_000)

it('says which course there is not', async () => {
  const { status, stderr } = await race('--course', 'moon')
  expect(status).toBe(2)
  expect(stderr).toContain(
    `There is no course "moon". Courses: ${content.courses.map(({ id }) => id).join(', ')}.`,
  )
})
