import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { Ajv2020 } from 'ajv/dist/2020.js'
import { cardDocument } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { penFor, recorded, type Line } from '@botgarten/experiments/study'
import { createLab } from '@botgarten/lab'
import { version } from '@botgarten/programs'
import { beforeAll, describe, expect, it } from 'vitest'
import { botgarten } from './testing.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-'))
const schema = JSON.parse(readFileSync(join(import.meta.dirname, 'schemas/replay.json'), 'utf8')) as object

beforeAll(async () => {
  await import('./lab.ts')
})

/** One sitting on Friendship: two drives. */
function sitting(wrote = version): Line[] {
  const { card, world } = content.card('friendship')!
  const document = cardDocument(world, card, content.program('friendship', 'solution')!, 0)
  const lab = createLab()
  lab.load(document, content.floorOf(document.world), { seed: 1, checks: card.checks })
  const lines: Line[] = []
  let t = 0
  const pen = penFor(
    { session: 's0a1b2c3d', pseudonym: '0207T' },
    () => (t += 500),
    (line) => lines.push(line),
  )
  pen.write({ event: 'session', format: 1, version: wrote, study: 'test', group: 2, seed: 1, order: ['net'] })
  const written = recorded(lab, pen, { place: 'friendship', seed: 1 })
  for (const ticks of [100, 1500]) {
    written.lab.start()
    for (let left = ticks; left > 0; left -= 60) {
      written.lab.advance(60)
      written.lab.view()
    }
    written.lab.stop()
  }
  written.end()
  return lines
}

function file(name: string, lines: readonly (Line | string)[]): string {
  const path = join(folder, name)
  writeFileSync(
    path,
    lines.map((line) => (typeof line === 'string' ? line : JSON.stringify(line))).join('\n'),
  )
  return path
}

/** The last drive has driven elsewhere. */
const otherHash = (lines: readonly Line[]) => {
  const last = lines.findLastIndex(({ event }) => event === 'end')
  return lines.map((line, at) => (at === last ? ({ ...line, hash: '0'.repeat(16) } as Line) : line))
}

describe('botgarten replay', () => {
  it('drives a log to the same hashes, and says what its children did', async () => {
    const { status, stderr, json } = await botgarten('replay', file('log.jsonl', sitting()), '--json')
    expect([status, stderr]).toEqual([0, ''])
    const fits = new Ajv2020().compile(schema)
    fits(json())
    expect(fits.errors).toBeNull()
    expect(json()).toMatchObject({
      runs: [{ same: true }, { same: true }],
      pupils: [{ pseudonym: '0207T', group: 2, tries: 2, sessions: 1 }],
    })
  })

  it('prints a table to read, and the same as CSV', async () => {
    const path = file('table.jsonl', sitting())
    const plain = await botgarten('replay', path)
    expect(plain.stdout).toMatch(/^Runs replayed: 2, with the same hash: 2\.\n\n.*tries.*\n +0207T/)
    const { stdout } = await botgarten('replay', path, '--csv')
    const [names, row, ...more] = stdout.replace('\uFEFF', '').trim().split('\r\n')
    expect(names).toBe(
      'pseudonym,group,sessions,seconds,places,firstRun,tries,knobs,edits,steps,hints,checks',
    )
    expect(row).toMatch(/^0207T,2,1,[\d.]+,1,[\d.]+,2,0,0,0,0,\d+$/)
    expect(more).toEqual([])
  })

  it('of another version warns, and names the first run that differs', async () => {
    const { status, stderr } = await botgarten('replay', file('old.jsonl', otherHash(sitting('0.0.1'))))
    expect(status).toBe(0)
    expect(stderr).toContain('The log was written by Botgarten 0.0.1')
    expect(stderr).toMatch(
      /The first run that differs is in line \d+ \(0207T\): [0-9a-f]{16} and not 0{16}\./,
    )
  })

  it('of the same version with another hash is a changed file', async () => {
    const { status, stdout, stderr } = await botgarten('replay', file('bent.jsonl', otherHash(sitting())))
    expect([status, stdout]).toEqual([1, ''])
    expect(stderr).toMatch(/line \d+: the run of 0207T comes to [0-9a-f]{16} and not to 0{16}/)
  })

  it('refuses what is no log line by line, each with its sentence', async () => {
    const lines = sitting()
    const path = file('broken.jsonl', [
      lines[0]!,
      '{"t":1',
      JSON.stringify({ ...lines[1]!, spy: 1 }),
      lines[2]!,
    ])
    const { status, stderr } = await botgarten('replay', path)
    expect(status).toBe(1)
    expect(stderr).toContain('line 2: this is no JSON object.')
    expect(stderr).toContain(
      'line 3: the field "spy" of the event "open" is missing, wrong or not in the code book.',
    )
    expect(stderr).toContain('Lines refused: 2.')
  })

  it('says what is wrong with the call or the file', async () => {
    expect(await botgarten('replay')).toMatchObject({ status: 2 })
    expect(await botgarten('replay', 'a.jsonl', '--csv', '--json')).toMatchObject({ status: 2 })
    expect(await botgarten('replay', join(folder, 'none.jsonl'))).toMatchObject({ status: 1 })
    expect((await botgarten('replay', file('empty.jsonl', []))).stderr).toContain('is empty')
  })
})
