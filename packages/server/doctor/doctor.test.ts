import { chmodSync, existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { openClassServer } from '../class-server.ts'
import { examineBackup } from './backup.ts'
import { examineClock, examineDisk, examineFolder } from './machine.ts'
import { examineAddress, examineFirewall } from './network.ts'
import { examineDoubt, examinePort } from './port.ts'
import { examineHotSpot, examineMemory, examineRunning } from './running.ts'

let folder: string
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten doctor ü-'))))
afterEach(() => rmSync(folder, { recursive: true, force: true }))

/** A program that answers at a port of its own. */
async function listening(answer: string, host?: string) {
  const server = createServer((_, response) => void response.end(answer))
  await new Promise<void>((done) => server.listen({ port: 0, host }, done))
  return { port: (server.address() as AddressInfo).port, close: () => server.close() }
}

test('a free port is fine, one of another program is not, one of a Botgarten is', async () => {
  const other = await listening('hello')
  expect((await examinePort(other.port)).verdict).toBe('port.taken')
  other.close()
  expect((await examinePort(other.port)).verdict).toBe('port.free')
  const ours = await listening('{"firstTeacher":null}', '127.0.0.1')
  expect((await examinePort(ours.port)).verdict).toBe('port.ours')
  ours.close()
  expect((await examinePort(4173, '192.0.2.1')).verdict).toBe('port.otherHost')
})

const own = 'http://localhost:4173'
const [first, second] = ['http://192.168.0.5:4173', 'http://10.42.0.1:4173']

test.each([
  ['none', [own], []],
  ['none', [own], [own, first]],
  ['selfMade', [own, 'http://169.254.7.1:4173'], []],
  ['found', [own, first], []],
  ['found', [own, first, second], [own, first]],
  ['changed', [own, second], [own, first]],
])('the address is %s with %j after %j', (verdict, now, before) =>
  expect(examineAddress(now, before).verdict).toBe(`address.${verdict}`),
)

test('a firewall is in the way only until another device has been there', () => {
  const here = { platform: 'linux', port: 4173, ufw: 'ENABLED=yes\n', reachedAt: null } as const
  expect(examineFirewall(here)).toMatchObject({ verdict: 'firewall.ufw', fine: false })
  expect(examineFirewall({ ...here, reachedAt: Date.UTC(2026, 10, 24) })).toMatchObject({
    facts: { day: '2026-11-24' },
  })
  expect(examineFirewall({ ...here, ufw: 'ENABLED=no\n' }).verdict).toBe('firewall.unknown')
  expect(examineFirewall({ ...here, ufw: null, platform: 'win32' }).verdict).toBe('firewall.windows')
})

test('a server that waits for an answer about its clock gives both dates', async () => {
  const dates = { today: '2027-09-25', last: '2026-11-29' }
  const answered = async (clock?: object | null) => {
    const server = await listening(JSON.stringify({ firstTeacher: null, clock }), '127.0.0.1')
    const finding = await examineDoubt(server.port, '127.0.0.1')
    server.close()
    return finding
  }
  const facts = { now: '2027-09-25', last: '2026-11-29' }
  expect(await answered({ ...dates, denied: false })).toEqual({
    verdict: 'clock.doubted',
    fine: false,
    facts,
  })
  expect(await answered({ ...dates, denied: true })).toMatchObject({ verdict: 'clock.denied' })
  // A clock that was never set is found out by the age of files; an earlier version sends nothing.
  for (const clock of [{ ...dates, last: null, denied: false }, null, undefined])
    expect(await answered(clock)).toBeNull()
})

test('a clock in 1970, or before what was written already, is wrong', () => {
  const now = Date.UTC(2026, 10, 24)
  expect(examineClock(0, []).verdict).toBe('clock.behind')
  expect(examineClock(now, [now + 3 * 86_400_000])).toMatchObject({
    verdict: 'clock.behind',
    facts: { latest: '2026-11-27' },
  })
  expect(examineClock(now, [now - 1000]).verdict).toBe('clock.fine')
})

test.each([
  [49, 'full'],
  [499, 'low'],
  [500, 'fine'],
])('with %d MB the disk is %s', (free, verdict) =>
  expect(examineDisk(join(folder, 'not', 'there'), () => free).verdict).toBe(`disk.${verdict}`),
)

test.each([
  ['none', { exists: true, nights: [] }],
  ['noData', { exists: false, nights: [] }],
  ['made', { exists: true, nights: ['2026-11-19', '2026-11-20'] }],
  ['old', { exists: true, nights: ['2026-11-19'] }],
  ['made', { exists: true, nights: ['2027-11-19', '2026-11-26'] }],
  ['ahead', { exists: true, nights: ['2026-11-20', '2027-11-19'] }],
  ['made', { exists: true, nights: ['2026-11-20'], others: { byAge: [], broken: [] } }],
  ['withCopies', { exists: true, nights: ['2026-11-20'], others: { byAge: ['a'], broken: [] } }],
  ['withBroken', { exists: true, nights: ['2026-11-20'], others: { byAge: ['a'], broken: ['b'] } }],
  ['old', { exists: true, nights: ['2026-11-19'], others: { byAge: [], broken: ['b'] } }],
])('the backup is %s with %j on 25 November', (verdict, saved) =>
  expect(examineBackup(saved, Date.UTC(2026, 10, 25)).verdict).toBe(`backup.${verdict}`),
)

test('copies that are no nightly ones are named, a database with its journals once', () => {
  const byAge = [
    'botgarten.db.before-restore-1',
    'botgarten.db.before-restore-1-wal',
    'backups/before-migration.age',
  ]
  const saved = { exists: true, nights: ['2026-11-20'], others: { byAge, broken: [] } }
  expect(examineBackup(saved, Date.UTC(2026, 10, 25)).facts['names']).toBe(
    'botgarten.db.before-restore-1, backups/before-migration.age',
  )
})

test('memory above what a class takes, and the ninth device in the hot spot of a Raspberry Pi, are named', () => {
  expect([190e6, 250e6].map((bytes) => examineMemory(bytes).verdict)).toEqual(['memory.fine', 'memory.high'])
  expect([8, 9].map((devices) => examineHotSpot('Botgarten', devices).verdict)).toEqual([
    'hotspot.fine',
    'hotspot.crowded',
  ])
})

test('a running server says all of it but its port, and whether it answers https', () => {
  const addresses = [own, first]
  const running = {
    ...{ folder, addresses, before: addresses, otherDevice: null, devices: 0, streams: 0 },
    ...{ memory: 90e6, ownTools: false, version: '0.1.0', now: Date.now(), hotSpot: null },
  }
  const verdicts = (more: object) => examineRunning({ ...running, ...more }).map(({ verdict }) => verdict)
  const about = (some: readonly string[]) => some.map((verdict) => verdict.split('.')[0])
  expect(about(verdicts({}))).toEqual([
    ...['address', 'firewall', 'clients', 'https', 'memory', 'disk', 'clock', 'backup', 'folder', 'version'],
  ])
  expect(verdicts({})).toContain('https.off')
  const secure = verdicts({ addresses: [own, 'https://192.168.0.5:4174', first], hotSpot: 'Botgarten' })
  expect(secure).toEqual(expect.arrayContaining(['address.found', 'https.on', 'hotspot.fine']))
})

test('a folder with blanks and umlauts is a place for data, and looking makes nothing', () => {
  expect(examineDisk(folder).facts['free']).toBeGreaterThan(0)
  expect(examineFolder(join(folder, 'Klasse 5b', 'Übung')).verdict).toBe('folder.new')
  expect(examineFolder(folder).verdict).toBe('folder.ready')
  expect(readdirSync(folder)).toEqual([])
})

test('a server runs in a folder with blanks and umlauts, and is found there', async () => {
  const data = join(folder, 'Übung 5b')
  const server = await openClassServer({ data })
  expect(examineFolder(data).verdict).toBe('folder.inUse')
  await server.close()
  expect(examineFolder(data).verdict).toBe('folder.ready')
})

test('folders that are no place for a database are named', () => {
  writeFileSync(join(folder, 'file'), 'x')
  expect(examineFolder(join(folder, 'file')).verdict).toBe('folder.isFile')
  expect(examineFolder(join(folder, 'Dropbox', 'data'))).toMatchObject({
    verdict: 'folder.synced',
    facts: { by: 'Dropbox' },
  })
  writeFileSync(join(folder, 'botgarten.db.broken-1'), 'x')
  expect(examineFolder(folder)).toMatchObject({
    verdict: 'folder.broken',
    facts: { path: join(folder, 'botgarten.db.broken-1') },
  })
})

/** Root may write everywhere: for a moment this process is somebody else. */
function asNobody<Result>(act: () => Result): Result {
  if (process.geteuid?.() !== 0) return act()
  process.seteuid!(65_534)
  try {
    return act()
  } finally {
    process.seteuid!(0)
  }
}

test('a folder that may only be read is refused with the reason', () => {
  const locked = join(folder, 'locked')
  mkdirSync(locked)
  chmodSync(folder, 0o755)
  chmodSync(locked, 0o555)
  expect(asNobody(() => examineFolder(join(locked, 'data')))).toMatchObject({
    verdict: 'folder.readOnly',
    facts: { path: locked, why: 'EACCES' },
  })
  expect(existsSync(join(locked, 'data'))).toBe(false)
})
