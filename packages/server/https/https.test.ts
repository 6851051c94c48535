import { X509Certificate } from 'node:crypto'
import { once } from 'node:events'
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { connect, createServer } from 'node:tls'
import { afterEach, beforeEach, expect, test } from 'vitest'
import { newAuthority, newLeaf, type Pair } from './certificates.ts'
import { isPrivate } from './constraints.ts'
import { privateAddresses } from '../addresses.ts'
import { timeAtLeast } from '../doctor/old-files.ts'
import { certificatesIn } from './key-folder.ts'

let folder: string
beforeEach(() => void (folder = mkdtempSync(join(tmpdir(), 'botgarten-https-'))))
afterEach(() => rmSync(folder, { recursive: true, force: true }))

const now = Date.now()
const day = 86_400_000
const names = ['botgarten.local', '192.168.1.5']

/** What a device that trusts the authority says of a server that calls itself so: 'trusted', or why not. */
async function verdict(authority: string, { certificate, key }: Pair, servername: string): Promise<string> {
  const server = createServer({ cert: certificate, key }).listen(0, '127.0.0.1')
  server.on('tlsClientError', () => {})
  await once(server, 'listening')
  const { port } = server.address() as AddressInfo
  const socket = connect({ host: '127.0.0.1', port, servername, ca: authority })
  try {
    await once(socket, 'secureConnect')
    return 'trusted'
  } catch (error) {
    return (error as Error).message
  } finally {
    socket.destroy()
    server.close()
  }
}

test('a device that trusts the authority trusts the server under the name of the room', async () => {
  const { authority, ...leaf } = await certificatesIn(folder, names, now)
  expect(await verdict(authority, leaf, 'botgarten.local')).toBe('trusted')
})

test('the key of the authority is worth nothing for any other site', async () => {
  const authority = await newAuthority(now)
  const forged = await newLeaf(authority, ['example.org'], now)
  expect(await verdict(authority.certificate, forged, 'example.org')).toBe('permitted subtree violation')
})

test('the authority is made once; another address gets another certificate of it', async () => {
  const first = await certificatesIn(folder, names, now)
  expect(await certificatesIn(folder, names, now)).toEqual(first)
  const moved = await certificatesIn(folder, ['botgarten.local', '10.42.0.1'], now)
  expect(moved.authority).toBe(first.authority)
  expect(new X509Certificate(moved.certificate).checkIP('10.42.0.1')).toBe('10.42.0.1')
})

test('a certificate lasts 90 days and is made anew before; the authority lasts two years', async () => {
  const first = await certificatesIn(folder, names, now)
  const later = await certificatesIn(folder, names, now + 61 * day)
  expect(later.certificate).not.toBe(first.certificate)
  expect(later.authority).toBe(first.authority)
  const last = await certificatesIn(folder, names, now + 701 * day)
  expect(last.authority).not.toBe(first.authority)
})

test('a clock in 1970 makes certificates for a time after the product was made, and keeps them when it is set', async () => {
  const first = await certificatesIn(folder, names, timeAtLeast(folder, 0))
  expect(Date.parse(new X509Certificate(first.authority).validFrom)).toBeGreaterThan(Date.UTC(2025, 11, 1))
  const set = await certificatesIn(folder, names, timeAtLeast(folder, now))
  expect(set.authority).toBe(first.authority)
})

test('keys are readable by their owner alone', async () => {
  await certificatesIn(folder, names, now)
  for (const name of ['authority', 'server'])
    expect(statSync(join(folder, 'https', `${name}.key`)).mode & 0o777).toBe(0o600)
  expect(readFileSync(join(folder, 'https', 'authority.key'), 'utf8')).toContain('PRIVATE KEY')
})

test('only private addresses are vouched for', () => {
  const private4 = ['10.0.0.1', '172.16.0.1', '172.31.255.254', '192.168.178.20']
  expect(private4.filter(isPrivate)).toEqual(private4)
  expect(
    ['172.15.0.1', '172.32.0.1', '192.0.2.2', '127.0.0.1', '8.8.8.8', 'fd00::2'].filter(isPrivate),
  ).toEqual([])
  const info = { netmask: '', mac: '', internal: false, cidr: null, family: 'IPv4' as const }
  const interfaces = {
    eth: [
      { ...info, address: '192.168.1.5' },
      { ...info, address: '192.0.2.2' },
    ],
  }
  expect(privateAddresses(interfaces)).toEqual(['192.168.1.5'])
})
