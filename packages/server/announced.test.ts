import { expect, test } from 'vitest'
import { announcedTo } from './announced.ts'

const room = {
  publicAddress: null,
  proxied: false,
  addresses: () => [
    ...['http://localhost:4173', 'http://[2001:db8::7]:4173'],
    ...['http://192.168.0.5:4173', 'http://10.42.0.1:4173'],
  ],
}

test('of two networks each device is told the address that it has reached', () => {
  expect(announcedTo('192.168.0.5', room)).toBe('http://192.168.0.5:4173')
  expect(announcedTo('10.42.0.1', room)).toBe('http://10.42.0.1:4173')
})

test('the machine itself is told the first of a private network, and so is who came by IPv6', () => {
  for (const reached of ['127.0.0.1', '::1', '2001:db8::7', null])
    expect(announcedTo(reached, room)).toBe('http://192.168.0.5:4173')
})

test('https comes before http at the same address', () => {
  const addresses = () => [
    ...['http://localhost:4173', 'https://192.168.0.5:4174'],
    ...['http://192.168.0.5:4173', 'http://141.20.5.9:4173'],
  ]
  expect(announcedTo('192.168.0.5', { ...room, addresses })).toBe('https://192.168.0.5:4174')
})

test('a public address is the one for all; behind a proxy without it none is known, as in no network', () => {
  const publicAddress = 'https://lab.example.org'
  expect(announcedTo('192.168.0.5', { ...room, publicAddress })).toBe(publicAddress)
  expect(announcedTo(null, { ...room, proxied: true })).toBeNull()
  expect(announcedTo(null, { ...room, addresses: () => ['http://localhost:4173'] })).toBeNull()
})
