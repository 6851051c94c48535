import { expect, test } from 'vitest'
import { addresses, listenedAt } from './addresses.ts'

const at = (address: string, family: 'IPv4' | 'IPv6', internal = false) => ({
  ...{ address, internal, mac: '00:00:00:00:00:00', netmask: '', cidr: null },
  ...(family === 'IPv6' ? { family, scopeid: 0 } : { family }),
})

test('this machine comes first, then every address of the network, IPv6 in brackets', () => {
  const found = addresses(4173, {
    lo: [at('127.0.0.1', 'IPv4', true), at('::1', 'IPv6', true)],
    eth0: [at('192.0.2.7', 'IPv4'), at('2001:db8::7', 'IPv6')],
    wlan0: [at('198.51.100.9', 'IPv4')],
  })
  expect(found).toEqual([
    'http://localhost:4173',
    'http://192.0.2.7:4173',
    'http://[2001:db8::7]:4173',
    'http://198.51.100.9:4173',
  ])
})

test('a server that listens at one address alone has no other', () => {
  const all = { lo: [at('127.0.0.1', 'IPv4', true)], eth0: [at('192.0.2.7', 'IPv4')] }
  const of = (host?: string) => addresses(80, listenedAt(all, host))
  expect(of('127.0.0.1')).toEqual(['http://localhost:80'])
  for (const host of ['192.0.2.7', '0.0.0.0', 'lab.example.org', undefined])
    expect(of(host)).toEqual(['http://localhost:80', 'http://192.0.2.7:80'])
})

test('link-local IPv6 is left out: a browser takes no zone', () => {
  expect(addresses(80, { eth0: [at('fe80::1', 'IPv6')], gone: undefined })).toEqual(['http://localhost:80'])
})
