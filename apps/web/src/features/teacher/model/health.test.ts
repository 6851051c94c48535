import { expect, test } from 'vitest'
import { healthOf } from './health.ts'

const now = Date.UTC(2026, 10, 24, 9)
const health = {
  ...{ now, secure: false, database: 'sqlite', memory: 96e6, freeSpace: 11.4e9 },
  ...{ addresses: ['http://localhost:4173', 'http://192.168.0.5:4173'] },
  ...{ otherDevice: (now - 60_000) as number | null, streams: 24, version: '0.1.0' },
  backups: { count: 0, last: null as string | null },
}
const inRoom = { hostname: 'botgarten.local', origin: 'http://botgarten.local' }
const announced = 'http://botgarten.local'

const toDo = (facts: ReturnType<typeof healthOf>) => facts.filter(({ fine }) => !fine).map(({ id }) => id)

test('a backup that was never made and plain http are to do; the rest is fine', () => {
  expect(toDo(healthOf(inRoom, { secure: false, health, here: now, wifi: null, announced }, 'en'))).toEqual([
    'backup',
    'offline',
  ])
  const saved = { ...health, backups: { count: 1, last: '2026-11-24' } }
  expect(
    toDo(healthOf(inRoom, { secure: true, health: saved, here: now, wifi: null, announced }, 'en')),
  ).toEqual([])
})

test('too much memory, a full disk and a clock that is wrong are shown', () => {
  const bad = { ...health, memory: 250e6, freeSpace: 0.1e9, now: now - 300_000, backups: null }
  expect(
    toDo(healthOf(inRoom, { secure: true, health: bad, here: now, wifi: null, announced }, 'de')),
  ).toEqual(['memory', 'space', 'clock'])
})

test('until another device has reached the lab, a phone is to be tried', () => {
  const alone = { ...health, otherDevice: null, streams: 0, backups: null }
  expect(
    toDo(healthOf(inRoom, { secure: true, health: alone, here: now, wifi: null, announced }, 'en')),
  ).toEqual(['clients'])
})

test('the address says in which Wi-Fi it is reached, where that was named', () => {
  const [address] = healthOf(inRoom, { secure: true, health, here: now, wifi: 'Aula', announced }, 'en')
  expect(address).toMatchObject({ value: 'botgarten.local', text: 'Wi-Fi “Aula”' })
})

test('before somebody is signed in only the page is known', () => {
  const facts = healthOf(inRoom, { secure: true, health: null, here: now, wifi: null, announced }, 'en')
  expect(facts.map(({ id }) => id)).toEqual(['address', 'offline'])
})
