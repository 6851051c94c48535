import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { content } from '@botgarten/content/files'
import { courseOf, readMap } from '@botgarten/maps'
import { describe, expect, it } from 'vitest'
import worlds from '../../packages/learning/q-learning/reference/worlds.json' with { type: 'json' }
import { botgarten } from './testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-'))

const learn = (...args: string[]) => botgarten('learn', ...args)

function expectToFit(value: unknown, name: string) {
  const schema = JSON.parse(readFileSync(join(import.meta.dirname, 'schemas', name), 'utf8')) as object
  const fits = new Ajv2020().compile(schema)
  fits(value)
  expect(fits.errors).toBeNull()
}

const railway = ['--map', 'railway', '--start', '3', '--goal', '1', '--closed', '3-2,2-3']

describe('botgarten learn q', () => {
  it('finds the shortest way of each card task, as one line of JSON that fits its schema', async () => {
    const tasks: [string[], number[]][] = [
      [railway, [3, 5, 0, 1]],
      [
        ['--map', 'forest', '--start', '0', '--goal', '7', '--closed', '4-6'],
        [0, 2, 3, 5, 7],
      ],
      [
        ['--map', 'mars', '--start', '0', '--goal', '8'],
        [0, 3, 4, 5, 8],
      ],
    ]
    for (const [task, way] of tasks) {
      const { status, stdout, json } = await learn('q', ...task, '--episodes', '500', '--json')
      expect(status).toBe(0)
      expect(stdout.trim()).not.toContain('\n')
      expectToFit(json(), 'learn-q.json')
      expect(json()).toMatchObject({ bestWay: way, reason: 'found' })
    }
  })

  it('says why there is no way, and ends by time or episodes, whichever is done first', async () => {
    const short = (await learn('q', ...railway, '--nu', '0', '--time', '2', '--json')).json()
    expect(short).toMatchObject({ bestWay: null, reason: 'neverReached', moves: 2, firstShortestMove: null })
    const study = await learn(
      'q',
      ...railway,
      '--rules',
      'study',
      '--episodes',
      '30',
      '--time',
      '50',
      '--json',
    )
    expect(study.json()).toMatchObject({ moves: 30, episodes: 30 })
    expect((await learn('q', ...railway, '--nu', '0', '--time', '2')).stdout).toMatch(
      /^After 2 moves .* no way yet \(neverReached\)/,
    )
  })

  it('says where all is still alike after one try, beside the way that the first of equal roads would give', async () => {
    const open = ['--map', 'railway', '--start', '3', '--goal', '1']
    const once = await learn('q', ...open, '--episodes', '1', '--json')
    expectToFit(once.json(), 'learn-q.json')
    expect(once.json()).toMatchObject({
      ...{ bestWay: [3, 2, 1], reason: 'found' },
      ...{ learned: false, notLearned: { reason: 'alike', station: 3 } },
    })
    expect((await learn('q', ...open, '--episodes', '1')).stdout).toMatch(
      /no way learned yet \(alike\): at 3 all roads are still alike; the first of equal roads would give 3 → 2 → 1$/m,
    )
    const often = (await learn('q', ...open, '--episodes', '100', '--json')).json()
    expect(often).toMatchObject({ bestWay: [3, 2, 1], learned: true, notLearned: null })
  })

  it('is said in the language of the call, one move as one', async () => {
    const args = ['learn', 'q', ...railway, '--nu', '0', '--time', '1', '--lang']
    expect((await botgarten(...args, 'en')).stdout).toMatch(/^After 1 move in 0 episodes: no way yet /)
    expect((await botgarten(...args, 'de')).stdout).toMatch(/^Nach 1 Zug in 0 Versuchen: noch kein Weg /)
  })

  it('judges a policy by what it expects where moves are by chance: the slippery lake', async () => {
    const settings = ['--alpha', '1', '--alpha-decay', 'visits', '--rho', '1', '--nu', '.5', '--gamma', '.95']
    const call = ['--map', 'lake', ...settings, '--time', '300000']
    const report = (await learn('q', ...call, '--json')).json()
    expectToFit(report, 'learn-q.json')
    expect(report).toMatchObject({ learned: true, plan: { policy: { 9: 'down', 13: 'right', 14: 'down' } } })
    const plan = report['plan'] as { expectedReturn: number; bestReturn: number }
    // Of Gymnasium's FrozenLake-v1, by value iteration with γ = 0.95.
    const best = Math.max(...worlds.lake4.q[0]!)
    expect(Math.abs(plan.bestReturn - best)).toBeLessThan(1e-9)
    expect(plan.expectedReturn).toBeGreaterThan(0.95 * best)
    expect((await learn('q', ...call)).stdout).toMatch(
      /moves are by chance.*the policy expects 0\.1\d+ \(at best 0\.1805\)/,
    )
  })

  it('names what it learned with, the decay by its formula', async () => {
    const report = (
      await learn('q', ...railway, '--alpha-decay', 'visits', '--rho-decay', '.9', '--json')
    ).json()
    expectToFit(report, 'learn-q.json')
    expect(report['settings']).toEqual({
      ...{ rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 },
      alphaDecay: { kind: 'visits', formula: 'alpha * 10 / (9 + n), n-th update of a value' },
      rhoDecay: { kind: 'episodes', factor: 0.9, formula: 'rho * 0.9 ^ n, n episodes done before' },
    })
  })

  it('learns what the lab learns from the same seed: ten tries on the Railway, move by move', async () => {
    const { map } = readMap(content.map('railway')!)
    const closed: [number, number][] = [[3, 2], [2, 3]] // prettier-ignore
    const preset = { rules: 'standard', algorithm: 'q', alpha: 0.5, gamma: 0.8, nu: 0.1, rho: 0.5 } as const
    const outline = { blocks: { map: 'map' }, map: 'railway', start: 3, goal: 1, closed, settings: preset }
    for (const seed of [1, 2, 7]) {
      const course = courseOf({ ...outline, episodes: 10, moves: 10_000 }, map!, seed)
      course.advance(10_000)
      const { moves, q, learned } = (
        await learn(...['q', ...railway, '--episodes', '10', '--seed', String(seed), '--json'])
      ).json() as { moves: number; q: { [road: string]: number }; learned: boolean }
      expect(moves).toBe(course.made)
      expect(Object.values(q)).toEqual([...course.learner.q])
      expect(learned).toBe(course.way().states !== null)
    }
  })

  it('is the same for the same seed and another for another one', async () => {
    const said = async (seed: string) =>
      (await learn('q', ...railway, '--time', '40', '--seed', seed, '--json')).stdout
    const one = await said('7')
    expect(await said('7')).toBe(one)
    expect(await said('8')).not.toBe(one)
  })

  it('reads a map from a file, and names what is wrong with it', async () => {
    const text = content.map('railway')!
    const whole = join(folder, 'whole.svg')
    writeFileSync(whole, text)
    expect((await learn('q', '--map', whole, ...railway.slice(2))).status).toBe(0)
    const broken = join(folder, 'broken.svg')
    writeFileSync(broken, text.replace('id="path-3-5"', 'id="path-3-9"'))
    const { status, stderr } = await learn('q', '--map', broken, ...railway.slice(2))
    expect(status).toBe(1)
    expect(stderr).toBe(
      `botgarten: "${broken}" is not a map: path-3-9 leads to a station 9 that is not there.\n`,
    )
  })

  it('reads what a drawing program saves, and names what it leaves out', async () => {
    const drawing = join(folder, 'drawing.svg')
    const circles =
      '<circle id="node-0" cx="9" cy="9" r="5"/><ellipse id="node-1" cx="99" cy="9" rx="9" ry="5"/>'
    const roads = '<path id="path-0-1" d="m9 9q30-40 90 0"/><path id="path-a-b" d="M0 0"/>'
    writeFileSync(
      drawing,
      `<svg viewBox="0 0 120 20"><g transform="rotate(9) scale(2)">${circles}${roads}</g></svg>`,
    )
    const { status, stdout, stderr } = await learn(
      'q',
      '--map',
      drawing,
      '--start',
      '0',
      '--goal',
      '1',
      '--json',
    )
    expect(status).toBe(0)
    expect(JSON.parse(stdout)).toMatchObject({ bestWay: [0, 1] })
    expect(stderr).toBe(
      `botgarten: in "${drawing}" "path-a-b" is neither a station (node-0) nor a road (path-3-5) and is not read.\n`,
    )
  })

  it.each([
    [['p'], 'One of q, net, try, q-sweep, q-race, q-thesis, kmeans'],
    [['q'], '--map is needed'],
    [['q', '--map', 'moon'], 'There is no map and no file called "moon"'],
    [['q', '--map', 'railway'], '--start is needed: a station from 0 to 5'],
    [['q', ...railway.slice(0, 4), '--goal', '9'], '--goal takes a number from 0 to 5'],
    [['q', ...railway.slice(0, 6), '--closed', '3-1'], 'there is no road "3-1"'],
    [['q', ...railway, '--alpha', 'NaN'], '--alpha takes a number from 0 to 1, not "NaN"'],
    [['q', ...railway, '--rules', 'own'], '--rules takes standard or study'],
    [['q', ...railway, '--rho-decay', 'visits'], '--rho-decay takes a number from 0 to 1'],
    [['q-sweep', ...railway, '--shard', '3/2'], '--shard takes a part'],
    [['q-sweep', ...railway, '--rho', '.5,2'], '--rho takes numbers from 0 to 1'],
  ])('refuses %j', async (args, words) => {
    const { status, stderr } = await learn(...args)
    expect(status).toBe(2)
    expect(stderr).toContain(words)
  })
})

describe('botgarten learn q-sweep', () => {
  const grid = [...railway, ...['--rules', 'study', '--time', '60', '--runs', '8']]
  const lists = ['--alpha', '.1,.5,.9', '--gamma', '.2,.8', '--rho', '.5,.9']

  it('gives the same table whatever the number of threads, a row a setting', async () => {
    const said = async (threads: string) =>
      (await learn('q-sweep', ...grid, ...lists, '--threads', threads)).stdout
    const one = await said('1')
    expect(await said('3')).toBe(one)
    expect(one.trim().split('\n')).toHaveLength(1 + 3 * 2 * 2)
  })

  it('gives parts that joined are the whole', async () => {
    const whole = join(folder, 'whole.csv')
    expect((await learn('q-sweep', ...grid, ...lists, '--csv', whole)).status).toBe(0)
    let parts = ''
    for (const part of [1, 2, 3, 4, 5]) {
      const path = join(folder, `part${part}.csv`)
      await learn('q-sweep', ...grid, ...lists, '--shard', `${part}/5`, '--csv', path)
      parts += readFileSync(path, 'utf8')
    }
    expect(parts).toBe(readFileSync(whole, 'utf8'))
  })

  it('counts learned ways beside shown ones, and judges policies where moves are by chance', async () => {
    const once = await learn(
      'q-sweep',
      ...railway.slice(0, 6),
      '--episodes',
      '1',
      '--nu',
      '0',
      '--runs',
      '20',
      '--json',
    )
    const [row] = once.json() as unknown as { anyAtEnd: number; learnedAtEnd: number }[]
    expect(row!.anyAtEnd).toBeGreaterThan(0)
    expect(row!.learnedAtEnd).toBe(0)
    const lake = [
      'q-sweep',
      '--map',
      'lake',
      '--gamma',
      '.95',
      '--rho',
      '1',
      '--time',
      '50000',
      '--runs',
      '3',
    ]
    const [judged] = (await learn(...lake, '--json')).json() as unknown as {
      meanReturn: number
      bestReturn: number
    }[]
    expectToFit([judged], 'learn-q-sweep.json')
    expect(Math.abs(judged!.bestReturn - Math.max(...worlds.lake4.q[0]!))).toBeLessThan(1e-9)
    expect(judged!.meanReturn).toBeGreaterThan(0)
    expect(judged!.meanReturn).toBeLessThanOrEqual(judged!.bestReturn)
    const [head, cells] = (await learn(...lake)).stdout.trim().split('\n')
    expect(head).toMatch(/,meanFirst,learnedAtEnd,meanReturn,bestReturn$/)
    expect(cells!.split(',')).toHaveLength(head!.split(',').length)
  })

  it('keeps every row when another setting is added', async () => {
    const rows = async (alpha: string) =>
      (await learn('q-sweep', ...grid, '--alpha', alpha, '--json')).json() as unknown as object[]
    const both = await rows('.1,.5')
    expectToFit(both, 'learn-q-sweep.json')
    expect(both[1]).toEqual((await rows('.5'))[0])
  })
})

describe('botgarten learn q-thesis', () => {
  it('is the grid of the thesis: 225 settings on each of three maps', async () => {
    const { stdout } = await learn('q-thesis', '--runs', '1')
    const rows = stdout.trim().split('\n')
    expect(rows[0]).toMatch(/^map,alpha,gamma,nu,rho,/)
    for (const map of ['railway', 'forest', 'city'])
      expect(rows.filter((row) => row.startsWith(`${map},`))).toHaveLength(225)
  })

  it('gives JSON that fits its schema', async () => {
    expectToFit((await learn('q-thesis', '--runs', '2', '--json')).json(), 'learn-q-sweep.json')
  })

  it('gives parts that joined are the whole', async () => {
    const said = async (...args: string[]) => (await learn('q-thesis', '--runs', '1', ...args)).stdout
    const parts = [await said('--shard', '1/2'), await said('--shard', '2/2')]
    expect(parts.join('')).toBe(await said('--threads', '1'))
  })
})

describe('botgarten learn q-race', () => {
  it('races on a map by its name, and says it as one line of JSON that fits its schema, the same again', async () => {
    const asked = ['cliff', '--lanes', 'q:rho=.1,sarsa:rho=.1,best', '--tries', '30', '--runs', '7', '--json']
    const { status, stdout, json } = await learn('q-race', ...asked)
    expect(status).toBe(0)
    expectToFit(json(), 'learn-q-race.json')
    expect(json()).toMatchObject({
      map: 'cliff',
      criterion: 'way',
      lanes: [{ racer: 'q' }, { racer: 'sarsa' }, {}],
    })
    expect((await learn('q-race', ...asked, '--threads', '1')).stdout).toBe(stdout)
  })

  it('counts what it is asked to, and marks who wins', async () => {
    const { stdout } = await learn('q-race', 'cliff', '--criterion', 'falls', '--tries', '50', '--runs', '5')
    const [head, winner, ...others] = stdout.trim().split('\n')
    expect(head).toContain('fewest falls')
    expect(winner).toMatch(/^\* 3\. best: falls \d+, moves /)
    expect(others).toHaveLength(3)
    for (const line of others) expect(line).toMatch(/^ {2}\d\. /)
  })

  it.each([
    [[], 'takes one map'],
    [['cliff', 'city'], 'city'],
    [['cliff', '--lanes', 'q'], '2 to 8 learners'],
    [['cliff', '--lanes', 'q,snail'], 'no learner "snail"'],
    [['cliff', '--lanes', 'q:rho=7,best'], '"rho=7" in "q:rho=7" is no setting'],
    [['railway', '--start', '3', '--goal', '1', '--criterion', 'falls'], 'cannot count on this map'],
    [['cliff', '--tries', '20000'], '10000'],
  ])('refuses %j', async (args, words) => {
    const { status, stderr } = await learn('q-race', ...args)
    expect(status).toBe(2)
    expect(stderr).toContain(words)
  })
})
