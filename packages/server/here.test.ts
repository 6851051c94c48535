import { expect, test } from 'vitest'
import { isHere } from './here.ts'

const asked = (remoteAddress: string, host: string, more: { readonly [name: string]: string } = {}) =>
  isHere({ headers: { host, ...more }, socket: { remoteAddress } } as unknown as Parameters<typeof isHere>[0])

test.each([
  ['127.0.0.1', 'localhost:4173'],
  ['::ffff:127.0.0.1', '127.0.0.1:4173'],
  ['::1', '[::1]:4173'],
])('%s under %s is the machine itself', (address, host) => expect(asked(address, host)).toBe(true))

test.each([
  ['another device', '192.168.0.9', 'localhost:4173'],
  ['the machine under its address in the network', '192.168.0.5', '192.168.0.5:4173'],
  ['a name of somebody else that leads here', '127.0.0.1', 'example.org:4173'],
  ['a name that only begins like ours', '127.0.0.1', 'localhost.example.org'],
])('%s is not', (_who, address, host) => expect(asked(address, host)).toBe(false))

test.each(['x-forwarded-for', 'forwarded'])('who comes through a proxy is not: %s', (name) =>
  expect(asked('127.0.0.1', 'localhost:4173', { [name]: '192.168.0.9' })).toBe(false),
)
