import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import reference from '../../packages/learning/k-means/reference/clusterings.json' with { type: 'json' }
import { Ajv2020 } from 'ajv/dist/2020.js'
import { describe, expect, it } from 'vitest'
import { botgarten } from './testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-'))
const schema = JSON.parse(
  readFileSync(join(import.meta.dirname, 'schemas/learn-kmeans.json'), 'utf8'),
) as object
const fits = new Ajv2020().compile(schema)

let files = 0
function file(text: string): string {
  const path = join(folder, `${++files}.csv`)
  writeFileSync(path, text)
  return path
}

const csv = (rows: readonly (readonly number[])[], mark = ',') => rows.map((row) => row.join(mark)).join('\n')

const kMeans = (...args: string[]) =>
  botgarten<{ labels: number[]; inertia: number[] }>('learn', 'kmeans', ...args)

const two = 'x;y\n1,5;1\n1,25;1,5\n9;9,5\n9,75;9\n'

describe('botgarten learn kmeans', () => {
  it('gives what scikit-learn gives from the same centres, as one line of JSON that fits its schema', async () => {
    for (const row of reference.scikit.slice(0, 3)) {
      const { status, stdout, json } = await kMeans(
        ...['--data', file(csv(row.points)), '--init', file(csv(row.start))],
        ...['--k', `${row.start.length}`, '--json'],
      )
      expect(status).toBe(0)
      expect(stdout.trim()).not.toContain('\n')
      fits(json())
      expect(fits.errors).toBeNull()
      expect(json()).toMatchObject({ labels: row.labels, iterations: row.iterations })
    }
  })

  it('reads a German spreadsheet: semicolons and decimal commas', async () => {
    const { labels } = (await kMeans('--data', file(two), '--k', '2', '--json')).json()
    expect(labels[0]).toBe(labels[1])
    expect(labels[2]).toBe(labels[3])
    expect(labels[0]).not.toBe(labels[2])
    expect((await kMeans('--data', file(two), '--k', '2')).stdout).toMatch(
      /^After \d rounds: inertia 0\.5625, 2 groups of 2, 2 points\n$/,
    )
  })

  it('reads one column with decimal commas; where nothing tells, it says so, and takes the word of the call', async () => {
    const centres = async (...args: string[]) =>
      ((await kMeans(...args, '--k', '1', '--json')).json() as unknown as { centres: number[][] }).centres
    expect(await centres('--data', file('Länge\n1,5\n2,5\n'))).toEqual([[2]])
    const either = file('1,5\n2,5\n')
    expect(await centres('--data', either)).toEqual([[1.5, 5]])
    expect(await centres('--data', either, '--decimal-comma')).toEqual([[2]])
    expect((await kMeans('--data', either, '--k', '1')).stdout).toContain('--decimal-comma reads one column')
    expect((await kMeans('--data', either, '--k', '1', '--decimal-comma')).stdout).not.toContain('comma')
  })

  it('says how it read the file, beside what it found', async () => {
    const understood = async (...args: string[]) => {
      const { stderr, json } = await kMeans(...args, '--k', '1', '--json')
      const answer = json()
      fits(answer)
      expect(fits.errors).toBeNull()
      return { stderr, read: (answer as unknown as { read: object }).read }
    }
    expect(await understood('--data', file('Länge\n1,5\n2,5\n'))).toEqual({
      stderr: 'botgarten: read one column, decimal comma, a heading, 2 rows.\n',
      read: { columns: 1, rows: 2, mark: null, decimal: 'comma', heading: true, encoding: 'utf-8' },
    })
    const excel = join(folder, 'excel.txt')
    writeFileSync(excel, '\uFEFF1,5\t2\r\n3\t4\r\n', 'utf16le')
    expect(await understood('--data', excel)).toEqual({
      stderr: 'botgarten: read 2 columns with a tab between them, decimal comma, 2 rows, utf-16le.\n',
      read: { columns: 2, rows: 2, mark: 'tab', decimal: 'comma', heading: false, encoding: 'utf-16le' },
    })
  })

  it('refuses numbers whose squares have no end, in the file and in its centres', async () => {
    const huge = await kMeans('--data', file('x;y\n1;2\n1e308;-1e308\n'), '--k', '1', '--json')
    expect([huge.status, huge.stdout]).toEqual([1, ''])
    expect(huge.stderr).toContain('Row 3, column 1: "1e308" is too big to be compared; 1e+140 is the most.')
    const far = await kMeans('--data', file('1;2\n'), '--k', '1', '--init', file('1e141;2'))
    expect(far.status).toBe(1)
    expect(far.stderr).toContain('"1e141" is too big')
  })

  it('knows three distances and two ways to start; more starts are never worse', async () => {
    const data = file(csv(reference.scikit[1]!.points))
    const inertia = async (...args: string[]) =>
      (await kMeans('--data', data, '--k', '3', '--json', ...args)).json().inertia.at(-1)!
    for (const distance of ['euclidean', 'manhattan', 'cosine'])
      for (const init of ['random', '++']) {
        const call = ['--distance', distance, '--init', init, '--starts']
        const one = await inertia(...call, '1')
        expect(await inertia(...call, '10')).toBeLessThanOrEqual(one)
      }
  })

  it('is the same for the same seed', async () => {
    const call = ['--data', file(csv(reference.scikit[1]!.points)), '--k', '4', '--starts', '1', '--json']
    const said = async () => (await kMeans(...call, '--seed', '7')).stdout
    expect(await said()).toBe(await said())
  })

  it('takes equal points and as many groups as points', async () => {
    const { json } = await kMeans('--data', file('1,1\n1,1\n1,1\n'), '--k', '3', '--json')
    expect(json().inertia.at(-1)).toBe(0)
  })

  it('takes a million rows, and refuses one more', async () => {
    const million = Array.from({ length: 1_000_000 }, (_, row) => row % 7)
    const { status, json } = await kMeans(
      ...['--data', file(million.join('\n')), '--k', '2', '--starts', '1', '--json'],
    )
    expect(status).toBe(0)
    expect(json().labels).toHaveLength(1_000_000)
    const more = await kMeans('--data', file([...million, 1].join('\n')), '--k', '2')
    expect(more.status).toBe(1)
    expect(more.stderr).toContain('It has more than 1000000 rows.')
  }, 60_000)

  it.each([
    [[], '--data is needed'],
    [['--data', 'x.csv'], '--k is needed'],
    [['--data', file(two), '--k', '0'], '--k takes a number from 1 to 4, not "0"'],
    [['--data', file(two), '--k', '5'], '--k takes a number from 1 to 4, not "5"'],
    [['--data', file(two), '--k', '2,5'], '--k takes a number'],
    [
      ['--data', file(two), '--k', '2', '--distance', 'far'],
      '--distance takes euclidean or manhattan or cosine',
    ],
    [['--data', file(two), '--k', '2', '--starts', '0'], '--starts takes a number from 1'],
    [['--data', file(two), '--k', '2', '--init', file('1;2\n3;4'), '--starts', '3'], 'is one start'],
  ])('refuses the call %j', async (args, words) => {
    const { status, stderr } = await kMeans(...args)
    expect(status).toBe(2)
    expect(stderr).toContain(words)
  })

  it.each([
    ['x,y\n1,2\nNaN,3', 'Row 3, column 1: "NaN" is not a number.'],
    ['name,y\napple,3', 'Row 2, column 1: "apple" is not a number.'],
    ['', 'There are no numbers in it.'],
    ['1;2\n3', 'Row 2 has 1 cell, the others have 2.'],
  ])('says what is wrong with the file %j', async (text, words) => {
    const { status, stderr } = await kMeans('--data', file(text), '--k', '1')
    expect(status).toBe(1)
    expect(stderr).toContain(words)
    expect(stderr.trim()).not.toContain('\n')
  })

  it('says when there is no such file, or its centres do not fit', async () => {
    expect((await kMeans('--data', join(folder, 'none.csv'), '--k', '1')).status).toBe(1)
    const { status, stderr } = await kMeans('--data', file(two), '--k', '2', '--init', file('1;2;3\n3;4;5'))
    expect(status).toBe(1)
    expect(stderr).toContain('has 2 centres of 3 numbers; 2 of 2 are needed')
  })
})
