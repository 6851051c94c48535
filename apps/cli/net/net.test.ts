import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { parseProject } from '@botgarten/programs'
import { afterAll, describe, expect, it } from 'vitest'
import { botgarten } from '../testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-net-'))
afterAll(() => rmSync(folder, { recursive: true }))
const schema = (name: string) =>
  new Ajv2020({ allowUnionTypes: true }).compile(
    JSON.parse(readFileSync(join(import.meta.dirname, `../schemas/${name}.json`), 'utf8')) as object,
  )

let files = 0
function file(text: string, ending = 'csv'): string {
  const path = join(folder, `${++files}.${ending}`)
  writeFileSync(path, text)
  return path
}

const heading = 'eyeLeft;eyeRight;wheelLeft;wheelRight\n'
/** Where Bo stands and how it should drive: up to the square, and stay. */
const remembered = file(
  `${heading}100;100;70;70\n60;80;40;55\n40;40;45;45\n20;30;15;30\n5;5;0;0\n30;90;25;65,5\n`,
)

interface Report {
  readonly practised: number
  readonly keptBack: number | null
  readonly starts: { readonly passed: number; readonly of: number }
  readonly hash: string
  readonly ended: string
  readonly curve: readonly object[]
  readonly weights: { readonly [from: string]: { readonly [to: string]: number } }
  readonly seeds: readonly { readonly seed: number; readonly starts: Report['starts'] }[]
}
const learn = (...args: string[]) => botgarten<Report>('learn', 'net', ...args)
const friendship = (...args: string[]) => learn('friendship', '--examples', remembered, ...args)

describe('botgarten learn net', () => {
  it('learns Friendship from six remembered places and passes from every start, in a line that fits its schema', async () => {
    const { status, stdout, json } = await friendship('--json')
    expect(status).toBe(0)
    expect(stdout.trim()).not.toContain('\n')
    const fits = schema('learn-net')
    fits(json())
    expect(fits.errors).toBeNull()
    expect(json().starts).toEqual({ passed: 3, of: 3 })
    expect(json().weights['eyeLeft']!['wheelLeft']).toBeGreaterThan(json().weights['eyeLeft']!['wheelRight']!)
    expect((await friendship('--json')).stdout).toBe(stdout)
    expect((await friendship('--seed', '2', '--json')).json().hash).not.toBe(json().hash)
  })

  it('says in a sentence how far off it is and how many starts pass', async () => {
    expect((await friendship()).stdout).toMatch(
      /^6 examples, 60 rounds: about \d\.\d percent off; passes from 3 of 3 starts\n$/,
    )
  })

  it('practises with several seeds, one line a seed', async () => {
    const { json } = await friendship('--seeds', '2', '--seed', '5', '--json')
    const fits = schema('learn-net')
    fits(json())
    expect(fits.errors).toBeNull()
    expect(json().seeds.map(({ seed, starts }) => [seed, starts.passed])).toEqual([
      [5, 3],
      [6, 3],
    ])
  })

  it('writes a project that holds weights, examples and how it practised, and practises on from there', async () => {
    const out = join(folder, 'out.json')
    const first = await friendship(
      '--hidden',
      '4:tanh',
      '--adam',
      '--bias',
      '--rounds',
      '30',
      '--out',
      out,
      '--json',
    )
    expect(first.stderr).toContain('shaken apart')
    const project = parseProject(readFileSync(out, 'utf8'))
    const [brain] = Object.values(project.brains)
    expect(brain!.layers.map((layer) => layer.length)).toEqual([2, 4, 2])
    expect(brain!.weights).toEqual(first.json().weights)
    expect(brain!.practice).toMatchObject({ seed: 1, round: 30, settings: { optimizer: 'adam', bias: 'on' } })
    const again = (await learn(out, '--json')).json()
    expect(again.curve[0]).toEqual({ round: 0, practised: first.json().practised, kept: null })
    const table = await botgarten('examples', out, '--json')
    expect(table.json()).toMatchObject({ rows: 6, on: 6, drives: 6 })
  })

  it('gives the weights of the links that its hidden layers have, and running takes them', async () => {
    const out = join(folder, 'hidden.json')
    const { json } = await friendship('--hidden', '4:tanh', '--rounds', '5', '--out', out, '--json')
    const { weights } = json()
    const hidden = [1, 2, 3, 4].map((k) => `net.hidden1#${k}`)
    expect(Object.keys(weights['eyeLeft']!).sort()).toEqual(hidden)
    expect(Object.keys(weights[hidden[0]!]!).sort()).toEqual(['wheelLeft', 'wheelRight'])
    const given = file(JSON.stringify(weights), 'json')
    const run = await botgarten('run', out, '--weights', given, '--json')
    expect([run.status, run.stderr]).toEqual([0, ''])
  })

  it('says when its steps were too big', async () => {
    const { json, stderr } = await friendship('--rate', '5', '--momentum', '0.9', '--json')
    expect(json().ended).toBe('ranAway')
    expect(stderr).toContain('The steps were too big')
  })

  it('holds whole drives back for a test', async () => {
    const rows = Array.from(
      { length: 30 },
      (_, k) => `${(k * 37) % 101};${(k * 61) % 101};${k};${60 - k};${k % 10}`,
    )
    const driven = file(`${heading.trim()};drive\n${rows.join('\n')}\n`)
    const { json } = await learn('friendship', '--examples', driven, '--keep-back', '.3', '--json')
    expect(json().keptBack).toBeGreaterThan(0)
  })

  it.each([
    ['no card', [], '"learn net" takes one card or one project file.', 2],
    ['no examples', ['friendship'], 'There are no examples to practise.', 1],
    [
      'a number that is none',
      ['friendship', '--rate', '0'],
      '--rate takes a number from 0.0001 to 5, not "0".',
      2,
    ],
    [
      'a billion rounds',
      ['friendship', '--rounds', '1000000000'],
      '--rounds takes a number from 1 to 100000',
      2,
    ],
    ['no such layer', ['friendship', '--hidden', '4:step'], '--hidden takes layers of 1 to 64 neurons', 2],
    ['on and off', ['friendship', '--bias', '--no-bias'], 'Either --bias or --no-bias, not both.', 2],
    ['no mirror', ['chameleon', '--mirror'], 'This network has no mirror image', 2],
    ['no such network', ['friendship', '--brain', 'none'], 'There is no network "none".', 2],
    [
      'many seeds in one file',
      ['friendship', '--seeds', '2', '--out', 'x.json'],
      '--out writes one result',
      2,
    ],
  ])('refuses %s in one sentence', async (_, args, sentence, status) => {
    const answer = await learn(...args)
    expect([answer.status, answer.stdout]).toEqual([status, ''])
    expect(answer.stderr).toContain(sentence)
    expect(answer.stderr.trim()).not.toContain('\n')
  })

  it('refuses a network whose outputs are thresholds', async () => {
    const { stdout } = await botgarten('learn', 'net', 'friendship', '--examples', remembered, '--json')
    expect(stdout).not.toBe('')
    const out = join(folder, 'threshold.json')
    await friendship('--hidden', '3:relu', '--out', out)
    const text = readFileSync(out, 'utf8').replaceAll('"RELU"', '"THRESHOLD"')
    const { status, stderr } = await learn(file(text, 'json'))
    expect([status, stderr]).toEqual([1, expect.stringContaining('a step has no slope')])
  })
})

describe('files of examples', () => {
  it.each([
    [
      'text in a cell',
      'eyeLeft,eyeRight,wheelLeft,wheelRight\n1,2,3,4\n1,far,3,4',
      'Row 3, column 2: "far" is not a number.',
    ],
    [
      'an empty cell',
      'eyeLeft,eyeRight,wheelLeft,wheelRight\n1,,3,4',
      'Row 2, column 2: "" is not a number.',
    ],
    ['NaN', 'eyeLeft,eyeRight,wheelLeft,wheelRight\n1,2,NaN,4', 'Row 2, column 3: "NaN" is not a number.'],
    [
      '1e999',
      'eyeLeft,eyeRight,wheelLeft,wheelRight\n1,2,3,1e999',
      'Row 2, column 4: "1e999" is not a number.',
    ],
    [
      'an unknown column',
      'eyeLeft,eyeRight,wheelLeft,speed\n1,2,3,4',
      'It has a column "speed". Columns can be: eyeLeft,',
    ],
    ['a missing column', 'eyeLeft,eyeRight,wheelLeft\n1,2,3', 'The column "wheelRight" is missing.'],
    ['no heading', '1,2,3,4\n5,6,7,8', 'Its first row does not name the columns. They are: eyeLeft,'],
    [
      '6,000 rows',
      `eyeLeft,eyeRight,wheelLeft,wheelRight\n${'1,2,3,4\n'.repeat(6000)}`,
      'It has more than 5000 rows.',
    ],
    ['10 MB', `eyeLeft\n${'1'.repeat(10_000_000)}`, 'it has more than 5 MB'],
  ])('with %s are refused in one sentence', async (_, text, sentence) => {
    const { status, stderr } = await learn('friendship', '--examples', file(text))
    expect([status, stderr]).toEqual([1, expect.stringContaining(sentence)])
    expect(stderr.trim()).not.toContain('\n')
  })

  it.each([
    ['of no JSON', '{', 'It is not JSON.'],
    ['that are something else', '{"botgarten":"brain"}', 'It is not a file of examples.'],
    ['that are a project', '{"botgarten":1}', 'It is a whole project'],
  ])('%s are refused in one sentence', async (_, text, sentence) => {
    const { status, stderr } = await learn('friendship', '--examples', file(text, 'json'))
    expect([status, stderr]).toEqual([1, expect.stringContaining(sentence)])
  })

  it('with numbers out of range are read as they are, said once', async () => {
    const { status, stderr } = await learn(
      'friendship',
      '--examples',
      file(`${heading}120;100;150;70\n60;80;40;55\n`),
    )
    expect([status, stderr]).toEqual([0, expect.stringContaining('2 numbers lay outside of their range')])
  })
})

describe('botgarten examples', () => {
  const table = file(`${heading}50;20;80;80\n52;21;-60;10\n51;19;79;82\n100;100;70;70\n5;90;60;60\n`)

  it('asks, the gravest first, and changes nothing', async () => {
    const { json } = await botgarten('examples', 'friendship', '--examples', table, '--check', '--json')
    const fits = schema('examples')
    fits(json())
    expect(fits.errors).toBeNull()
    expect(json()).toMatchObject({ rows: 5, on: 5 })
    expect((json()['findings'] as unknown[])[0]).toEqual({ kind: 'contradiction', row: 2, others: [1, 3] })
    const said = await botgarten('examples', 'friendship', '--examples', table, '--check')
    expect(said.stdout).toContain('Row 2 does not fit 1, 3: similar readings, very different wishes.')
  })

  it('writes a table that is read again, rows that are set aside with --all', async () => {
    const aside = file(`${heading.trim()};on\n50;20;80;80;0\n52;21;-60;10;1\n`)
    const csv = join(folder, 'written.csv')
    await botgarten('examples', 'friendship', '--examples', aside, '--csv', csv)
    expect(readFileSync(csv, 'utf8')).toBe(
      'eyeLeft,eyeRight,wheelLeft,wheelRight,drive,on\r\n52,21,-60,10,2,1\r\n',
    )
    await botgarten('examples', 'friendship', '--examples', aside, '--csv', csv, '--all')
    const again = await botgarten('examples', 'friendship', '--examples', csv, '--json')
    expect(again.json()).toEqual({ rows: 2, on: 1, drives: 2 })
  })

  it('needs to know whose', async () => {
    expect((await botgarten('examples')).stderr).toContain('"examples" takes one project file or one card.')
  })
})
