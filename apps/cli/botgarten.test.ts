import { spawnSync } from 'node:child_process'
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { content } from '@botgarten/content/files'
import { describe, expect, it } from 'vitest'
import { botgarten } from './testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-'))

function file(name: string, text: string): string {
  const path = join(folder, name)
  writeFileSync(path, text)
  return path
}

const schema = (name: string) =>
  JSON.parse(readFileSync(join(import.meta.dirname, 'schemas', name), 'utf8')) as object

function expectToFit(value: unknown, name: string) {
  const fits = new Ajv2020().compile(schema(name))
  fits(value)
  expect(fits.errors).toBeNull()
}

const openRoberta = join(import.meta.dirname, '../../packages/programs/testing/open-roberta/programs')

describe('botgarten convert', () => {
  const given = join(openRoberta, 'upstream__xNN__action.xml')
  const [json, xml] = [join(folder, 'action.json'), join(folder, 'again.xml')]

  it('makes a project of an Open Roberta file, and of that the same file again', async () => {
    const { status, json: report } = await botgarten('convert', given, json, '--json')
    expect(status).toBe(0)
    expectToFit(report(), 'convert.json')
    expect(report()).toMatchObject({ out: json, robot: 'bo', blocks: 195 })
    expect(JSON.parse(readFileSync(json, 'utf8'))).toMatchObject({
      botgarten: 1,
      name: 'upstream__xNN__action',
    })
    expect((await botgarten('convert', json, xml)).stdout).toMatch(/: 195 blocks/)
    const once = await botgarten('convert', xml, join(folder, 'once.xml'))
    expect(once.status).toBe(0)
    expect(readFileSync(join(folder, 'once.xml'), 'utf8')).toBe(readFileSync(xml, 'utf8'))
  })

  it.each([
    ['another robot', file('mbot.xml', readFileSync(given, 'utf8').replaceAll('"xNN"', '"mbot"')), 'mbot'],
    ['half a file', file('half.xml', readFileSync(given, 'utf8').slice(0, 9000)), 'line'],
    ['no file', join(folder, 'nothing.xml'), 'ENOENT'],
  ])('%s: exit 1 and one clear line, nothing is written', async (_, path, said) => {
    const out = join(folder, 'never.json')
    const { status, stdout, stderr } = await botgarten('convert', path, out)
    expect({ status, stdout }).toEqual({ status: 1, stdout: '' })
    expect(stderr).toMatch(/^botgarten: .+\n$/)
    expect(stderr).toContain(said)
    expect(existsSync(out)).toBe(false)
  })

  it.each([
    ['one file', [given]],
    ['another ending', [given, join(folder, 'x.txt')]],
    ['a robot that is not there', [given, join(folder, 'x.json'), '--robot', 'r2']],
  ])('%s: exit 2', async (_, args) => {
    expect((await botgarten('convert', ...args)).status).toBe(2)
  })
})

describe('botgarten cards', () => {
  it('lists the cards as one line of JSON that fits its schema', async () => {
    const { status, stdout, json } = await botgarten('cards', '--json')
    expect(status).toBe(0)
    expect(stdout.trim()).not.toContain('\n')
    expectToFit(json(), 'cards.json')
    const ids = (json() as unknown as { id: string }[]).map(({ id }) => id)
    expect(ids.slice(0, 3)).toEqual(['forward', 'square', 'stop'])
    expect(ids.toSorted()).toEqual(content.cards.map(({ id }) => id).toSorted())
  })

  it('lists them for people, a line each', async () => {
    expect((await botgarten('cards')).stdout).toMatch(
      /\nfriendship .*Friendship \/ Freundschaft\nfear .*\ninterest .*\nrally .*\ncrossed-wires .*\nlost-links .*\nall-the-same .*\nif-then .*\neither-or .*\nshow-it .*\n(?:.+\n)+mars .*\nrailway .*Railway \/ Eisenbahn\n/,
    )
  })
})

describe('botgarten run', () => {
  it('runs a card as it starts: nothing has been taught, nothing is green', async () => {
    const { status, json } = await botgarten('run', 'friendship', '--json')
    expect(status).toBe(0)
    expectToFit(json(), 'run.json')
    expect(json()).toMatchObject({
      seconds: 60,
      pose: { x: 440, y: 170, heading: expect.closeTo(150, 9) as number },
    })
    expect(json()['checks']).toContainEqual({ id: 'near', passed: false, at: null })
  })

  it('runs the solution from another start pose; the same call gives the same line', async () => {
    const call = ['run', 'friendship', '--solution', '--start', '1', '--seconds', '30', '--json']
    const once = await botgarten(...call)
    expectToFit(once.json(), 'run.json')
    expect((once.json()['trail'] as unknown[]).length).toBe(300)
    expect((await botgarten(...call)).stdout).toBe(once.stdout)
  })

  it('takes weights from a file: those of its schema drive as the solution does', async () => {
    const { examples } = schema('weights.json') as { examples: object[] }
    expectToFit(examples[0], 'weights.json')
    const weights = file('weights.json', JSON.stringify(examples[0]))
    const given = (await botgarten('run', 'friendship', '--weights', weights, '--json')).json()
    expect(given['hash']).toBe((await botgarten('run', 'friendship', '--solution', '--json')).json()['hash'])
  })

  it('runs a file of Open Roberta as it is, and says what it asserts of itself', async () => {
    const { json } = await botgarten('run', join(openRoberta, 'composed__common__mathBasics.xml'), '--json')
    expectToFit(json(), 'run.json')
    expect(json()['assertions']).toEqual({ passed: 5, failed: [] })
    const wrong = join(openRoberta, 'composed__common__controlFlowDecisons.xml')
    expect((await botgarten('run', wrong, '--json')).json()['assertions']).toEqual({
      passed: 15,
      failed: [{ id: 'hYTvh!=P6mP399o-51Yp', text: 'pos-14', expected: '14', got: '13' }],
    })
    expect((await botgarten('run', wrong)).stdout).toMatch(/asserted wrongly {2}pos-14: expected 14, got 13/)
  })

  it('says in a sentence that the picture of the floor is damaged', async () => {
    const asset = 'a'.repeat(64)
    const base64 = Buffer.from('89504e470d0a1a0a00', 'hex').toString('base64')
    const bo = { id: 'bo', pose: { x: 50, y: 50, heading: 0 }, program: 'main', brain: 'b' }
    const config = { wheelDiameter: 5.6, trackWidth: 11, sensors: {}, drive: { left: 'B', right: 'C' } }
    const path = file(
      'damaged-floor.json',
      JSON.stringify({
        ...{ botgarten: 1, name: 'Damaged', brains: {} },
        assets: { [asset]: { type: 'image/png', base64 } },
        programs: { main: { stacks: [], config: { stacks: [] } } },
        world: {
          ...{ size: { width: 200, height: 150 }, floor: { asset } },
          ...{ areas: [], lines: [], obstacles: [], robots: [{ ...bo, config }] },
        },
      }),
    )
    const { status, stderr } = await botgarten('run', path)
    expect(stderr).toBe(
      'botgarten: The picture of the floor is damaged and cannot be read. Choose another floor in the lab.\n',
    )
    expect(status).toBe(1)
  })

  it('says in words what it says in JSON', async () => {
    expect((await botgarten('run', 'friendship', '--solution')).stdout).toMatch(/passed {2}near at \d/)
  })

  const fileAtFault: [string, string[]][] = [
    ['a file that is not JSON', ['run', file('broken.json', '{"botgarten": 1,')]],
    ['a file that is no project', ['run', file('list.json', '[1, 2, 3]')]],
    ['a project of a later version', ['run', file('later.json', '{"botgarten": 99}')]],
    ['a file of Open Roberta that is none', ['run', file('page.xml', '<html/>')]],
    ['weights that are not there', ['run', 'friendship', '--weights', join(folder, 'nothing.json')]],
  ]
  it.each(fileAtFault)('%s: exit 1 and one clear line', async (_, args) => {
    const { status, stdout, stderr } = await botgarten(...args)
    expect({ status, stdout }).toEqual({ status: 1, stdout: '' })
    expect(stderr).toMatch(/^botgarten: .+\n$/)
  })

  const callAtFault: [string, string[]][] = [
    ['no verb', []],
    ['an unknown verb', ['dance']],
    ['a verb that is only inherited', ['constructor']],
    ['no card', ['run']],
    ['an unknown card', ['run', 'friendshap']],
    ['an unknown option', ['run', 'friendship', '--fast']],
    ['a start pose that is not there', ['run', 'friendship', '--start', '3']],
    ['a wrong answer that is not there', ['run', 'friendship', '--wrong', '0']],
    ['a solution and a wrong answer', ['run', 'friendship', '--solution', '--wrong', '1']],
    ['seconds that are no number', ['run', 'friendship', '--seconds', 'long']],
    ['seconds below zero', ['run', 'friendship', '--seconds=-1']],
    ['half a seed', ['run', 'friendship', '--seed', '1.5']],
  ]
  it.each(callAtFault)('%s: exit 2 and one clear line', async (_, args) => {
    const { status, stdout, stderr } = await botgarten(...args)
    expect({ status, stdout }).toEqual({ status: 2, stdout: '' })
    expect(stderr).toMatch(/^botgarten: .+\n$/)
  })
})

describe('the language of what is said', () => {
  it('is the one that the call asks for, wherever it stands', async () => {
    for (const args of [
      ['--lang', 'de', 'run', 'nowhere'],
      ['run', '--lang=de', 'nowhere'],
    ])
      expect((await botgarten(...args)).stderr).toBe(
        'botgarten: Es gibt weder eine Karte noch eine Datei „nowhere“. Hilfe: botgarten run --help\n',
      )
    expect((await botgarten('run', 'nowhere', '--lang', 'en')).stderr).toContain(
      'There is no card and no file',
    )
  })

  it('is that of a file of Open Roberta that cannot be opened, too', async () => {
    const path = file('mbot2.xml', '<export xmlns="http://de.fhg.iais.roberta.blockly"><a/></export>')
    expect((await botgarten('run', path, '--lang', 'de')).stderr).toMatch(
      /ist kein Programm von Open Roberta, das sich/,
    )
  })

  it('is refused by name where there is none: exit 2', async () => {
    const { status, stderr } = await botgarten('cards', '--lang', 'xx')
    expect(status).toBe(2)
    expect(stderr).toMatch(/^botgarten: --lang takes de.* or .*, not "xx"\. Help: botgarten cards --help\n$/)
  })

  it('is one alone, but for what is printed', async () => {
    const { status, stderr } = await botgarten('cards', '--lang', 'de,en')
    expect(status).toBe(2)
    expect(stderr).toContain('--lang nimmt de oder en, nicht „de,en“')
  })
})

describe('--help', () => {
  it('is a usage and every option of the command, whatever else the call lacks', async () => {
    const { status, stdout } = await botgarten('learn', 'q', '--help')
    expect(status).toBe(0)
    expect(stdout).toMatch(/^botgarten learn q --map M \[options\]\n/)
    expect(stdout).toContain('--alpha-decay F|visits')
    expect((await botgarten('learn', '--help')).stdout).toContain('botgarten learn kmeans')
    expect((await botgarten('--help', '--lang', 'de')).stdout).toMatch(
      /botgarten print {5}Druckt Materialien als PDF:/,
    )
  })
})

describe('the program', () => {
  /** A process of its own, on a machine that speaks this. */
  const started = (machine: string, ...args: string[]) => {
    const { status, stdout, stderr } = spawnSync(
      process.execPath,
      [join(import.meta.dirname, 'botgarten.ts'), ...args],
      { encoding: 'utf8', env: { ...process.env, LC_ALL: machine } },
    )
    return { status, stdout, stderr }
  }

  it('prints the answer on standard output, and ends with 0', async () => {
    const { stdout } = await botgarten('cards', '--json')
    expect(started('en_GB.UTF-8', 'cards', '--json')).toEqual({ status: 0, stdout, stderr: '' })
  })

  it('says in the language of the machine on standard error what is wrong with the call, and ends with 2', () => {
    expect(started('de_DE.UTF-8', 'run', 'nowhere')).toEqual({
      status: 2,
      stdout: '',
      stderr: 'botgarten: Es gibt weder eine Karte noch eine Datei „nowhere“. Hilfe: botgarten run --help\n',
    })
  })
})
