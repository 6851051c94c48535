import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { parseProject } from '@botgarten/programs'
import { afterAll, describe, expect, it } from 'vitest'
import { botgarten } from '../testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-try-'))
afterAll(() => rmSync(folder, { recursive: true }))

const fits = new Ajv2020({ allowUnionTypes: true }).compile(
  JSON.parse(readFileSync(join(import.meta.dirname, '../schemas/learn-try.json'), 'utf8')) as object,
)

interface Report {
  readonly minutes: number
  readonly decisions: number
  readonly passes: { readonly first: number | null; readonly last: boolean }
  readonly q: readonly number[]
}
const learn = (...args: string[]) => botgarten<Report>('learn', 'try', ...args)

describe('botgarten learn try', () => {
  it('learns the card’s table again, in a line that fits its schema, twice the same', async () => {
    const { status, stdout, json } = await learn('try-dodge', '--solution', '--json')
    expect(status).toBe(0)
    fits(json())
    expect(fits.errors).toBeNull()
    expect(json().q).toEqual(content.program('try-dodge', 'solution')!.tables!['try']!.q)
    expect(json()).toMatchObject({ minutes: 8, decisions: 1920, passes: { last: true } })
    expect((await learn('try-dodge', '--solution', '--json')).stdout).toBe(stdout)
  })

  it('takes the pay of the call in place of the blocks’, and a row a seed', async () => {
    const csv = join(folder, 'seeds.csv')
    const asked = ['--pay', 'bump=-5,ahead=.25', '--minutes', '1', '--seeds', '2', '--csv', csv, '--json']
    const { status, json } = await learn('try-dodge', ...asked)
    expect(status).toBe(0)
    fits(json())
    expect(fits.errors).toBeNull()
    expect(readFileSync(csv, 'utf8').trim().split('\n')).toHaveLength(3)
  })

  it('says what robots do in a cage of the zoo, in a line that fits its schema', async () => {
    const { status, json } = await botgarten('learn', 'try', '--zoo', 'spinner', '--seeds', '1', '--json')
    expect(status).toBe(0)
    fits(json())
    expect(fits.errors).toBeNull()
    const { rows } = content.senseCages.find(({ cage }) => cage.id === 'spinner')!
    expect(json()).toMatchObject({ minutes: 8, honest: rows.honest, bos: [rows.bos[0]] })
  })

  it.each([['lion'], ['spinner', 'try-dodge']])(
    'a cage that is not there, or a card beside one, is refused: %s',
    async (...args) => {
      const { status, stderr } = await botgarten('learn', 'try', '--zoo', ...args)
      expect(status).toBe(2)
      expect(stderr).toMatch(/Cage|cage|spinner/)
    },
  )

  it.each([
    [1, /nothing to learn for/, []],
    [1, /nothing to learn for/, ['--pay', 'bump=0']],
    [2, /--pay/, ['--pay', 'bump=1000000']],
    [2, /--pay/, ['--pay', 'hunger=1']],
    [2, /minutes/, ['--pay', 'bump=-1', '--minutes', '0']],
  ] as const)('ends with %i and one sentence: %s', async (code, sentence, args) => {
    const { status, stderr } = await learn('try-dodge', ...args)
    expect(status).toBe(code)
    expect(stderr).toMatch(sentence)
  })

  it('a project with a table that is none is refused', async () => {
    const { card, world } = content.card('try-dodge')!
    const project = cardProject(world, card, content.program('try-dodge', 'solution')!, 'x')
    const table = project.tables!['try']!
    const odd = [
      { ...table, q: table.q.slice(1) },
      { ...table, q: table.q.map(() => 1e300) },
      { ...table, edges: [[...table.edges[0]!].reverse(), table.edges[1]!] },
      { ...table, edges: [Array.from({ length: 1000 }, (_, k) => k), []] },
      { ...table, hold: 1e6 },
      { ...table, pay: [{ for: 'bump', coins: -1e6 }] },
      { ...table, actions: [] },
      { ...table, sensors: [{ port: '9', mode: 'distance' }] },
      { kind: 'table' },
    ]
    for (const tables of odd)
      expect(() => parseProject(JSON.stringify({ ...project, tables: { try: tables } }))).toThrow(
        expect.objectContaining({ name: 'ProjectError' }),
      )
    const proto = JSON.stringify(project).replace('"try":{', '"__proto__":{')
    expect(() => parseProject(proto)).toThrow(expect.objectContaining({ name: 'ProjectError' }))
    expect(parseProject(JSON.stringify(project)).tables).toEqual(project.tables)
    const path = join(folder, 'odd.json')
    writeFileSync(path, JSON.stringify({ ...project, tables: { try: odd[0] } }))
    expect((await learn(path)).status).toBe(1)
  })
})
